// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// An atom with the ideal crystal about it in the axes of its own cube.
struct OwnFrame {
  std::uint32_t index;  ///< in the frame
  Site site;
  Structure structure;
  int kind = -1;        ///< of templates(); -1: none was found
  Eigen::Matrix3d map;  ///< from the template's vectors to [spacings]: its least squares deformation
  double misfit = 0;    ///< root mean square distance of the neighbours from where that puts them [spacings]
  std::array<std::uint32_t, 12> neighbours;  ///< atoms at its places, by index in the frame
};

/// Those of some places; fcc and hcp atoms whose crystal noise hides get that of a fcc neighbour.
std::vector<OwnFrame> own_frames(const Sites& sites, const std::vector<std::uint32_t>& places);

}  // namespace mdana::defects
