// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/check.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "analyses/block_pipeline.hpp"
#include "analyses/check_headers.hpp"
#include "analyses/check_ids.hpp"
#include "analyses/check_values.hpp"
#include "analyses/sweep.hpp"
#include "readers/input_error.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

FaultKind kind_of(const InputError& error) {
  if (dynamic_cast<const WrongAtomCount*>(&error)) return FaultKind::atom_count;
  if (dynamic_cast<const TruncatedInput*>(&error)) return FaultKind::truncated;
  return FaultKind::header;
}

/// A block under way.
struct Place {
  explicit Place(std::size_t limit) : faults(limit) {}

  Chunk chunk;
  AtomBlock block;
  BlockFaults faults;
  ColumnFaults of_columns;
};

class Check {
 public:
  Check(const std::filesystem::path& dump, const CheckOptions& options)
      : dump_(dump.string()),
        options_(options),
        source_(open_trajectory(dump, ColumnSet::all_as_they_stand())),
        places_(options.threads <= 1 ? 1 : 2 * options.threads, Place(options.limit)),
        headers_(dump_),
        ids_(options.memory, dump_) {
    result_.faults = Faults(options.limit);
    source_->expect_faults();
  }

  CheckResult run() {
    const auto start = std::chrono::steady_clock::now();
    while (frame() == Next::frame) continue;
    of_columns_.tell(result_.faults);
    result_.ids_compared = ids_.compared();
    result_.inputs = source_->records();
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result_);
  }

 private:
  enum class Next { frame, nothing };

  Next frame() {
    try {
      if (!source_->next(header_)) {
        result_.to_the_end = true;
        return Next::nothing;
      }
    } catch (const InputError& error) {
      return go_on_after_header(error);
    }
    next_frame_ = header_.index + 1;
    headers_.add(header_, result_.faults);
    note_columns();
    return atoms();
  }

  void note_columns() {
    for (const std::string& column : header_.columns)
      if (std::ranges::find(result_.columns, column) == result_.columns.end())
        result_.columns.push_back(column);
    has_ids_ = header_.has_column("id");
  }

  /// All atoms of the frame that are there.
  Next atoms() {
    failed_.reset();
    if (has_ids_) ids_.begin();
    run_blocks();
    if (has_ids_) ids_.end(header_, !failed_, result_.faults);
    if (!failed_) headers_.add_atoms(header_, result_.faults);
    ++result_.frames;
    if (options_.progress) options_.progress({result_.frames, source_->share()});
    return failed_ ? go_on_after(*failed_) : Next::frame;
  }

  void run_blocks() {
    BlockPipeline pipeline;
    pipeline.threads = options_.threads;
    pipeline.slots = places_.size();
    pipeline.produce = [&](std::size_t slot) { return cut(places_[slot].chunk); };
    pipeline.work = [&](std::size_t slot) { look(places_[slot]); };
    pipeline.collect = [&](std::size_t slot) { collect(places_[slot]); };
    mdana::run(pipeline);
  }

  /// A frame's fault waits until the blocks before it are through.
  bool cut(Chunk& chunk) {
    try {
      return source_->cut(chunk);
    } catch (const InputError& error) {
      failed_ = fault_of(error, header_.index);
      failed_->step = header_.step;
      return false;
    }
  }

  void look(Place& place) const {
    place.faults.reset();
    place.of_columns = {};
    place.chunk.layout->check(place.chunk, place.block, place.faults);
    check_values(header_, place.chunk, place.block, place.faults, place.of_columns);
  }

  void collect(Place& place) {
    if (options_.stop && *options_.stop) throw Interrupted(*options_.stop);
    if (has_ids_) ids_.add(place.chunk, place.block, place.faults);
    place.faults.faults.settle(header_.index, header_.step, dump_);
    place.of_columns.settle(header_.index, header_.step, dump_);
    result_.faults.add(place.faults.faults);
    of_columns_.add(place.of_columns);
    result_.atoms += place.chunk.atoms;
  }

  Fault fault_of(const InputError& error, std::uint64_t frame) const {
    Fault fault = located(kind_of(error), error.what(), dump_);
    fault.frame = frame;
    return fault;
  }

  /// Too many atoms are a fault of the frame before.
  Next go_on_after_header(const InputError& error) {
    if (kind_of(error) != FaultKind::atom_count)
      return go_on_after(fault_of(error, next_frame_++));
    Fault fault = fault_of(error, header_.index);
    fault.step = header_.step;
    return go_on_after(std::move(fault));
  }

  Next go_on_after(Fault fault) {
    result_.faults.add(std::move(fault));
    return source_->recover() ? Next::frame : Next::nothing;
  }

  std::string dump_;
  const CheckOptions& options_;
  std::unique_ptr<FrameSource> source_;
  CheckResult result_;
  FrameHeader header_;
  std::uint64_t next_frame_ = 0;
  bool has_ids_ = false;
  std::optional<Fault> failed_;  ///< what ended the frame too early
  std::vector<Place> places_;
  ColumnFaults of_columns_;
  HeaderCheck headers_;
  IdCheck ids_;
};

}  // namespace

CheckResult check_dump(const std::filesystem::path& dump, const CheckOptions& options) {
  return Check(dump, options).run();
}

}  // namespace mdana
