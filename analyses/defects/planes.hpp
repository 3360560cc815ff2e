// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// The close-packed layer of a hcp atom: the six of the twelve that lie opposite to each other, and its normal.
struct HcpLayer {
  std::array<bool, 12> in_plane;
  Eigen::Vector3d normal;
};
HcpLayer hcp_layer(const std::array<Neighbour, 12>& twelve);

/// Pieces of fewer hcp atoms than this are no planes.
inline constexpr std::size_t least_plane = 4;

/// Planar faults of the hcp atoms of slab after slab.
class FaultFinder {
 public:
  void add(const Sites& sites);
  std::vector<FaultPlane> planes(double spacing);  ///< of all slabs, greatest first

  /// A hcp atom and its close-packed layer.
  struct Atom {
    std::uint32_t index;  ///< in the frame
    BodyIndex body;
    PlanarFault kind;
    double area;  ///< in its layer [spacings^2]
    Eigen::Vector3d normal, at;
  };

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< indices in the frame

  std::size_t place_of(std::uint32_t index) const;

  std::vector<Atom> atoms_;
  std::vector<Pair> links_;  ///< of hcp atoms of parallel layers that may be of one fault
  std::vector<Pair> edges_;  ///< of a hcp atom and one at the surface in its layer
};

}  // namespace mdana::defects
