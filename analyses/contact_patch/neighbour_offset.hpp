// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mdana {

/// How much farther than the contact radius atoms of two spheres have neighbours across the contact, if
/// these reach out to `measured`: the radius a of the Hertz contact whose surfaces are `gap` apart at r
/// = measured,  pi R* gap = a sqrt(r^2 - a^2) + (r^2 - 2 a^2) arccos(a/r),  taken off r [length].
double neighbour_offset(double measured, double reduced_radius, double gap);

}  // namespace mdana
