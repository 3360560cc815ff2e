// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/surface_energy.hpp"

#include <cmath>
#include <numbers>

#include "analyses/lattice_sum.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> surface_energy_known();

namespace {

/// Potential energies of which 1e16 cancels; speeds of +-2 on a drift of 1e7, where the running mean
/// is rounded to 1e-9: 9 digits of the thermal energy.
std::vector<double> energies() {
  AtomBlock block;
  block.reset(0, 4);
  const std::array<double, 4> potential{1e16, 2.5, -99, -1e16}, speed{1e7 + 2, 1e7 - 2, 5, 1e7 - 2};
  for (const char* name : {"c_pe", "vx", "vy", "vz"}) block.make_real(name);
  for (std::size_t i = 0; i < 4; ++i) {
    block.make_real("c_pe")[i] = potential[i];
    block.make_real("vx")[i] = speed[i];
    block.make_real("vy")[i] = block.make_real("vz")[i] = 0;
  }
  const std::vector<BodyIndex> body{1, 1, 2, 1};
  const std::vector<double> mass{2, 1, 7, 1};
  const auto analysis = make_surface_energy({"c_pe", true});
  const FrameHeader header;
  const auto partial = analysis->begin({header, {}});
  partial->add({block, body, mass});
  std::vector<double> row(6);
  partial->close(row);
  return row;
}

}  // namespace

// Lattice sums: Ewald's, in 30 digits, with the reciprocal lattice. e_1 = -B^2/(2A) follows from them.
// Twelve neighbours alone (cutoff 1.3) have e_1 = -6, D^3 = sqrt(2), e'' = 432/D^2, so K = 48.
std::vector<KnownAnswer> surface_energy_known() {
  const std::vector<double> row = energies();
  const FccSums sums = endless_fcc_sums();
  const FccCrystal full = relaxed_fcc({});
  const FccCrystal twelve = relaxed_fcc({1, 1, 1.3, false});
  const double a = 12.1318801965445797, b = 14.4539210437444719, d = std::pow(2.0, 1.0 / 6);
  const Value gamma = surface_energy({36 * std::numbers::pi, 0.0, dimension::energy},
                                     {3, 0.0, dimension::length});
  return {{"sum of energies of which 1e16 cancels", row[1], 2.5, 16},
          {"thermal energy on a drift of 1e7", row[2], 8, 9},
          {"sum of p^-12 over fcc", sums.twelfth, a, 15},
          {"sum of p^-6 over fcc", sums.sixth, b, 15},
          {"e_1 of the full potential", full.energy, -b * b / (2 * a), 14},
          {"e_1 of twelve neighbours", twelve.energy, -6, 15},
          {"D of twelve neighbours", twelve.distance, d, 15},
          {"K of twelve neighbours", twelve.bulk_modulus, 48, 14},
          {"gamma", gamma.value, 1, 15}};
}

}  // namespace mdana
