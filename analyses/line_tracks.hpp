// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "analyses/dislocation_lines.hpp"

namespace mdana {

/// A segment followed from frame to frame.
struct LineTrack {
  BodyIndex body = 0;
  LineFamily family = LineFamily::other;
  Eigen::Vector3d burgers;  ///< when it was first seen, in the axes of the first frame's lattice [lattice constants]
  std::size_t first = 0, last = 0;  ///< frames
  double longest = 0;               ///< [length]
  Eigen::Vector3d place;            ///< its middle when it was first seen [length]
};

/// What slip of one Burgers vector on one plane did to a body.
struct SlipSystem {
  BodyIndex body = 0;
  Eigen::Vector3i plane;    ///< {111} in the axes of the crystal about the lines
  Eigen::Vector3d burgers;  ///< likewise [lattice constants]; its first component that is not 0 is positive
  double shear = 0;         ///< sum of |b| swept area / volume of the body
  double reversed = 0;      ///< of it, in the sense that had less (after finish())
};

/// A frame as the tracks need it.
struct LineFrame {
  const DislocationLines& lines;
  std::array<std::optional<Eigen::Quaterniond>, 2> lattice;  ///< of bodies 1 and 2
  std::array<Eigen::Vector3d, 2> centre;                     ///< of their atoms [length]
  std::array<double, 2> volume;                              ///< [length^3]
  double spacing;                                            ///< [length]
};

/// Follows segments through frames: of the same body and Burgers vector, nearest first, at most some spacings from
/// where one was, the motion of the body aside. Keeps the last frame only.
class LineTracks {
 public:
  /// Greatest mean distance between a segment and what it becomes [spacings].
  static constexpr double farthest = 6;

  /// The track of each segment.
  std::vector<std::uint32_t> add(const LineFrame& frame);

  const std::vector<LineTrack>& tracks() const { return tracks_; }
  const std::vector<SlipSystem>& slip() const { return slip_; }  ///< most shear first after finish()
  /// Plastic distortion of a body, sum of b (line x motion) / volume over all that was followed, in the space of the
  /// dump (Mura, Micromechanics of Defects in Solids, 1987).
  const Eigen::Matrix3d& distortion(BodyIndex body) const { return distortion_[body - 1u]; }
  void finish();  ///< completes and orders the slip systems; once

 private:
  static constexpr std::uint32_t no_track = ~0u;
  struct Seen {
    DislocationSegment segment;
    Eigen::Vector3d burgers;             ///< in the axes of the first frame
    std::vector<Eigen::Vector3d> shape;  ///< evenly along the line, from the centre of its body
    std::uint32_t track = no_track;
  };

  void follow_lattices(const LineFrame& frame);
  Eigen::Vector3d followed(const DislocationSegment& segment, const LineFrame& frame) const;
  void go_on(std::vector<Seen>& now, const LineFrame& frame);
  void note(Seen& seen);
  void sweep(const Seen& before, const Seen& now, bool turned, double volume);

  std::size_t frames_ = 0;
  std::array<std::optional<Eigen::Quaterniond>, 2> lattice_;  ///< followed
  std::vector<Seen> last_;
  std::vector<LineTrack> tracks_;
  std::vector<SlipSystem> slip_;
  std::array<Eigen::Matrix3d, 2> distortion_{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
};

}  // namespace mdana
