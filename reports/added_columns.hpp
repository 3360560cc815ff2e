// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/bodies.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"
#include "readers/masses.hpp"
#include "readers/units.hpp"

namespace mdana {

/// Columns of a frame that mdana computes atom by atom from those that it has. Names begin with
/// `c_mdana_`, like those of a compute of LAMMPS: programs that keep added columns know them by `c_`.
struct AddedColumns {
  std::vector<std::string> names;
  ColumnSet needs;  ///< of the frame, as they stand there
  /// Makes the columns of a block that has those of the frame as they stand; on any thread.
  std::function<void(const FrameHeader& frame, AtomBlock& block)> make;
};

AddedColumns added_bodies(Bodies bodies);  ///< c_mdana_body: 1, 2, ...; 0 is none
AddedColumns added_masses(Masses masses);  ///< c_mdana_mass [mass]

/// c_mdana_ke [energy]: m v^2/2 of the velocities as they stand, in the energy unit of the system.
AddedColumns added_kinetic_energy(Masses masses, Units units);

/// xu yu zu [length], as far as the frame allows.
AddedColumns added_unwrapped();

/// Throws InputError if the frame lacks what the columns are made of, or has one of their names.
void check_added(const AddedColumns& added, const FrameHeader& frame);

}  // namespace mdana
