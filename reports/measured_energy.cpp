// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measured_energy.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyses/energy.hpp"
#include "readers/boltzmann.hpp"
#include "readers/input_error.hpp"
#include "reports/plan.hpp"

namespace mdana {
namespace {

/// Beyond this part of the first K_p the total energy is not kept well enough to tell where K_p went.
constexpr double large_drift = 0.05;

UsedLog use_log(const Run& run, const MeasuredMotion& measured, const EnergyCurve& curve,
                const std::filesystem::path& path) {
  ThermoLog log = read_thermo_log(path);
  if (log.units && *log.units != run.units)
    throw InputError(fmt::format("{}: units {}, but {} in the dump", path.string(),
                                 name(*log.units), name(run.units)));
  const Table& motion = measured.swept.tables.front();
  const double atoms = motion.column("atoms1")[0] + motion.column("atoms2")[0] +
                       motion.column("atoms_none")[0];
  LoggedEnergy energy = logged_energy(log, measured.swept.steps, curve.kinetic(), atoms);
  return {std::move(log), std::move(energy)};
}

/// The budget, or why there is none.
void find_budget(MeasuredEnergy& energy, const Run& run, const RelativeMotion& motion,
                 const Radii& radii) {
  try {
    const ForceCurve curve = force_curve(motion, best_force_source(run), run.units, radii.sum());
    const auto windows = energy_windows(curve);
    if (windows)
      energy.budget = energy_budget(energy.curve, curve, *windows);
    else
      energy.budget_obstacle = !curve.contact         ? "no contact in this dump"
                               : curve.cycles.empty() ? "the dump ends before the bodies turn back"
                                                      : "the dump has no frame before contact";
  } catch (const InputError& error) {
    energy.budget_obstacle = error.what();
  }
}

nlohmann::ordered_json window_json(const std::vector<std::size_t>& frames) { return frames; }

void add_windows(Document& document, const EnergyWindows& windows) {
  const auto &before = windows.before, &after = windows.after;
  document.json("energy.frames_before", window_json({before.first, before.last - 1}));
  document.json("energy.frames_after", window_json({after.first, after.last - 1}));
  document.line("averaged over", fmt::format("frames {} to {}, and {} to {}", before.first,
                                             before.last - 1, after.first, after.last - 1));
  if (std::min(before.frames(), after.frames()) < 2)
    document.warn("one frame before contact or after it: the errors of energies are what they change "
                  "to the frame beside it");
}

void add_temperatures(Document& document, const EnergyBudget& budget) {
  const char* unit = temperature_symbol(document.units());
  document.json("energy.temperature_unit", unit);
  for (std::size_t b = 0; b < 2; ++b)
    for (const bool after : {false, true}) {
      const Value& value = after ? budget.temperature_after[b] : budget.temperature_before[b];
      const std::string name =
          fmt::format("energy.temperature{}_{}", b + 1, after ? "after" : "before");
      document.json(name, to_json(value));
      document.line(name, to_text(value, document.units()) + " " + unit);
    }
}

/// Numbers that need W.
void add_conversion(Document& document, const EnergyBudget& budget) {
  document.number("delta_W", budget.delta_W);
  document.number("energy.W_share", budget.W_share);
  document.number("energy_drift", budget.energy_drift);
  document.number("energy.converted", budget.converted);
  if (budget.ringing.value > 0) document.number("energy.ringing", budget.ringing);
  if (std::abs(budget.energy_drift.value) > large_drift)
    document.warn(fmt::format("the total energy changes by {:.2g} of the first K_p: shares of W and "
                              "K_t are no better than that (time step, thermostat, walls, or W is "
                              "not all of the potential energy)", budget.energy_drift.value));
}

void add_budget(Document& document, const EnergyBudget& budget) {
  add_windows(document, budget.windows);
  document.number("energy.K_p_initial", budget.K_p_initial);
  document.number("delta_K_p", budget.delta_K_p);
  document.number("delta_K_t", budget.delta_K_t);
  document.number("energy.delta_rotation", budget.delta_rotation);
  document.number("energy.K_t_share", budget.K_t_share);
  document.number("energy.restitution", budget.restitution);
  document.number("energy.across", budget.across);
  document.number("energy.one_minus_e2", budget.one_minus_e2);
  if (!std::isnan(budget.delta_W.value)) add_conversion(document, budget);
  add_temperatures(document, budget);
}

void leave_out(Document& document, const std::string& what, const std::string& reason) {
  document.left_out(what, reason);
  document.line("left out", what + ": " + reason);
}

void add_potential(Document& document, const MeasuredEnergy& energy) {
  if (!energy.log) {
    if (energy.potential.obstacle.empty())
      document.text("energy.potential_source", "column " + energy.potential.column);
    else
      document.line("left out", "W: " + energy.potential.obstacle);
    return;
  }
  const auto& [log, logged] = *energy.log;
  document.input(log.input, "lammps_log");
  document.text("energy.potential_source",
                fmt::format("log {}, energies {}, in {} of {} frames", log.path,
                            logged.per_atom ? "per atom" : "of all atoms", logged.frames,
                            logged.potential.size()));
  document.json("energy.log_per_atom", logged.per_atom);
  document.json("energy.log_frames", logged.frames);
  document.json("energy.log_kinetic_mismatch", logged.kinetic_mismatch);
  if (!log.cut.empty()) document.damage(log.path + ": " + log.cut);
}

}  // namespace

PotentialChoice choose_potential(const Run& run, const PotentialOptions& options) {
  if (!options.log.empty()) return {};
  if (!options.column.empty()) {
    if (!run.first.has_column(options.column))
      throw InputError(fmt::format("{}: no column '{}' for --potential; it has {}", run.first.place,
                                   options.column, fmt::join(run.first.columns, " ")));
    if (kind_of_column(options.column) != ColumnKind::real)
      throw InputError(fmt::format("{}: column '{}' for --potential holds no real numbers",
                                   run.first.place, options.column));
    return {options.column, {}};
  }
  const auto found = potential_columns(run.first);
  if (found.size() == 1) return {found.front(), {}};
  if (found.empty())
    return {{}, "no column c_pe, c_peatom or pe in the dump; name one by --potential, or give the "
                "log by --log"};
  return {{}, fmt::format("several columns ({}); choose one by --potential",
                          fmt::join(found, ", "))};
}

MotionParts parts_for_energy(const Run& run) {
  if (const std::string why = obstacle(Part::energies, run); !why.empty())
    throw InputError(fmt::format("{}: {}", run.first.place, why));
  bool forces = true;
  for (const char* column : {"fx", "fy", "fz"}) forces = forces && run.first.has_column(column);
  return {true, forces};
}

MeasuredEnergy measure_energy(const Run& run, const MeasuredMotion& measured, const Table& energy,
                              const Radii& radii, const PotentialOptions& options) {
  MeasuredEnergy result;
  result.potential = choose_potential(run, options);
  const Table& motion = measured.swept.tables.front();
  result.curve = energy_curve(motion, energy, run.units);
  if (!options.log.empty()) {
    result.log = use_log(run, measured, result.curve, options.log);
    result.curve.W_total = result.log->energy.potential;
    result.curve.W_rounding = result.log->energy.rounding;
  }
  const auto others = motion.column("atoms_none");
  result.atoms_of_no_body = *std::max_element(others.begin(), others.end());
  find_budget(result, run, measured.motion, radii);
  return result;
}

void add_energy(Document& document, const MeasuredEnergy& energy) {
  add_potential(document, energy);
  if (energy.budget) {
    add_budget(document, *energy.budget);
    if (!energy.curve.W_total.empty() && std::isnan(energy.budget->delta_W.value))
      leave_out(document, "delta_W", "W is unknown in all frames before contact, or after it");
  } else {
    leave_out(document, "changes of energy", energy.budget_obstacle);
  }
  if (energy.atoms_of_no_body > 0)
    document.warn(fmt::format("up to {:.0f} atoms of a frame belong to no body: their kinetic energy "
                              "is not counted", energy.atoms_of_no_body));
}

void add_rotation(Document& document, const EnergyCurve& energy, const ForceCurve& curve) {
  const auto windows = energy_windows(curve);
  if (!windows) return document.left_out("rotation", "no frame before contact, or no turn");
  for (std::size_t b = 0; b < 2; ++b) {
    const std::string name = fmt::format("rotation.body{}_", b + 1);
    document.number(name + "before",
                    window_mean(energy.rotation[b], windows->before, dimension::energy));
    document.number(name + "after",
                    window_mean(energy.rotation[b], windows->after, dimension::energy));
  }
}

}  // namespace mdana
