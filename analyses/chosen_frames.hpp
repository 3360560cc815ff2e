// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "analyses/sweep.hpp"
#include "readers/format.hpp"

namespace mdana {

/// The frames of a trajectory that a sweep uses, by their places among them: 0, 1, 2 ...
class ChosenFrames {
 public:
  ChosenFrames(FrameSource& source, const SweepOptions& options) : source_(source), options_(options) {}

  /// The header of the frame of that place, which is behind the one before; false if there is none.
  bool at(std::uint64_t place, FrameHeader& header);

  /// How many there are from that place on, at most: `share` of the input lies behind, and each takes `a_frame` of it.
  double left(std::uint64_t place, double share, double a_frame) const;

 private:
  FrameSource& source_;
  const SweepOptions& options_;
  std::uint64_t next_ = 0;  ///< place of the next frame
  std::uint64_t seen_ = 0;  ///< frames of the trajectory
};

/// What the frames of one sweep have to agree in.
class FrameAgreement {
 public:
  /// Frames in their order; the last one may be seen again. Throws InputError.
  void see(const FrameHeader& header);

 private:
  std::uint64_t index_ = 0;           ///< of the frame before
  std::optional<std::int64_t> step_;  ///< likewise
  bool timed_ = false;
  std::optional<Units> units_;  ///< as an earlier frame states them
};

}  // namespace mdana
