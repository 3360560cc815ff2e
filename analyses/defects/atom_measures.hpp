// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// Centro-symmetry [length^2] by place (Kelchner, Plimpton & Hamilton 1998): of the 66 pairs of the 12
/// nearest neighbours, the six of smallest |r_i + r_k|^2 added up, as LAMMPS' compute centro/atom does;
/// NaN with fewer than 12 within reach.
std::vector<float> centro_symmetry(const Sites& sites);

/// Atoms within between_shells, by place; 255 at most.
std::vector<std::uint8_t> coordination(const Sites& sites);

}  // namespace mdana::defects
