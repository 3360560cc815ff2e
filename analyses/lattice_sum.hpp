// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace mdana {

/// u(r) = 4 epsilon ((sigma/r)^12 - (sigma/r)^6) below the cutoff, 0 beyond it.
struct LennardJones {
  double epsilon = 1;            ///< [energy]
  double sigma = 1;              ///< [length]
  std::optional<double> cutoff;  ///< [length]; nothing: there is none
  bool shifted = false;          ///< u(cutoff) is subtracted (LAMMPS: pair_modify shift yes)
};

/// An endless fcc crystal at rest under no pressure.
struct FccCrystal {
  double energy = 0;        ///< e_1 of an atom, half of each of its pairs [energy]
  double distance = 0;      ///< D of nearest neighbours [length]
  double bulk_modulus = 0;  ///< V d2E/dV2 [energy/length^3]

  double lattice_constant() const;  ///< sqrt(2) D [length]
  double atom_volume() const;       ///< D^3 / sqrt(2) [length^3]
};

/// Sums over the neighbours of an fcc atom at distances p_j (in nearest neighbour distances).
struct FccSums {
  double neighbours = 0;
  double sixth = 0;    ///< sum of p_j^-6
  double twelfth = 0;  ///< sum of p_j^-12
};

/// Sums over all neighbours, right to 15 digits; `neighbours` is infinite.
FccSums endless_fcc_sums();

/// e_1 of an fcc crystal with this distance of nearest neighbours; P1 C2, summed pair by pair.
/// Throws InputError like relaxed_fcc.
double fcc_energy(const LennardJones& potential, double distance);

/// The crystal of least energy among those without pressure, to 14 digits. Throws InputError if the
/// cutoff leaves no such crystal, or is more than 100 sigma.
FccCrystal relaxed_fcc(const LennardJones& potential);

}  // namespace mdana
