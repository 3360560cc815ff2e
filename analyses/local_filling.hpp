// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "analyses/grain_contacts.hpp"

namespace mdana {

/// Radius of the sphere in which the local filling factor is counted, in mean grain radii.
inline constexpr double filling_reach = 5;

double mean_radius(std::span<const Grain> grains);  ///< [length]; 0 without grains

/// Local filling factor at each grain: volume of the grains, of any body, whose centre is nearer
/// than filling_reach mean radii, itself included, over that of the sphere. Less than the filling
/// factor near a free surface. Throws as find_contacts does.
std::vector<double> local_filling(std::span<const Grain> grains);

}  // namespace mdana
