// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyses/chosen_frames.hpp"
#include "analyses/frame_run.hpp"

namespace mdana {

/// Reads the chosen frames of a trajectory and gives them to the analyses: large ones, whose blocks the threads share, one
/// by one; small ones several at once, each on one thread.
class FrameWalk {
 public:
  /// A frame that is done. `share` of the input lies behind it, if that is known.
  using Take = std::function<void(const FrameHeader& header, FrameOutcome&& outcome, std::optional<double> share)>;

  /// Plan and options must outlive it.
  FrameWalk(const std::filesystem::path& dump, const FramePlan& plan, const SweepOptions& options);
  ~FrameWalk();

  /// Reads the header of the frame of that place, not before the one of now; false if there is none.
  bool go_to(std::uint64_t place);
  std::uint64_t place() const { return place_; }
  const FrameHeader& header() const { return header_; }
  std::optional<double> share() const { return share_; }
  bool is_small() const { return small_next_; }         ///< one thread's work
  bool unwraps() const { return unwrapping_.has_value(); }  ///< from this frame on, by continuity

  /// The frame of now and those behind it before the place `end`, to `take` in their order.
  void run(std::uint64_t end, const Take& take);
  /// The frame of now, its blocks shared by all ranks.
  FrameOutcome run_on_ranks();
  /// The frame of now, which another rank does, is passed over, if positions are unwrapped.
  void follow();

  /// How many frames there are from this one on, at most: `share` of the input lies behind, and each takes `a_frame` of it.
  double left(double share, double a_frame) const { return chosen_.left(place_, share, a_frame); }
  /// Passes over what is left, which other ranks have done: at the end a reader leaves an index of the frames that it met.
  void pass_rest();
  std::vector<InputRecord> records() { return source_->records(); }

 private:
  struct Small;
  void next();
  void whole_frame(const Take& take);
  void small_frames(const Take& take);
  bool read(Small& small, std::exception_ptr& ended_by);
  template <class Work>
  FrameOutcome located(const FrameHeader& header, Work&& work) const;
  Unwrapping* unwrapping() { return unwrapping_ ? &*unwrapping_ : nullptr; }

  std::string path_;
  const FramePlan& plan_;
  const SweepOptions& options_;
  std::unique_ptr<FrameSource> source_;
  ChosenFrames chosen_;
  FrameRun whole_;
  std::vector<Small> small_;
  std::optional<Unwrapping> unwrapping_;  ///< once a frame needs it

  FrameHeader header_;  ///< of the frame of now, if there is one
  std::uint64_t place_ = 0, end_ = 0;
  std::optional<double> share_;
  bool there_ = false;  ///< it is, and is not done
  bool small_next_ = false;
};

}  // namespace mdana
