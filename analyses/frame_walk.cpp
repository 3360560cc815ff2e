// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/frame_walk.hpp"

#include <fmt/format.h>

#include "analyses/block_pipeline.hpp"
#include "readers/input_error.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

/// Chunks straight from the file.
class FileChunks final : public ChunkSupply {
 public:
  explicit FileChunks(FrameSource& source) : source_(source) {}
  const Chunk* cut(Chunk& place) override { return source_.cut(place) ? &place : nullptr; }
  void restart() override { source_.restart_frame(); }

 private:
  FrameSource& source_;
};

/// The only chunk of a small frame.
class SmallFrame final : public ChunkSupply {
 public:
  bool read(FrameSource& source) {
    given_ = !source.cut(chunk_);
    return !given_;
  }
  const Chunk* cut(Chunk&) override {
    if (given_) return nullptr;
    given_ = true;
    return &chunk_;
  }
  void restart() override { given_ = false; }

 private:
  Chunk chunk_;
  bool given_ = true;
};

}  // namespace

/// A small frame under way, all of it on one thread.
struct FrameWalk::Small {
  FrameHeader header;
  std::optional<double> share;
  SmallFrame chunks;
  std::optional<FrameRun> run;
  FrameOutcome outcome;
};

FrameWalk::FrameWalk(const std::filesystem::path& dump, const FramePlan& plan, const SweepOptions& options)
    : path_(dump.string()),
      plan_(plan),
      options_(options),
      source_(open_trajectory(dump, plan.wanted)),
      chosen_(*source_, options),
      whole_(plan, options.threads),
      small_(options.threads <= 1 ? 1 : 4 * options.threads) {
  for (Small& small : small_) small.run.emplace(plan, 1);
}

FrameWalk::~FrameWalk() = default;

bool FrameWalk::go_to(std::uint64_t place) {
  if (there_ && place == place_) return true;
  there_ = false;
  place_ = place;
  if (!chosen_.at(place, header_)) return false;
  share_ = source_->share();
  const auto positions = plan_.wanted.has("x") ? position_source(header_.columns) : std::nullopt;
  if (positions && positions->may_jump(header_.box) && !unwrapping_) unwrapping_.emplace();
  small_next_ = header_.atoms <= AtomBlock::capacity && !unwrapping_;
  there_ = true;
  return true;
}

void FrameWalk::next() {
  there_ = false;
  if (place_ + 1 < end_) go_to(place_ + 1);
}

void FrameWalk::run(std::uint64_t end, const Take& take) {
  end_ = end;
  while (there_ && place_ < end_) small_next_ ? small_frames(take) : whole_frame(take);
}

void FrameWalk::whole_frame(const Take& take) {
  FileChunks chunks(*source_);
  take(header_, located(header_, [&] { return whole_.run(header_, chunks, unwrapping()); }), share_);
  next();
}

FrameOutcome FrameWalk::run_on_ranks() {
  there_ = false;
  FileChunks chunks(*source_);
  return located(header_, [&] { return whole_.run_on_ranks(header_, chunks, unwrapping()); });
}

void FrameWalk::follow() {
  there_ = false;
  FileChunks chunks(*source_);
  if (unwrapping_) located(header_, [&] { return whole_.follow(header_, chunks, *unwrapping_), FrameOutcome{}; });
}

void FrameWalk::pass_rest() try {
  there_ = false;
  while (source_->next(header_)) {
  }
} catch (const InputError&) {  // behind all frames that are used
}

/// Small frames, shared by the threads, until the end or a frame that is not small.
void FrameWalk::small_frames(const Take& take) {
  std::exception_ptr ended_by;  // behind frames that are whole
  BlockPipeline pipeline;
  pipeline.threads = options_.threads;
  pipeline.slots = small_.size();
  pipeline.produce = [&](std::size_t slot) { return read(small_[slot], ended_by); };
  pipeline.work = [&](std::size_t slot) {
    Small& small = small_[slot];
    small.outcome = located(small.header,
                            [&] { return small.run->run(small.header, small.chunks, nullptr); });
  };
  pipeline.collect = [&](std::size_t slot) {
    take(small_[slot].header, std::move(small_[slot].outcome), small_[slot].share);
  };
  mdana::run(pipeline);
  if (ended_by) std::rethrow_exception(ended_by);
}

/// Takes the frame of now and moves to the one behind it. False if there is none to take.
bool FrameWalk::read(Small& small, std::exception_ptr& ended_by) {
  if (!there_ || !small_next_) return false;
  bool taken = false;
  try {
    small.header = header_;
    small.share = share_;
    small.chunks.read(*source_);
    taken = true;
    next();
  } catch (...) {
    ended_by = std::current_exception();
    there_ = false;
  }
  return taken;
}

/// What an analysis finds wrong with the frame, told with the frame's place.
template <class Work>
FrameOutcome FrameWalk::located(const FrameHeader& header, Work&& work) const {
  try {
    return work();
  } catch (const TruncatedInput&) {
    throw;
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.starts_with(path_.substr(0, path_.find_first_of("*%")))) throw;  // a reader's own
    throw InputError(fmt::format("{}: {}", header.place, what));
  }
}

}  // namespace mdana
