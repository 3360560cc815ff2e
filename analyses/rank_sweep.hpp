// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyses/failure.hpp"
#include "analyses/frame_walk.hpp"
#include "analyses/sweep_rows.hpp"

namespace mdana {

/// A sweep whose work is shared by the ranks, each of which gets all rows, in the order of the frames. The blocks of the
/// first frame are shared; if there are enough frames behind it, ranks take frames from then on: in waves, at whose end they
/// tell each other their rows. Positions that are unwrapped, frame after frame, keep to sharing blocks, unless whole
/// frames are looked at: then ranks take frames from the first one on, and follow the bodies through all of them.
class RankSweep {
 public:
  RankSweep(std::string path, const FramePlan& plan, const SweepOptions& options, FrameWalk& walk, SweepRows& rows);

  /// Throws as a sweep does, the same on every rank.
  void run();

 private:
  struct Done;
  struct Told;
  bool all_at(std::uint64_t place);
  bool shared_frame();
  void settle_waves(double a_frame);
  bool wave();
  void own_frames(Told& mine);
  bool add_wave(std::vector<Told>& told, Told& mine);

  std::string path_;
  const SweepOptions& options_;
  FrameWalk& walk_;
  SweepRows& rows_;
  std::uint64_t next_ = 0;  ///< place of the first frame that is not added
  double share_ = 0;        ///< of the input behind the frame of now
  bool by_frames_;          ///< in waves, else by blocks
  std::uint64_t each_ = 0;  ///< frames of a rank in a wave
};

}  // namespace mdana
