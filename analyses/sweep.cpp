// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "analyses/block_pipeline.hpp"
#include "analyses/merge_tree.hpp"
#include "analyses/motion.hpp"
#include "readers/column_choice.hpp"
#include "readers/input_error.hpp"
#include "readers/last_digit.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

/// The analyses of one round of a frame, and where their rows go.
struct Round {
  std::vector<std::size_t> members;
  std::vector<MergeTree> trees;
};

/// A block under way.
struct Place {
  Chunk chunk;
  AtomBlock block;
  std::vector<BodyIndex> body;
  std::vector<double> mass;
  std::vector<std::unique_ptr<Partial>> partials;  ///< of a round's members
};

class Sweep {
 public:
  Sweep(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
        std::span<const std::unique_ptr<Analysis>> analyses, const SweepOptions& options)
      : path_(dump.string()),
        bodies_(bodies),
        masses_(masses),
        analyses_(analyses),
        options_(options),
        places_(options.threads <= 1 ? 1 : 2 * options.threads) {
    if (options.stride == 0) throw std::invalid_argument("sweep: the stride must be at least 1");
    for (const auto& analysis : analyses) {
      needs_.push_back(analysis->needs());
      wanted_.add(needs_.back().columns);
      result_.tables.emplace_back(analysis->columns());
    }
    wanted_.add(bodies.columns());
    wanted_.add(masses.columns());
    source_ = open_trajectory(dump, wanted_);
  }

