// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analyses/energy_budget.hpp"
#include "analyses/energy_curve.hpp"
#include "analyses/logged_energy.hpp"
#include "reports/document.hpp"
#include "reports/measured.hpp"
#include "reports/run.hpp"

namespace mdana {

/// Where the potential energy is to come from. At most one of the two.
struct PotentialOptions {
  std::string column;         ///< of the dump; empty: its only one that by its name holds energies
  std::filesystem::path log;  ///< of LAMMPS, if not empty
};

/// What is known of the potential energy before the dump is read.
struct PotentialChoice {
  std::string column;    ///< of the dump; empty: none
  std::string obstacle;  ///< why there is neither a column nor a log
};
PotentialChoice choose_potential(const Run& run, const PotentialOptions& options);

/// A log and what was taken from it.
struct UsedLog {
  ThermoLog log;
  LoggedEnergy energy;
};

/// Energies of a run and what the collision made of them.
struct MeasuredEnergy {
  EnergyCurve curve;
  PotentialChoice potential;
  std::optional<UsedLog> log;
  std::optional<EnergyBudget> budget;
  std::string budget_obstacle;  ///< why there is none
  double atoms_of_no_body = 0;  ///< most in a frame
};

/// What the motion analysis has to read for energies and, if the dump allows, phases. Throws
/// InputError if the dump has no velocities.
MotionParts parts_for_energy(const Run& run);

/// `energy` is the table of the analysis energy from the same pass as the motion. The log is read
/// here. Throws InputError if it does not fit the run.
MeasuredEnergy measure_energy(const Run& run, const MeasuredMotion& measured, const Table& energy,
                              const Radii& radii, const PotentialOptions& options);

/// Numbers, sources, warnings and what was left out, under the names that other programs rely on.
void add_energy(Document& document, const MeasuredEnergy& energy);

/// Energy of rotation of each body before and after, in the windows of the energy budget, which start
/// and end where the phases say; or why there is none.
void add_rotation(Document& document, const EnergyCurve& energy, const ForceCurve& curve);

}  // namespace mdana
