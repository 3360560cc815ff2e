// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/frame_run.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "analyses/block_pipeline.hpp"
#include "analyses/failure.hpp"
#include "analyses/frame_store.hpp"
#include "analyses/merge_tree.hpp"
#include "analyses/motion.hpp"
#include "analyses/parcel.hpp"
#include "analyses/stage_seconds.hpp"
#include "readers/input_error.hpp"
#include "readers/last_digit.hpp"
#include "readers/ranks.hpp"

namespace mdana {

FramePlan::FramePlan(const Bodies& of_bodies, const Masses& of_masses,
                     std::span<const std::unique_ptr<Analysis>> all,
                     const std::optional<Selection>& selection)
    : bodies(of_bodies),
      masses(of_masses),
      analyses(all),
      centres(make_box_centres(of_bodies.count())) {
  for (const auto& analysis : analyses) {
    needs.push_back(analysis->needs());
    wanted.add(needs.back().columns);
    second_round = second_round || needs.back().after_motion;
    if (!needs.back().whole_frame) continue;
    whole_frame = true;
    bytes_an_atom = std::max(bytes_an_atom, dynamic_cast<const FrameAnalysis&>(*analysis).bytes_an_atom());
    ids = ids || needs.back().columns.has("id");
    types = types || needs.back().columns.has("type");
  }
  wanted.add(bodies.columns());
  wanted.add(masses.columns());
  if (selection) wanted.select(*selection);
}

class FrameRun::Rounds {
 public:
  Rounds(const FramePlan& plan, std::size_t threads)
      : plan_(plan), threads_(threads), places_(threads <= 1 ? 1 : 2 * threads) {
    for (std::size_t k = 0; k < plan.analyses.size(); ++k)
      (plan.needs[k].whole_frame ? whole_ : plan.needs[k].after_motion ? second_ : first_)
          .push_back(k);
  }

  FrameOutcome run(const FrameHeader& header, ChunkSupply& chunks, Unwrapping* unwrapping, bool on_ranks) {
    on_ranks_ = on_ranks;
    begin(header, chunks, unwrapping);
    if (unwrapping) unwrapping->begin(header.box, box_centres());
    FrameOutcome outcome;
    outcome.rows.resize(plan_.analyses.size());
    gather_ = plan_.whole_frame;
    round(members(first_), {header, {}}, outcome.rows);
    gather_ = false;
    if (plan_.second_round) {
      Table motion_row(plan_.analyses.front()->columns());
      motion_row.add_row(outcome.rows.front());
      const auto motion = body_motion(motion_row, 0);
      round(members(second_), {header, motion}, outcome.rows);
    }
    if (plan_.whole_frame) whole_frame(header, outcome);
    outcome.uncertain_images = on_ranks_ ? uncertain_of_all_ : uncertain_.load();
    return outcome;
  }

  void follow(const FrameHeader& header, ChunkSupply& chunks, Unwrapping& unwrapping) {
    on_ranks_ = false;
    begin(header, chunks, &unwrapping);
    rounds_left_ = 1;
    keep_ = false;
    unwrapping.begin(header.box, box_centres());
  }

 private:
  using Partials = std::vector<std::unique_ptr<Partial>>;
  /// An analysis of a round and the place of its row.
  struct Member {
    const Analysis* analysis;
    std::size_t row;
  };

  /// A block under way.
  struct Place {
    Chunk chunk;               ///< where the supply may put one
    const Chunk* cut = nullptr;
    AtomBlock block;
    std::vector<BodyIndex> body;
    std::vector<double> mass;
    std::size_t uncertain = 0;
    Partials partials;  ///< of the round's members
  };

  void begin(const FrameHeader& header, ChunkSupply& chunks, Unwrapping* unwrapping) {
    header_ = &header;
    chunks_ = &chunks;
    unwrapping_ = unwrapping;
    centred_ = false;
    rounds_left_ = 1 + (unwrapping != nullptr) + plan_.second_round;
    rounds_done_ = 0;
    uncertain_ = 0;
    kept_.clear();
    kept_bytes_ = 0;
    keep_ = rounds_left_ > 1;
    if (!plan_.whole_frame) return;
    atoms_ = std::make_unique<FrameStore>(plan_.frame_memory / plan_.bytes_an_atom, plan_.ids, plan_.types);
    atoms_->reserve(header.atoms);
  }

  std::vector<Member> members(const std::vector<std::size_t>& of_round) const {
    std::vector<Member> all;
    for (const std::size_t k : of_round) all.push_back({plan_.analyses[k].get(), k});
    return all;
  }

