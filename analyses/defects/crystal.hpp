// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analyses/defects.hpp"
#include "analyses/defects/neighbours.hpp"
#include "analyses/defects/structure_kernel.hpp"

namespace mdana::defects {

using Twelve = std::array<Eigen::Vector3d, 12>;

/// The 12 neighbours of fcc, 1/sqrt 2 <110>, in the axes of the cube [neighbour distances].
const Twelve& fcc_neighbours();

/// What may stand about an atom of a fcc crystal, in its axes: fcc itself, or hcp on one of the four
/// {111} planes with one of its two sides that of the crystal.
struct Template {
  Structure structure;
  Twelve neighbours;
};
std::span<const Template> templates();  ///< fcc first

/// The 12 nearest of the neighbours, by place; nothing if there are fewer.
std::optional<std::array<Neighbour, 12>> nearest_twelve(const Neighbours& all);

/// Linear map of the ideal neighbours, in the axes of the cube, to those about a fcc atom [spacings]:
/// its least squares deformation. The axes are any of the 24 that turn the cube into itself. Nothing if
/// the neighbours are not those of fcc.
std::optional<Eigen::Matrix3d> deformation(std::span<const Neighbour, 12> neighbours);

/// The structure from all neighbours within reach, as the kernels find it, and its margin.
struct Labelled {
  Structure structure = Structure::other;
  float margin = 0;
};
Labelled common_neighbour_structure(const Neighbours& all);

/// bcc by its 14 nearest, ico by its 12 nearest; other if it is neither.
Structure bcc_or_ico(const Neighbours& all);

}  // namespace mdana::defects
