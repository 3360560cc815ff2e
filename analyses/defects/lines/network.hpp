// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analyses/defects/lines/edges.hpp"

namespace mdana::defects {

/// Where segments end.
enum class NodeKind : std::uint8_t {
  junction,  ///< of three or more segments, or a point of a closed line
  surface,
  contact,   ///< atoms that touch the other body
  lattice,   ///< a lattice that is not known against this one
  inside     ///< in good crystal: a residual
};

struct LineNode {
  NodeKind kind;
  Eigen::Vector3d at;   ///< [spacings]
  bool passed = false;  ///< no junction, a point of a closed line
  Corners atoms{};      ///< of an end: the facet where it leaves
  std::uint32_t region = 0;  ///< of an end at a lattice: the connected tetrahedra it ends at
};

/// Part of a line between two nodes.
struct LineSegment {
  std::uint32_t from, to;  ///< nodes; the same for a closed line
  Ideal burgers;           ///< along from -> to; as in DislocationSegment
  std::vector<Eigen::Vector3d> points;  ///< [spacings]; without the nodes until they are smoothed
  std::vector<std::uint32_t> atoms;     ///< of the zone, about the line; some more than once
};

struct LineNetwork {
  std::vector<LineNode> nodes;
  std::vector<LineSegment> segments;
  /// Length of what was too near to a boundary to be told from it, along its points and between its ends [spacings].
  double absorbed = 0, absorbed_straight = 0;
};

/// Follows the facets with a Burgers vector from tetrahedron to tetrahedron. `own` of the zone's atoms; `walls`:
/// facets of tetrahedra that were taken out, in order.
LineNetwork trace_lines(const Zone& zone, std::span<const Tetrahedron> cells, const Edges& edges,
                        std::span<const OwnFrame> own, std::span<const Corners> walls);

/// Ends in good crystal within `widest` [spacings] of each other become one node, nearest first, if together
/// they end nothing: lines that pass a hole in the core or a place that was not triangulated.
void bridge_gaps(LineNetwork& network, double widest);

/// What is too near to be told apart [spacings].
struct Closeness {
  double nodes;     ///< of a segment to each other
  double parallel;  ///< segments between the same nodes, on the mean
  double boundary;  ///< to a lattice that is not known against theirs, and to the surface
};

/// Joins what lies close together: short segments become nodes, segments side by side one with the sum of
/// their Burgers vectors. What begins and ends at the boundary within its closeness (another lattice: twice that) is
/// taken for a part of it.
void contract(LineNetwork& network, const Closeness& close);

/// Makes the lines smooth without shrinking them: local parabolas over `width` [spacings] along a line on either
/// side; points at most `step` apart, the nodes first and last. Nodes move to where their segments end.
void smooth(LineNetwork& network, double width, double step);

double length(const LineNetwork& network, const LineSegment& segment);

}  // namespace mdana::defects