  std::vector<double> box_centres() {
    std::vector<std::vector<double>> row(1);
    round({{plan_.centres.get(), 0}}, {*header_, {}}, row);
    centred_ = true;
    return row.front();
  }

  /// Gives the frame's blocks to the members and closes their rows.
  void round(const std::vector<Member>& members, const FrameContext& context,
             std::vector<std::vector<double>>& rows) {
    std::vector<MergeTree> trees(members.size());
    const auto merge = [&](Partials& partials) {
      for (std::size_t i = 0; i < members.size(); ++i) trees[i].push(std::move(partials[i]));
    };
    if (on_ranks_)
      blocks_of_ranks(members, context, merge);
    else
      run_blocks(members, context, merge);
    --rounds_left_;
    ++rounds_done_;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto whole = trees[i].finish();
      if (!whole) throw InputError("a frame without atoms");
      auto& row = rows[members[i].row];
      row.resize(members[i].analysis->columns().size());
      whole->close(row);
    }
  }

  /// What a rank tells the others of its blocks in a round, before their partials.
  struct Told {
    std::uint64_t blocks = 0;
    std::uint64_t uncertain = 0;  ///< images
    std::optional<Failure> failure;
    void pass(Parcel& parcel) { parcel(blocks, uncertain, failure); }
  };

  /// Every rank takes its share of the blocks and gets the partials of all.
  void blocks_of_ranks(const std::vector<Member>& members, const FrameContext& context,
                       const std::function<void(Partials&)>& take) {
    Told told;
    Parcel partials;
    told.failure = Failure::of([&] {
      run_blocks(members, context, [&](Partials& of_block) {
        for (auto& partial : of_block) partial->pass(partials);
        ++told.blocks;
      });
    });
    if (told.failure) told.failure->at = std::min<std::uint64_t>(told.blocks * ranks() + own_rank(), cut_);
    told.uncertain = uncertain_;
    Parcel head;
    head(told);
    take_from_ranks(gather_from_ranks("blocks of " + header_->place, head.take() + partials.take()), members, context, take);
  }

  void take_from_ranks(std::vector<std::string> all, const std::vector<Member>& members, const FrameContext& context,
                       const std::function<void(Partials&)>& take) {
    std::vector<Parcel> parcels;
    std::vector<Told> told(all.size());
    uncertain_of_all_ = 0;
    for (std::size_t rank = 0; rank < all.size(); ++rank) {
      parcels.emplace_back(std::move(all[rank]));
      parcels.back()(told[rank]);
      uncertain_of_all_ += told[rank].uncertain;
    }
    raise_first(told, [](const Told& of_rank) { return of_rank.failure; });
    for (std::size_t block = 0; block / ranks() < told[block % ranks()].blocks; ++block) {
      Partials partials;
      for (const Member& member : members) {
        partials.push_back(member.analysis->begin(context));
        partials.back()->pass(parcels[block % ranks()]);
      }
      take(partials);
    }
  }

  static std::size_t ranks() { return static_cast<std::size_t>(rank_count()); }
  static std::size_t own_rank() { return static_cast<std::size_t>(rank()); }
  bool is_own(std::uint64_t block) const { return !on_ranks_ || block % ranks() == own_rank(); }

  /// The next chunk of this rank. Damage is noted: the blocks before it come first.
  bool cut(Place& place) {
    try {
      do place.cut = chunks_->cut(place.chunk);
      while (place.cut && !is_own(cut_++));
    } catch (...) {
      cut_failed_ = std::current_exception();
      place.cut = nullptr;
    }
    return place.cut != nullptr;
  }

  /// Blocks of the frame (of this rank), from the file or those kept in an earlier round, through the pipeline.
  void run_blocks(const std::vector<Member>& members, const FrameContext& context,
                  const std::function<void(Partials&)>& take) {
    const bool kept = rounds_done_ > 0 && keep_;
    if (rounds_done_ > 0 && !kept) chunks_->restart();
    cut_ = kept ? std::numeric_limits<std::uint64_t>::max() : 0;
    cut_failed_ = nullptr;
    std::size_t next = 0;
    BlockPipeline pipeline;
    pipeline.threads = threads_;
    pipeline.slots = places_.size();
    pipeline.produce = [&](std::size_t slot) {
      if (!kept) return cut(places_[slot]);
      if (next == kept_.size()) return false;
      places_[slot].block = std::move(kept_[next++]);
      return true;
    };
    pipeline.work = [&](std::size_t slot) {
      if (!kept) convert(places_[slot]);
      analyse(places_[slot], context, members);
    };
    std::size_t collected = 0;
    pipeline.collect = [&](std::size_t slot) {
      Place& place = places_[slot];
      take(place.partials);
      if (plan_.stop && *plan_.stop) throw Interrupted(*plan_.stop);
      if (gather_) atoms_->add(place.block, place.body);
      if (kept)
        kept_[collected++] = std::move(place.block);
      else if (rounds_left_ > 1 && keep_)
        keep(place);
    };
    mdana::run(pipeline);
    if (cut_failed_) std::rethrow_exception(cut_failed_);
  }

