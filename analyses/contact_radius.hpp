// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "analyses/analysis.hpp"

namespace mdana {

struct ContactRadiusSettings {
  std::array<double, 2> radius;  ///< of body 1, 2 [length], places the plane if they differ
  double half_layer;             ///< half thickness of the layer [length]; 0.5 sigma in P1
};

/// Contact radius a = sqrt(2) r_g of the atoms of both bodies within half_layer of the contact
/// plane (see analyses/contact_plane.hpp), r_g their radius of gyration within the plane (Yoshida,
/// Kokubo & Tanaka 2024, Sec. IV A 4). Zero while the layer holds no atoms of one of the bodies:
/// they do not touch. Its error covers some 95 %: see contact_radius.md.
/// Columns: contact_radius, contact_radius_error [length], layer_atoms1, layer_atoms2.
std::unique_ptr<Analysis> make_contact_radius(ContactRadiusSettings settings);

}  // namespace mdana
