// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "reports/run.hpp"

namespace mdana {

/// What LAMMPS shall write while it runs.
struct InlineWishes {
  std::uint64_t every = 10;               ///< steps
  std::string file = "mdana-inline.txt";  ///< by LAMMPS, where it runs
  bool potential = true;                  ///< energies of atoms (compute pe/atom)
};

/// Input lines for LAMMPS that write centres of mass, velocities, forces and energies of the run's two bodies as
/// readers/inline_log.hpp has them. Throws InputError if the bodies are no groups that LAMMPS can be told.
std::string inline_lines(const Run& run, const InlineWishes& wishes);

}  // namespace mdana