  /// The gathered atoms to those that need them together.
  void whole_frame(const FrameHeader& header, FrameOutcome& outcome) {
    if (atoms_->size() == 0) throw InputError("a frame without atoms of a body");
    kept_.clear();
    atoms_->sort();
    const StageClock clock(Stage::whole);
    const auto atoms = std::move(atoms_);
    for (const std::size_t k : whole_) {
      const auto& analysis = dynamic_cast<const FrameAnalysis&>(*plan_.analyses[k]);
      outcome.rows[k].resize(analysis.columns().size());
      auto product = analysis.look(header, *atoms, threads_, outcome.rows[k]);
      if (product) outcome.products.push_back({k, std::move(product)});
    }
  }

  void convert(Place& place) const {
    mdana::convert(*place.cut, place.block);
    if (plan_.last_digit_seed)
      move_last_digits(*place.cut, *header_, plan_.wanted, *plan_.last_digit_seed, place.block);
    if (plan_.dropped_digits > 0)
      drop_digits(*place.cut, *header_, plan_.wanted, plan_.dropped_digits, place.block);
  }

  void analyse(Place& place, const FrameContext& context, const std::vector<Member>& members) {
    plan_.bodies.label(place.block, place.body);
    plan_.masses.fill(place.block, place.mass);
    unwrap(place);
    const LabelledBlock labelled{place.block, place.body, place.mass};
    place.partials.clear();
    for (const Member& member : members) {
      place.partials.push_back(member.analysis->begin(context));
      place.partials.back()->add(labelled);
    }
  }

  /// Once for blocks that are kept, and what was moved stays where it is.
  void unwrap(Place& place) {
    if (!unwrapping_ || !centred_) return;
    const std::size_t uncertain = unwrapping_->apply(place.block, place.body);
    if (rounds_done_ == 1) uncertain_ += uncertain;
  }

  void keep(Place& place) {
    kept_bytes_ += place.block.bytes();
    keep_ = kept_bytes_ <= plan_.memory;
    if (keep_)
      kept_.push_back(std::exchange(place.block, {}));
    else
      kept_.clear();
  }

  const FramePlan& plan_;
  std::size_t threads_;
  std::vector<Place> places_;
  std::vector<std::size_t> first_, second_;  ///< analyses of the two rounds
  std::vector<std::size_t> whole_;           ///< those of whole frames

  const FrameHeader* header_ = nullptr;
  ChunkSupply* chunks_ = nullptr;
  Unwrapping* unwrapping_ = nullptr;
  bool centred_ = false;  ///< the bodies' centres are settled
  int rounds_left_ = 0, rounds_done_ = 0;
  std::atomic<std::uint64_t> uncertain_ = 0;
  bool on_ranks_ = false;               ///< the frame's blocks are shared by all ranks
  std::uint64_t uncertain_of_all_ = 0;  ///< uncertain_ of all ranks
  std::uint64_t cut_ = 0;               ///< chunks in this round; without bound where none are cut
  std::exception_ptr cut_failed_;       ///< at the next one
  bool keep_ = false;  ///< the whole frame is in kept_, or may still be
  std::size_t kept_bytes_ = 0;
  std::vector<AtomBlock> kept_;
  bool gather_ = false;                ///< in this round, for analyses of whole frames
  std::unique_ptr<FrameStore> atoms_;  ///< of the frame, for them
};

FrameRun::FrameRun(const FramePlan& plan, std::size_t threads)
    : rounds_(std::make_unique<Rounds>(plan, threads)) {}
FrameRun::~FrameRun() = default;
FrameRun::FrameRun(FrameRun&&) noexcept = default;

FrameOutcome FrameRun::run(const FrameHeader& header, ChunkSupply& chunks,
                           Unwrapping* unwrapping) {
  return rounds_->run(header, chunks, unwrapping, false);
}

FrameOutcome FrameRun::run_on_ranks(const FrameHeader& header, ChunkSupply& chunks, Unwrapping* unwrapping) {
  return rounds_->run(header, chunks, unwrapping, true);
}

void FrameRun::follow(const FrameHeader& header, ChunkSupply& chunks, Unwrapping& unwrapping) {
  rounds_->follow(header, chunks, unwrapping);
}

}  // namespace mdana
