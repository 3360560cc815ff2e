// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include <fmt/format.h>

#include "analyses/block_pipeline.hpp"
#include "analyses/free_memory.hpp"
#include "readers/column_choice.hpp"
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

/// What frames of one sweep have to agree in, and the choice among them.
class FrameSequence {
 public:
  FrameSequence(FrameSource& source, const SweepOptions& options)
      : source_(source), options_(options) {}

  /// The header of the next chosen frame; false after the last.
  bool next(FrameHeader& header) {
    if (options_.frames && used_ == *options_.frames) return false;
    const auto index = options_.choice.at_or_after(seen_);
    if (!index) return false;
    source_.seek(*index);
    do {
      if (!source_.next(header)) return false;
    } while (header.index < *index);
    seen_ = header.index + 1;
    check(header);
    ++used_;
    return true;
  }

 private:
  void check(const FrameHeader& header) {
    if (step_ && header.step <= *step_)
      throw InputError(fmt::format("{}: the step does not come after that of the frame before ({})",
                                   header.place, *step_));
    if (step_ && header.time.has_value() != timed_)
      throw InputError(fmt::format("{}: some frames state their time and some do not",
                                   header.place));
    if (header.units && !units_) units_ = header.units;  // LAMMPS states them once a file
    if (header.units && header.units != units_)
      throw InputError(fmt::format("{}: the units differ from those of an earlier frame",
                                   header.place));
    step_ = header.step;
    timed_ = header.time.has_value();
  }

  FrameSource& source_;
  const SweepOptions& options_;
  std::uint64_t seen_ = 0, used_ = 0;
  std::optional<std::int64_t> step_;  ///< of the frame before
  bool timed_ = false;
  std::optional<Units> units_;  ///< as an earlier frame states them
};

class Sweep {
 public:
  Sweep(const std::filesystem::path& dump, const FramePlan& plan, const SweepOptions& options)
      : path_(dump.string()),
        plan_(plan),
        options_(options),
        source_(open_trajectory(dump, plan.wanted)),
        sequence_(*source_, options),
        whole_(plan, options.threads),
        small_(options.threads <= 1 ? 1 : 4 * options.threads) {
    for (Small& small : small_) small.run.emplace(plan, 1);
    for (const auto& analysis : plan.analyses) result_.tables.emplace_back(analysis->columns());
  }

