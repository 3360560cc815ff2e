// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// Surface of a body through the centres of its outermost atoms.
struct BodySurface {
  double area = 0;         ///< [length^2]
  double volume = 0;       ///< within it, voids included [length^3]
  double radius = 0;       ///< of a ball of that volume, and half a {111} layer beyond the centres [length]
  std::size_t voids = 0;   ///< holes within
  double void_volume = 0;  ///< [length^3]
};

/// Tetrahedra of the Delaunay triangulation with greater circumradius [spacings] are outside: between
/// those of fcc (0.61, 0.71) and the hole that a missing atom leaves (1).
inline constexpr double solid_circumradius = 0.9;

/// By the triangulation of the atoms near those of incomplete surroundings only, which near them is that
/// of all (see defects.md); all zero if the body has no tetrahedron.
BodySurface find_surface(const Sites& sites, const FrameAtoms& atoms, BodyIndex body);

}  // namespace mdana::defects
