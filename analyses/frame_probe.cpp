// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/frame_probe.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "analyses/free_memory.hpp"
#include "readers/frame_index.hpp"
#include "readers/input_error.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

using Clock = std::chrono::steady_clock;

/// Seconds since it was made.
class Watch {
 public:
  double wall() const { return std::chrono::duration<double>(Clock::now() - wall_).count(); }
  double processor() const { return processor_seconds() - processor_; }

 private:
  Clock::time_point wall_ = Clock::now();
  double processor_ = processor_seconds();
};

constexpr double long_enough = 0.03;  ///< seconds; what takes less is timed again
constexpr int most_repetitions = 4;
constexpr double patience = 3;  ///< how much longer than its processor time counting may take

/// Chunks that are kept, again and again.
class KeptChunks final : public ChunkSupply {
 public:
  explicit KeptChunks(const std::vector<Chunk>& chunks) : chunks_(chunks) {}
  const Chunk* cut(Chunk&) override { return next_ < chunks_.size() ? &chunks_[next_++] : nullptr; }
  void restart() override { next_ = 0; }

 private:
  const std::vector<Chunk>& chunks_;
  std::size_t next_ = 0;
};

/// What the part of the file that was passed over tells of the rest.
void extrapolate(FrameCount& count, double share) {
  if (!(share > 0)) {
    count.source = fmt::format("at least {}", count.met);
    return;
  }
  count.frames = std::max(count.met, static_cast<std::uint64_t>(std::llround(static_cast<double>(count.met) / share)));
  count.source = fmt::format("from the size of the first {}", count.met);
}

}  // namespace

double processor_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

FrameCount count_quickly(const std::filesystem::path& dump, double most_seconds) {
  const auto index = load_frame_index(dump);
  const auto source = open_trajectory(dump, {});
  FrameCount count;
  FrameHeader header;
  const Watch watch;
  double first = 0, share = 0;
  bool more = source->next(header);
  if (!more) throw InputError(fmt::format("{}: no frame in the file", dump.string()));
  first = source->share().value_or(0);
  try {
    while (more && (count.met == 0 || (!index && watch.processor() < most_seconds && watch.wall() < patience * most_seconds))) {
      more = source->next(header);
      ++count.met;
      share = source->share().value_or(0) - first;
    }
  } catch (const InputError&) {  // the analyses tell of it
    more = false;
  }
  count.seconds = watch.processor() / static_cast<double>(count.met);
  count.counted = index || !more;
  count.frames = index ? index->frames.size() : count.met;
  count.source = index ? "by the index of frames" : "counted";
  if (!count.counted) extrapolate(count, share);
  return count;
}

FrameProbe::FrameProbe(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
                       const SweepOptions& options, const ColumnSet& columns, std::span<const std::uint64_t> numbers,
                       std::uint64_t most_atoms)
    : bodies_(bodies), masses_(masses), options_(options) {
  ColumnSet wanted = columns;
  wanted.add(bodies.columns());
  wanted.add(masses.columns());
  if (options.selection) wanted.select(*options.selection);
  source_ = open_trajectory(dump, wanted);
  FrameHeader header;
  for (const std::uint64_t number : numbers) {
    source_->seek(number);
    bool there = true;
    do there = source_->next(header);
    while (there && header.index < number);
    if (!there) break;
    keep(header, most_atoms);
  }
}

void FrameProbe::keep(const FrameHeader& header, std::uint64_t most_atoms) {
  Frame frame{header, header.atoms, {}};
  const std::uint64_t every = (header.atoms + most_atoms - 1) / most_atoms;
  frame.header.atoms = 0;
  Chunk chunk;
  for (std::uint64_t k = 0; source_->cut(chunk); ++k) {
    if (k % std::max<std::uint64_t>(every, 1) == 0) {
      frame.header.atoms += chunk.atoms;
      frame.chunks.push_back(std::move(chunk));
    }
    chunk = {};
  }
  frames_.push_back(std::move(frame));
}

std::uint64_t FrameProbe::atoms() const {
  std::uint64_t kept = 0;
  for (const Frame& frame : frames_) kept += frame.header.atoms;
  return kept;
}

double FrameProbe::share() const {
  std::uint64_t all = 0;
  for (const Frame& frame : frames_) all += frame.atoms;
  return static_cast<double>(atoms()) / static_cast<double>(all);
}

double FrameProbe::seconds(std::span<const std::unique_ptr<Analysis>> analyses, bool moved) const {
  FramePlan plan(bodies_, masses_, analyses, options_.selection);
  plan.memory = options_.memory;
  plan.frame_memory = options_.frame_memory.value_or(free_memory() / 2);
  if (moved) plan.last_digit_seed = 1;
  plan.stop = options_.stop;
  double least = once(plan);
  for (int k = 1; k < most_repetitions && least < long_enough; ++k) least = std::min(least, once(plan));
  return least / (share() * static_cast<double>(frames()));
}

/// Small frames are shared by threads: each is on one.
double FrameProbe::once(const FramePlan& plan) const {
  double seconds = 0;
  for (const Frame& frame : frames_) {
    const auto positions = position_source(frame.header.columns);
    std::optional<Unwrapping> unwrapping;
    if (positions && positions->may_jump(frame.header.box)) unwrapping.emplace();
    const bool small = frame.atoms <= AtomBlock::capacity && !unwrapping;
    FrameRun run(plan, small ? 1 : options_.threads);
    KeptChunks chunks(frame.chunks);
    const Watch watch;
    run.run(frame.header, chunks, unwrapping ? &*unwrapping : nullptr);
    seconds += watch.processor();
  }
  return seconds;
}

}  // namespace mdana
