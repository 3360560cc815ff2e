// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// The close-packed layer of a hcp atom: the six of the twelve that lie opposite to each other, and its normal.
struct HcpLayer {
  std::array<bool, 12> in_plane;
  Eigen::Vector3d normal;
};
HcpLayer hcp_layer(const std::array<Neighbour, 12>& twelve);

/// Planar faults of the hcp atoms; pieces of fewer atoms than this are none.
inline constexpr std::size_t least_plane = 4;
std::vector<FaultPlane> find_planes(const Sites& sites, const FrameAtoms& atoms);

/// Turn of a body's lattice, from a sample of its fcc atoms; a zero quaternion without any.
struct BodyLattice {
  Eigen::Quaterniond turn{0, 0, 0, 0};
  double share = 0;  ///< of the sample that agrees within 10 degrees
};
BodyLattice find_lattice(const Sites& sites, BodyIndex body);

/// Connected fcc atoms, by place: 1, 2, ... by lowest index of an atom in the frame; 0 is none.
std::vector<std::uint32_t> find_fcc_clusters(const Sites& sites);

}  // namespace mdana::defects
