// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyses/chosen_frames.hpp"
#include "analyses/frame_run.hpp"
#include "analyses/sweep.hpp"

namespace mdana {

/// The result of a sweep as it grows, frame by frame in their order.
class SweepRows {
 public:
  SweepRows(const FramePlan& plan, const SweepOptions& options);

  /// A frame that rank `owner` has done: all ranks add it, the owner has its products. Throws InputError if it does not
  /// agree with those before it.
  void add(const FrameHeader& header, FrameOutcome&& outcome, std::optional<double> share, int owner);

  /// There is damage right behind the last frame.
  void damaged_behind();

  /// Gives on the products of the last frame.
  void give_products();

  SweepResult& result() { return result_; }

 private:
  void note_columns(const FrameHeader& header);
  void give(FrameOutcome::Found& found) const;
  void drop_last();

  const FramePlan& plan_;
  const SweepOptions& options_;
  SweepResult result_;
  FrameAgreement agreement_;
  std::vector<std::uint64_t> atoms_;        ///< of the frames used, as their headers state them
  std::vector<FrameOutcome::Found> held_;  ///< products of the last of them, which may be dropped
  int holder_ = 0;                          ///< the rank that has them
};

}  // namespace mdana
