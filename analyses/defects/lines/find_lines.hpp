// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analyses/defects/planes.hpp"
#include "analyses/dislocation_lines.hpp"

namespace mdana::defects {

/// The dislocation lines of a labelled frame; `lattices` of bodies 1 and 2; `everywhere`: all atoms are triangulated, not
/// only those near defects. See lines.md.
DislocationLines find_lines(const Sites& sites, const FrameAtoms& atoms, std::span<const BodyLattice, 2> lattices,
                            bool everywhere);

}  // namespace mdana::defects
