// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "readers/box.hpp"

namespace mdana::lammps_text {

/// The four lines of ITEM: BOX BOUNDS: orthogonal, tilted (bounds of the whole parallelepiped and
/// xy xz yz), or general (abc origin) for edges that are not along x, in the xy plane, and up.
/// Bounds are chosen such that they read back as the same origin and edges wherever numbers exist
/// that do: they do for every box that was read from a dump.
/// Throws InputError at a box that is not finite or has no volume.
std::string box_lines(const Box& box);

}  // namespace mdana::lammps_text
