// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/defects.hpp"
#include "reports/vtp.hpp"

namespace mdana {

/// The surfaces of a frame: triangles with the numbers `body` and `void` (1 for the wall of one).
PolyData surface_picture(const BodySurfaces& surfaces);

/// Its planar faults: each a disc of its area about its centre, with `kind` (1 intrinsic, 2 extrinsic, 3
/// twin), `body`, `area` and `atoms`.
PolyData fault_picture(const std::vector<FaultPlane>& planes);

/// Its dislocation lines, with `body`, `family` (as in LineFamily), `length`, `character` [degrees], and the Burgers
/// vector in space, `burgers_x`, `_y`, `_z` [length].
PolyData line_picture(const DislocationLines& lines);

}  // namespace mdana
