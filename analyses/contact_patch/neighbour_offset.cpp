// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_patch/neighbour_offset.hpp"

#include <cmath>
#include <numbers>

namespace mdana {
namespace {

/// Gap of a Hertz contact of radius a = s r at r, over r^2/(2R*), that of rigid spheres in touch;
/// falls from 1 at s = 0 to 0 at s = 1.
double share_of_gap(double s) {
  return 2 / std::numbers::pi * (s * std::sqrt(1 - s * s) + (1 - 2 * s * s) * std::acos(s));
}

}  // namespace

double neighbour_offset(double measured, double reduced_radius, double gap) {
  if (!(measured > 0) || !(gap > 0)) return 0;
  const double wanted = gap / measured * (2 * reduced_radius / measured);
  if (wanted >= 1) return measured;  // they do not even touch
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (share_of_gap(middle) > wanted ? low : high) = middle;
  }
  return measured * (1 - low);
}

}  // namespace mdana
