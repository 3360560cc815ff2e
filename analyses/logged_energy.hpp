// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "readers/thermo_log.hpp"

namespace mdana {

/// Potential energy of all atoms, out of a log of LAMMPS, for the frames of a dump.
struct LoggedEnergy {
  std::vector<double> potential;  ///< of every frame [energy]; NaN where the log has no row
  double rounding = 0;            ///< of `potential`, by the digits printed [energy]
  bool per_atom = false;          ///< the log divides energies by the number of atoms
  std::size_t frames = 0;         ///< that have a row
  double kinetic_mismatch = 0;    ///< greatest |K of the log - of the dump| over the greatest K
};

/// KinEng of the log and the dump's agree to this part of the greatest one: dumps have velocities of
/// four digits or more, and the normalisations in question differ by the number of atoms.
inline constexpr double kinetic_tolerance = 1e-3;

/// Joins PotEng (or E_pair + E_mol) by the step; only the last runs of the log in which steps do not
/// go back. LAMMPS prints energies per atom in lj units (thermo_modify norm yes): whether it did is
/// told by KinEng (or TotEng less potential) against `kinetic`, the dump's kinetic energy of every
/// frame. Throws InputError if columns are missing, no step is common, or neither agrees.
LoggedEnergy logged_energy(const ThermoLog& log, const std::vector<std::int64_t>& steps,
                           const std::vector<double>& kinetic, double atoms);

}  // namespace mdana
