// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analyses/defects.hpp"
#include "analyses/defects/zone.hpp"

namespace mdana::defects {

/// The surfaces of bodies 1 and 2, each as if it were alone: the sides of filled tetrahedra among its
/// atoms that no two of them share. The patch: what of both is not at the surface of both together, its mean;
/// error: half the difference, or half of what spans from body to body, whichever is more.
BodySurfaces find_surfaces(const Sites& sites, const FrameAtoms& atoms);

}  // namespace mdana::defects