  SweepResult run() {
    const auto start = std::chrono::steady_clock::now();
    try {
      pending_ = advance();
      while (pending_) small_next_ ? small_frames() : whole_frame();
    } catch (const InputError& error) {
      if (result_.steps.empty() || options_.strict) throw;
      result_.damage = error.what();
      if (last_count_is_doubtful()) drop_last();
    }
    give_products();
    if (result_.steps.empty()) throw InputError(path_ + ": no frame in the file, or none chosen");
    result_.unwrapped = unwrapping_.has_value();
    if (!options_.frames) result_.inputs = source_->records();
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result_);
  }

 private:
  /// A small frame under way, all of it on one thread.
  struct Small {
    FrameHeader header;
    std::optional<double> share;
    SmallFrame chunks;
    std::optional<FrameRun> run;
    FrameOutcome outcome;
  };

  /// Moves to the next chosen frame; false after the last.
  bool advance() {
    if (!sequence_.next(header_)) return false;
    share_ = source_->share();
    if (result_.columns_read.empty()) note_columns();
    const auto positions = plan_.wanted.has("x") ? position_source(header_.columns) : std::nullopt;
    if (positions && positions->may_jump(header_.box) && !unwrapping_) unwrapping_.emplace();
    small_next_ = header_.atoms <= AtomBlock::capacity && !unwrapping_;
    return true;
  }

  void note_columns() {
    result_.columns_not_read = header_.columns;
    const ColumnChoice choice(header_, plan_.wanted);
    for (const auto& column : choice.columns()) {
      result_.columns_read.push_back(column.name);
      std::erase(result_.columns_not_read, column.name);
    }
  }

  /// A frame whose blocks are shared by the threads.
  void whole_frame() {
    FileChunks chunks(*source_);
    Unwrapping* unwrapping = unwrapping_ ? &*unwrapping_ : nullptr;
    add(header_, located(header_, [&] { return whole_.run(header_, chunks, unwrapping); }), share_);
    result_.uncertain_images = std::max(result_.uncertain_images, whole_.uncertain_images());
    pending_ = advance();
  }

  /// Small frames, shared by the threads, until the end or a frame that is not small.
  void small_frames() {
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
      add(small_[slot].header, std::move(small_[slot].outcome), small_[slot].share);
    };
    mdana::run(pipeline);
    if (ended_by) std::rethrow_exception(ended_by);
  }

  /// Takes the pending frame and moves to the one behind it. False if there is none to take.
  bool read(Small& small, std::exception_ptr& ended_by) {
    if (!pending_ || !small_next_) return false;
    bool taken = false;
    try {
      small.header = header_;
      small.share = share_;
      small.chunks.read(*source_);
      taken = true;
      pending_ = advance();
    } catch (...) {
      ended_by = std::current_exception();
      pending_ = false;
    }
    return taken;
  }

  /// What an analysis finds wrong with the frame, told with the frame's place.
  template <class Work>
  FrameOutcome located(const FrameHeader& header, Work&& work) const {
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

  void add(const FrameHeader& header, FrameOutcome&& outcome, std::optional<double> share) {
    give_products();
    held_ = std::move(outcome.products);
    for (std::size_t k = 0; k < outcome.rows.size(); ++k)
      result_.tables[k].add_row(outcome.rows[k]);
    result_.steps.push_back(header.step);
    if (header.time) result_.stated_times.push_back(*header.time);
    atoms_.push_back(header.atoms);
    if (options_.progress) options_.progress({result_.steps.size(), share});
  }

  /// Of the frame before: it may have been dropped until now.
  void give_products() {
    for (const auto& product : held_) product->give();
    held_.clear();
  }

  /// Damage right behind a frame with another number of atoms than the one before it: that number may
  /// be what is wrong, and lines that belong to the frame what cannot be read.
  bool last_count_is_doubtful() const {
    const std::size_t n = atoms_.size();
    return n > 1 && atoms_[n - 1] != atoms_[n - 2];
  }

  void drop_last() {
    held_.clear();
    for (Table& table : result_.tables) table.drop_last_row();
    if (result_.stated_times.size() == result_.steps.size()) result_.stated_times.pop_back();
    result_.steps.pop_back();
    atoms_.pop_back();
  }

  std::string path_;
  const FramePlan& plan_;
  const SweepOptions& options_;
  std::unique_ptr<FrameSource> source_;
  FrameSequence sequence_;
  FrameRun whole_;
  std::vector<Small> small_;
  std::optional<Unwrapping> unwrapping_;  ///< once a frame needs it
  SweepResult result_;
  std::vector<std::uint64_t> atoms_;  ///< of the frames used, as their headers state them
  std::vector<std::unique_ptr<Product>> held_;  ///< of the last of them

  FrameHeader header_;  ///< of the pending frame, if there is one
  std::optional<double> share_;
  bool pending_ = false, small_next_ = false;
};

}  // namespace

SweepResult sweep(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
                  std::span<const std::unique_ptr<Analysis>> analyses,
                  const SweepOptions& options) {
  if (options.choice.stride == 0)
    throw std::invalid_argument("sweep: the stride must be at least 1");
  FramePlan plan(bodies, masses, analyses, options.selection);
  plan.memory = options.memory;
  plan.frame_memory = options.frame_memory.value_or(free_memory() / 2);
  plan.last_digit_seed = options.last_digit_seed;
  plan.dropped_digits = options.dropped_digits;
  plan.stop = options.stop;
  return Sweep(dump, plan, options).run();
}

}  // namespace mdana
