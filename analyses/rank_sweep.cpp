// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/rank_sweep.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analyses/parcel.hpp"
#include "readers/input_error.hpp"
#include "readers/ranks.hpp"

namespace mdana {
namespace {

constexpr double least_frames = 2;  ///< for each rank, for frames to be taken whole
constexpr double least_waves = 4;   ///< so that not many ranks wait in the last one

std::uint64_t ranks() { return static_cast<std::uint64_t>(rank_count()); }

/// What every rank tells at a place of the work, by rank.
template <class Told>
std::vector<Told> gather(const std::string& place, Told& mine) {
  Parcel parcel;
  parcel(mine);
  std::vector<Told> all;
  for (std::string& bytes : gather_from_ranks(place, parcel.take())) {
    Parcel theirs(std::move(bytes));
    theirs(all.emplace_back());
  }
  return all;
}

}  // namespace

/// A frame that a rank has done.
struct RankSweep::Done {
  FrameHeader header;
  FrameOutcome outcome;
  std::optional<double> share;
  void pass(Parcel& parcel) { parcel(header, outcome, share); }
};

/// What a rank did in a wave.
struct RankSweep::Told {
  std::vector<Done> done;
  std::optional<Failure> failure;
  bool unwraps = false;
  void pass(Parcel& parcel) { parcel(done, failure, unwraps); }
};

RankSweep::RankSweep(std::string path, const FramePlan& plan, const SweepOptions& options, FrameWalk& walk, SweepRows& rows)
    : path_(std::move(path)), options_(options), walk_(walk), rows_(rows), by_frames_(plan.whole_frame) {}

void RankSweep::run() {
  bool more = all_at(0);
  each_ = walk_.is_small() ? options_.threads : 1;
  while (more) more = by_frames_ ? wave() : shared_frame();
}

/// All ranks go to the frame of that place; false if there is none. Throws what the first of them meets.
bool RankSweep::all_at(std::uint64_t place) {
  struct Found {
    bool there = false;
    double share = 0;
    std::optional<Failure> failure;
    void pass(Parcel& parcel) { parcel(there, share, failure); }
  } found;
  found.failure = Failure::of([&] { found.there = walk_.go_to(place); });
  found.share = walk_.share().value_or(0);
  const auto all = gather(fmt::format("frame {} of {}", place, path_), found);
  raise_first(all, [](const Found& of_rank) { return of_rank.failure; });
  share_ = all.front().share;
  return std::ranges::all_of(all, &Found::there);
}

bool RankSweep::shared_frame() {
  const double before = share_;
  FrameOutcome outcome = walk_.run_on_ranks();
  rows_.add(walk_.header(), std::move(outcome), share_, rank());
  const bool more = all_at(++next_);
  if (more && next_ == 1 && !walk_.unwraps()) settle_waves(share_ - before);
  return more;
}

/// Whether ranks take frames from now on, and how many at once.
void RankSweep::settle_waves(double a_frame) {
  const double a_rank = walk_.left(share_, a_frame) / static_cast<double>(ranks());
  by_frames_ = a_rank >= least_frames;
  const double most = 4 * static_cast<double>(options_.threads);
  each_ = static_cast<std::uint64_t>(std::clamp(a_rank / least_waves, 1.0, most));
}

bool RankSweep::wave() {
  const bool unwraps = walk_.unwraps();
  const std::uint64_t first = next_ + static_cast<std::uint64_t>(rank()) * each_;
  Told mine;
  mine.failure = Failure::of([&] { own_frames(mine); });
  if (mine.failure) mine.failure->at = unwraps ? walk_.place() : first + mine.done.size();
  mine.unwraps = walk_.unwraps();
  auto told = gather(fmt::format("frames from {} of {}", next_, path_), mine);
  if (std::ranges::any_of(told, [&](const Told& of_rank) { return of_rank.unwraps != unwraps; }))
    throw std::runtime_error(fmt::format("{}: positions jump at periodic faces in some frames only: start it without mpirun",
                                         path_));
  return add_wave(told, mine);
}

void RankSweep::own_frames(Told& mine) {
  const std::uint64_t first = next_ + static_cast<std::uint64_t>(rank()) * each_, end = first + each_;
  const FrameWalk::Take take = [&](const FrameHeader& header, FrameOutcome&& outcome, std::optional<double> share) {
    mine.done.push_back({header, std::move(outcome), share});
  };
  if (!walk_.unwraps()) {
    if (walk_.go_to(first)) walk_.run(end, take);
    return;
  }
  for (std::uint64_t place = next_; place < next_ + ranks() * each_; ++place) {
    if (!walk_.go_to(place)) return;
    if (place < first || place >= end)
      walk_.follow();
    else
      walk_.run(place + 1, take);
  }
}

/// Frames in their order, up to the first one that is missing; false behind the last one of all.
bool RankSweep::add_wave(std::vector<Told>& told, Told& mine) {
  for (std::size_t owner = 0; owner < told.size(); ++owner) {
    std::vector<Done>& frames = static_cast<int>(owner) == rank() ? mine.done : told[owner].done;
    for (Done& frame : frames) rows_.add(frame.header, std::move(frame.outcome), frame.share, static_cast<int>(owner));
    if (frames.size() == each_) continue;
    if (told[owner].failure) told[owner].failure->raise();
    return false;
  }
  raise_first(told, [](const Told& of_rank) { return of_rank.failure; });
  next_ += ranks() * each_;
  return true;
}

}  // namespace mdana