  SweepResult run() {
    const auto start = std::chrono::steady_clock::now();
    try {
      while (!enough() && source_->next(header_))
        if (header_.index % options_.stride == 0) located_frame();
    } catch (const InputError& error) {
      if (result_.steps.empty()) throw;
      result_.damage = error.what();
    }
    if (result_.steps.empty()) throw InputError(path_ + ": no frame in the file");
    if (!enough()) result_.inputs = source_->records();
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result_);
  }

 private:
  /// What an analysis finds wrong with the frame, told with the frame's place.
  void located_frame() {
    try {
      frame();
    } catch (const TruncatedInput&) {
      throw;
    } catch (const InputError& error) {
      const std::string what = error.what();
      if (what.starts_with(path_.substr(0, path_.find_first_of("*%")))) throw;  // a reader's own
      throw InputError(fmt::format("{}: {}", header_.place, what));
    }
  }

  void frame() {
    check_header();
    rows_.clear();
    for (const Table& table : result_.tables) rows_.emplace_back(table.columns().size());
    kept_.clear();
    kept_bytes_ = 0;
    keep_ = needs_second_round();
    std::vector<BodyMotion> motion;
    round(false, motion);
    if (needs_second_round()) {
      Table row(result_.tables[0].columns());
      row.add_row(rows_[0]);
      const auto both = body_motion(row, 0);
      motion.assign(both.begin(), both.end());
      round(true, motion);
    }
    for (std::size_t k = 0; k < analyses_.size(); ++k) result_.tables[k].add_row(rows_[k]);
    result_.steps.push_back(header_.step);
    if (header_.time) result_.stated_times.push_back(*header_.time);
    if (options_.progress) options_.progress(result_.steps.size());
  }

  void check_header() {
    if (!result_.steps.empty() && header_.step <= result_.steps.back())
      throw InputError(fmt::format("{}: the step does not come after that of the frame before ({})",
                                   header_.place, result_.steps.back()));
    if (header_.time.has_value() != (result_.stated_times.size() == result_.steps.size()) &&
        !result_.steps.empty())
      throw InputError(fmt::format("{}: some frames state their time and some do not",
                                   header_.place));
    if (header_.units && !units_) units_ = header_.units;  // LAMMPS states them once a file
    if (header_.units && header_.units != units_)
      throw InputError(fmt::format("{}: the units differ from those of an earlier frame",
                                   header_.place));
    if (result_.steps.empty()) note_columns();
    const auto positions = position_source(header_.columns);
    if (positions && positions->may_jump(header_.box)) result_.positions_may_jump = true;
  }

  void note_columns() {
    result_.columns_read.clear();
    result_.columns_not_read = header_.columns;
    const ColumnChoice choice(header_, wanted_);
    for (const auto& column : choice.columns()) {
      result_.columns_read.push_back(column.name);
      std::erase(result_.columns_not_read, column.name);
    }
  }

  bool enough() const { return options_.frames && result_.steps.size() >= *options_.frames; }

  bool needs_second_round() const {
    return std::any_of(needs_.begin(), needs_.end(), [](const Needs& n) { return n.after_motion; });
  }

  /// Gives the frame's blocks to the analyses of one round and closes their rows.
  void round(bool second, std::span<const BodyMotion> motion) {
    Round members;
    for (std::size_t k = 0; k < needs_.size(); ++k)
      if (needs_[k].after_motion == second) members.members.push_back(k);
    members.trees.resize(members.members.size());
    run_blocks(second, {header_, motion}, members);
    for (std::size_t i = 0; i < members.members.size(); ++i) {
      const auto whole = members.trees[i].finish();
      if (!whole) throw InputError(fmt::format("{}: a frame without atoms", header_.place));
      whole->close(rows_[members.members[i]]);
    }
  }

  /// Blocks of the frame, from the file or those kept in the first round, through the pipeline.
  void run_blocks(bool again, const FrameContext& context, Round& members) {
    const bool kept = again && keep_;
    if (again && !kept) source_->restart_frame();
    std::size_t next = 0;
    BlockPipeline pipeline;
    pipeline.threads = options_.threads;
    pipeline.slots = places_.size();
    pipeline.produce = [&](std::size_t slot) {
      if (!kept) return source_->cut(places_[slot].chunk);
      if (next == kept_.size()) return false;
      std::swap(places_[slot].block, kept_[next++]);
      return true;
    };
    pipeline.work = [&](std::size_t slot) {
      if (!kept) convert(places_[slot]);
      analyse(places_[slot], context, members);
    };
    pipeline.collect = [&](std::size_t slot) { collect(places_[slot], again, members); };
    mdana::run(pipeline);
  }

  void convert(Place& place) const {
    mdana::convert(place.chunk, place.block);
    if (options_.last_digit_seed)
      move_last_digits(place.chunk, header_, wanted_, *options_.last_digit_seed,
                       place.block);
  }

  void analyse(Place& place, const FrameContext& context, const Round& members) const {
    bodies_.label(place.block, place.body);
    masses_.fill(place.block, place.mass);
    const LabelledBlock labelled{place.block, place.body, place.mass};
    place.partials.clear();
    for (const std::size_t k : members.members) {
      place.partials.push_back(analyses_[k]->begin(context));
      place.partials.back()->add(labelled);
    }
  }

  void collect(Place& place, bool again, Round& members) {
    for (std::size_t i = 0; i < place.partials.size(); ++i)
      members.trees[i].push(std::move(place.partials[i]));
    if (options_.stop && *options_.stop) throw Interrupted(*options_.stop);
    if (again || !keep_) return;
    kept_bytes_ += place.block.bytes();
    keep_ = kept_bytes_ <= options_.memory;
    if (keep_)
      kept_.push_back(std::exchange(place.block, {}));
    else
      kept_.clear();
  }

  std::string path_;
  const Bodies& bodies_;
  const Masses& masses_;
  std::span<const std::unique_ptr<Analysis>> analyses_;
  const SweepOptions& options_;
  std::vector<Needs> needs_;
  ColumnSet wanted_;
  std::unique_ptr<FrameSource> source_;
  SweepResult result_;

  FrameHeader header_;
  std::optional<Units> units_;  ///< as an earlier frame states them
  std::vector<Place> places_;
  std::vector<std::vector<double>> rows_;
  bool keep_ = false;  ///< the whole frame is in kept_
  std::size_t kept_bytes_ = 0;
  std::vector<AtomBlock> kept_;
};

}  // namespace

SweepResult sweep(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
                  std::span<const std::unique_ptr<Analysis>> analyses,
                  const SweepOptions& options) {
  return Sweep(dump, bodies, masses, analyses, options).run();
}

}  // namespace mdana
