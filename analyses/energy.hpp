// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "analyses/analysis.hpp"

namespace mdana {

/// Energies of bodies 1 and 2 about their centres of mass. Columns for b = 1, 2: K_t<b>, the kinetic
/// energy about the centre of mass, and rotation<b>, its part in rotation as a rigid body [mass
/// velocity^2]; degrees_of_freedom<b> of the rest; with a column of potential energies of atoms
/// W<b>, their sum [energy]. Throws InputError at a value that is not finite.
/// `potential` is the name of that column; empty: none.
std::unique_ptr<Analysis> make_energy(std::string potential);

/// Columns of a frame that by their name hold potential energies of atoms: c_pe, c_peatom, pe.
std::vector<std::string> potential_columns(const FrameHeader& frame);

}  // namespace mdana
