// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analyses/lattice_sum.hpp"
#include "analyses/sweep.hpp"
#include "analyses/value.hpp"
#include "reports/document.hpp"
#include "reports/run.hpp"

namespace mdana {

/// One body in one frame. Errors are what the printed digits of the dump leave open.
struct Particle {
  SweepResult swept;
  double atoms = 0;                ///< N
  std::optional<Value> potential;  ///< U, if the energies are in the dump
  std::optional<Value> thermal;    ///< kinetic energy about the body's velocity, in energy units
  Value gyration_radius;           ///< sqrt(5/3) r_g
};

/// The column with the atoms' potential energies: the one named, else the only one whose name
/// begins with c_pe. Throws InputError.
std::string energy_column(const Run& run, const std::string& named);

/// Measures body 1 or 2 in the first frame chosen. `column` may be empty.
Particle measure_particle(const Run& run, std::size_t body, const std::string& column,
                          SweepOptions options);

/// U of the particle without heat, and where it comes from. Half of the heat is potential energy
/// (equipartition), so that the kinetic energy K is subtracted.
struct ColdEnergy {
  Value energy;
  Value kT;         ///< 2K/(3N) [energy]
};

/// `anharmonic` is the energy beside which kT is small [energy]: of K the part kT/anharmonic is in
/// doubt, besides the exchange of kinetic and potential energy, sqrt(3N) kT.
ColdEnergy cold_energy(const Value& potential, const Particle& particle, double anharmonic);

/// What a potential is known by besides the scene: what is given comes first.
struct PotentialConstants {
  std::optional<double> epsilon;   ///< [energy]
  std::optional<double> sigma;     ///< [length]
  std::optional<double> cutoff;    ///< [length]
  bool endless = false;            ///< there is no cutoff
  std::optional<bool> shifted;
};

/// The Lennard-Jones potential of a run. Throws InputError at what neither the constants nor the scene tell.
LennardJones lennard_jones(const Run& run, const PotentialConstants& given);

/// The radius that a body (1, 2) was cut with, if option or scene state it.
std::optional<Value> cut_radius(const Run& run, const RunOptions& options, std::size_t body);

/// gamma with one of the radii.
struct GammaByRadius {
  std::string radius_name;  ///< "cut" if it is known, "volume", "gyration"
  Value radius, gamma;
};
std::vector<GammaByRadius> gamma_by_radius(const FccCrystal& crystal, const Particle& particle, const ColdEnergy& cold,
                                           const std::optional<Value>& cut_radius);

/// gamma with each radius that is known, the radii, and what they are made of; P1, appendix C.
void add_surface_energy(Document& document, const FccCrystal& crystal, const Particle& particle,
                        const ColdEnergy& cold, const std::optional<Value>& cut_radius);

}  // namespace mdana
