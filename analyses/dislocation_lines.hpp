// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "analyses/value.hpp"
#include "readers/bodies.hpp"

namespace mdana {

/// Burgers vectors of fcc, by their components in the axes of the cube.
enum class LineFamily : std::uint8_t {
  perfect,    ///< 1/2<110>
  shockley,   ///< 1/6<112>
  stair_rod,  ///< 1/6<110>
  hirth,      ///< 1/3<001>
  frank,      ///< 1/3<111>
  other
};
inline constexpr std::size_t line_families = 6;
std::string_view name(LineFamily family);

/// Where a segment ends.
enum class LineEnd : std::uint8_t {
  junction,  ///< at two or more other segments
  surface,
  contact,   ///< at atoms that touch the other body
  lattice,   ///< at a lattice that is not known against this one: the other body, a grain
  inside,    ///< in good crystal: nothing there ends a line, so something was missed
  closed     ///< nowhere: the segment is a closed line
};
std::string_view name(LineEnd end);

/// A piece of a dislocation between two nodes.
struct DislocationSegment {
  BodyIndex body = 0;
  std::array<std::uint32_t, 2> nodes{};  ///< of DislocationLines
  std::array<LineEnd, 2> ends{};
  /// In the axes of the body's lattice (if aligned) [lattice constants]; exact. From finish to start of a circuit
  /// that is closed in the crystal, right-handed about the direction of the points, drawn in the ideal crystal (FS/RH;
  /// Hirth & Lothe, Theory of Dislocations, 1982).
  Eigen::Vector3d burgers = Eigen::Vector3d::Zero();
  Eigen::Vector3d burgers_here = Eigen::Vector3d::Zero();  ///< the same in the axes of the crystal about the line, which may be a twin
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();     ///< from burgers_here to burgers
  Eigen::Matrix3d crystal = Eigen::Matrix3d::Identity();  ///< from burgers_here to [length], with the mean strain about the line
  bool aligned = true;           ///< else the axes are those of a grain of its own
  bool in_twin = false;          ///< the axes of burgers_here are not those of the body's lattice
  LineFamily family = LineFamily::other;      ///< of burgers_here
  double character = 0;                       ///< mean angle of line and Burgers vector [rad]: 0 screw, pi/2 edge
  double character_spread = 0;                ///< standard deviation of that angle along the line [rad]
  std::optional<Eigen::Vector3i> slip_plane;  ///< {111} in the axes of burgers_here that holds both
  Value length;                          ///< [length]
  std::vector<Eigen::Vector3d> points;   ///< [length], from node to node; first and last alike if closed

  template <class P>
  void pass(P& parcel) {
    parcel(body, nodes, ends, burgers, burgers_here, turn, crystal, aligned, in_twin, family, character, character_spread, slip_plane,
           length, points);
  }
};

/// What several segments bring to a place beyond which no lattice is known; see LineEnd::lattice.
struct UnresolvedEnds {
  BodyIndex body = 0;
  std::size_t segments = 0;
  Eigen::Vector3d burgers;  ///< of all that end there [lattice constants]
  Eigen::Vector3d centre;   ///< [length]

  template <class P>
  void pass(P& parcel) {
    parcel(body, segments, burgers, centre);
  }
};

struct DislocationLines {
  std::vector<DislocationSegment> segments;  ///< longest first
  std::vector<LineEnd> nodes;                ///< what each is
  std::vector<UnresolvedEnds> unresolved;
  /// Length of pieces too near to surface or another lattice to be told from it [length]; not in segments. Between
  /// straight lines and paths from tetrahedron to tetrahedron, which bound it.
  Value absorbed{0, 0, dimension::length};
  double residual = 0;  ///< sum over all nodes inside crystals of |sum of Burgers vectors| [lattice constants]

  /// Of a body (0: of all) and a family, if one is told [length]. Ends shorten all lines alike, so errors of
  /// lines that have ends add up; those of closed ones are independent.
  Value length(BodyIndex body, std::optional<LineFamily> family = {}) const;
  double length_below(double shortest) const;  ///< of the pieces shorter than that [length]

  template <class P>
  void pass(P& parcel) {
    parcel(segments, nodes, unresolved, absorbed, residual);
  }
};

}  // namespace mdana
