// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/boltzmann.hpp"

namespace mdana {

// LAMMPS, update.cpp: Update::set_units, boltz
double boltzmann(Units units) {
  switch (units) {
    case Units::lj: return 1.0;
    case Units::real: return 0.0019872067;
    case Units::metal: return 8.617343e-5;
    case Units::si: return 1.3806504e-23;
    case Units::cgs: return 1.3806504e-16;
    case Units::electron: return 3.16681534e-6;
    case Units::micro: return 1.3806504e-8;
    case Units::nano: return 0.013806504;
  }
  return 1.0;
}

const char* temperature_symbol(Units units) { return units == Units::lj ? "ε/k_B" : "K"; }

}  // namespace mdana
