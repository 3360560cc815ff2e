// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "readers/box.hpp"

namespace mdana::lammps_text {

/// The four lines of ITEM: BOX BOUNDS: orthogonal, tilted (bounds of the whole parallelepiped and
/// xy xz yz), or general (abc origin) for edges that are not along x, in the xy plane, and up.
/// Bounds are those that a dump stated, to the last bit; else they are chosen such that they read back
/// as the same origin and edges wherever there are numbers that do.
/// Throws InputError at a box that is not finite or has no volume.
std::string box_lines(const Box& box);

}  // namespace mdana::lammps_text
