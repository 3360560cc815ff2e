// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "analyses/analysis.hpp"

namespace mdana {

/// Area that atoms of a plane cover; see analyses/contact_patch/contact_patch.md.
struct PatchArea {
  double area = 0;           ///< [length^2], that of the triangles and the strip about them
  double error = 0;          ///< [length^2], covers some 95 %
  std::size_t atoms = 0;     ///< corners of triangles
  std::size_t boundary = 0;  ///< of them, those at the edge

  double radius() const;        ///< sqrt(area/pi) [length]
  double radius_error() const;  ///< [length]
};

/// Triangles of greater circumradius are holes or lie outside; in nearest neighbour distances.
inline constexpr double greatest_circumradius = 1.5;
/// Atoms of a plane nearer to each other stand one above the other and count once; likewise.
inline constexpr double stacked_distance = 0.35;

/// Area of the alpha shape of points in a plane, each point at its edge with its own half cell
/// outside. `spacing` is the distance of nearest neighbours in space [length]. Points that no
/// triangle reaches are left out; without any triangle the area is 0 with the points' own area as
/// its error.
PatchArea patch_area(std::span<const Eigen::Vector2d> points, double spacing);

struct ContactPatchSettings {
  std::array<double, 2> radius;  ///< of body 1, 2 [length], places the plane if they differ
  double half_layer;             ///< half thickness of the layer [length]
  double spacing;                ///< distance of nearest neighbours in a body [length]
  double cutoff;                 ///< atoms of the two bodies nearer than this are neighbours [length]
};

/// Default of ContactPatchSettings::cutoff, in nearest neighbour distances.
inline constexpr double default_neighbour_cutoff = 1.5;

/// Contact radius sqrt(A/pi) from two areas: that of the layer's atoms (alpha; as contact_radius,
/// zero while the layer lacks atoms of one of the bodies), and that of the atoms of each body that
/// have a neighbour in the other one. Keeps the atoms nearer to the contact plane than the
/// thickness of the layer or 1.1 times the cutoff, 40 bytes each.
/// Columns: contact_radius_alpha, contact_radius_alpha_error, contact_radius_neighbours,
/// contact_radius_neighbours_error [length], neighbour_atoms1, neighbour_atoms2.
std::unique_ptr<Analysis> make_contact_patch(ContactPatchSettings settings);

}  // namespace mdana
