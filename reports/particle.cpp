// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/particle.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyses/gyration.hpp"
#include "analyses/surface_energy.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::uint64_t moved_passes = 8;  // gives the error to 25 %
constexpr double round_body = 0.02;        // two radii of a ball of 500 atoms differ by 1 %

std::vector<std::unique_ptr<Analysis>> particle_analyses(const EnergyParts& parts) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_surface_energy(parts));
  analyses.push_back(make_gyration());
  return analyses;
}

/// Column of one body, its error from the same column with moved last digits.
Value with_digits(const std::vector<SweepResult>& swept, std::size_t table, const std::string& name,
                  Dimension dimension) {
  const double value = swept.front().tables[table].column(name)[0];
  double squares = 0;
  for (std::size_t k = 1; k < swept.size(); ++k) {
    const double step = swept[k].tables[table].column(name)[0] - value;
    squares += step * step;
  }
  return {value, std::sqrt(squares / static_cast<double>(swept.size() - 1)), dimension};
}

/// The frame as it is, then with its last digits moved in different ways.
std::vector<SweepResult> passes(const Run& run, const EnergyParts& parts, SweepOptions options) {
  options.choice.end = options.choice.first + 1;
  options.choice.stride = 1;
  options.selection = run.selection;
  const auto analyses = particle_analyses(parts);
  std::vector<SweepResult> swept;
  for (std::uint64_t seed = 0; seed <= moved_passes; ++seed) {
    if (seed > 0) options.last_digit_seed = seed;
    swept.push_back(sweep(run.dump, run.bodies, run.masses, analyses, options));
    options.progress = nullptr;
  }
  return swept;
}

Value volume_radius(const FccCrystal& crystal, double atoms) {
  return {std::cbrt(0.75 / std::numbers::pi * atoms * crystal.atom_volume()), 0.0,
          dimension::length};
}

/// Energy above that of as many atoms of the crystal.
Value excess_of(const FccCrystal& crystal, const Particle& particle, const ColdEnergy& cold) {
  Value excess = cold.energy;
  excess.value -= particle.atoms * crystal.energy;
  return excess;
}

/// A scale of the potential: 1 in lj units unless it is given.
double scale(const Run& run, const char* name, std::optional<double> given, std::optional<double> stated) {
  if (given) return *given;
  if (stated) return *stated;
  if (run.units == Units::lj) return 1;
  throw InputError(fmt::format("{}: {} of the potential is not known; add --{} VALUE", run.dump.string(), name, name));
}

void add_crystal(Document& document, const FccCrystal& crystal) {
  document.number("e_1", {crystal.energy, {}, dimension::energy});
  document.number("D", {crystal.distance, {}, dimension::length});
  document.number("lattice_constant", {crystal.lattice_constant(), {}, dimension::length});
  document.number("bulk_modulus", {crystal.bulk_modulus, {}, dimension::pressure});
}

void warn_of_particle(Document& document, const FccCrystal& crystal, const Particle& particle,
                      const ColdEnergy& cold, double excess) {
  const double gyration = particle.gyration_radius.value;
  const double volume = volume_radius(crystal, particle.atoms).value;
  if (!(excess > 0))
    document.warn("the particle's energy is not above that of as many atoms of the crystal: "
                  "another potential, cutoff or shift than that of the run?");
  if (std::abs(gyration - volume) > round_body * volume)
    document.warn(fmt::format("the radii by volume and gyration differ by {:.2g} %: no ball of "
                              "one fcc crystal", 100 * std::abs(gyration / volume - 1)));
  if (cold.kT.value > 0.01 * std::abs(crystal.energy))
    document.warn("the particle is hot: take one that is relaxed");
  if (!particle.thermal)
    document.warn("no velocities (vx vy vz): the particle is taken to be without heat");
}

}  // namespace

std::string energy_column(const Run& run, const std::string& named) {
  std::vector<std::string> found;
  for (const std::string& column : run.first.columns)
    if (named.empty() ? column.starts_with("c_pe") : column == named) found.push_back(column);
  if (found.size() == 1 && kind_of_column(found.front()) != ColumnKind::real)
    throw InputError(fmt::format("{}: the column '{}' holds no energies", run.first.place, named));
  if (found.size() == 1) return found.front();
  throw InputError(fmt::format(
      "{}: {}; add --energy-column NAME or --energy U (the dump has {})", run.first.place,
      !named.empty() ? "no column '" + named + "'"
                     : found.empty() ? "no column c_pe with the atoms' potential energies (LAMMPS: "
                                       "compute pe all pe/atom)"
                                     : "several columns that begin with c_pe",
      fmt::join(run.first.columns, " ")));
}

Particle measure_particle(const Run& run, std::size_t body, const std::string& column,
                          SweepOptions options) {
  if (body > run.bodies.count())
    throw InputError(fmt::format("{}: there is no body {}; {} found by {}", run.dump.string(), body,
                                 run.bodies.count(), run.bodies.rule()));
  const EnergyParts parts{column, run.first.has_column("vx") && run.first.has_column("vy") &&
                                      run.first.has_column("vz")};
  std::vector<SweepResult> swept = passes(run, parts, options);
  const std::string b = std::to_string(body);
  Particle particle;
  particle.atoms = swept.front().tables[0].column("count" + b)[0];
  if (particle.atoms == 0)
    throw InputError(fmt::format("{}: body {} has no atoms in this frame", run.dump.string(), b));
  if (!column.empty()) {  // in a crystal all atoms' energies are rounded alike: N, not sqrt(N)
    particle.potential = with_digits(swept, 0, "potential" + b, dimension::energy);
    *particle.potential->error *= std::sqrt(particle.atoms);
  }
  if (parts.thermal) {
    particle.thermal = with_digits(swept, 0, "thermal" + b, dimension::energy);
    const double factor = force_per_mass_acceleration(run.units);
    particle.thermal->value *= factor;
    *particle.thermal->error *= factor;
  }
  particle.gyration_radius = with_digits(swept, 1, "radius" + b, dimension::length);
  particle.swept = std::move(swept.front());
  return particle;
}

ColdEnergy cold_energy(const Value& potential, const Particle& particle, double anharmonic) {
  ColdEnergy cold{potential, {0, {}, dimension::energy}};
  if (!particle.thermal) return cold;
  const double heat = particle.thermal->value;
  cold.kT.value = 2 * heat / (3 * particle.atoms);
  cold.energy.value -= heat;
  const double exchange = std::sqrt(3 * particle.atoms) * cold.kT.value;
  const double doubt = heat * cold.kT.value / anharmonic;
  cold.energy.error = std::hypot(*potential.error, exchange, doubt);
  return cold;
}

LennardJones lennard_jones(const Run& run, const PotentialConstants& given) {
  const std::optional<double> range = given.endless ? std::nullopt : given.cutoff ? given.cutoff : run.scene.cutoff;
  const std::optional<bool> shifted = given.shifted ? given.shifted : run.scene.shift;
  if (!range && !given.endless)
    throw InputError(fmt::format("{}: the cutoff of the potential is not known, and the crystal's "
                                 "energy depends on it; add --cutoff LENGTH (or none)",
                                 run.dump.string()));
  if (range && !shifted)
    throw InputError(fmt::format("{}: it is not known whether the potential is shifted to zero at "
                                 "the cutoff (pair_modify shift); add --shift yes or no",
                                 run.dump.string()));
  return {scale(run, "epsilon", given.epsilon, {}), scale(run, "sigma", given.sigma, run.scene.sigma), range,
          shifted.value_or(false)};
}

std::optional<Value> cut_radius(const Run& run, const RunOptions& options, std::size_t body) {
  const std::string& how = run.scene.radius_definition;
  if (options.radius) return Value{(*options.radius)[body - 1], 0.0, dimension::length};
  if (run.scene.radii.size() >= body && (how.empty() || how == "cut"))
    return Value{run.scene.radii[body - 1], 0.0, dimension::length};
  return std::nullopt;
}

std::vector<GammaByRadius> gamma_by_radius(const FccCrystal& crystal, const Particle& particle, const ColdEnergy& cold,
                                           const std::optional<Value>& cut_radius) {
  const Value excess = excess_of(crystal, particle, cold);
  std::vector<GammaByRadius> all;
  const auto add = [&](const char* how, const Value& radius) { all.push_back({how, radius, surface_energy(excess, radius)}); };
  if (cut_radius) add("cut", *cut_radius);
  add("volume", volume_radius(crystal, particle.atoms));
  add("gyration", particle.gyration_radius);
  return all;
}

void add_surface_energy(Document& document, const FccCrystal& crystal, const Particle& particle,
                        const ColdEnergy& cold, const std::optional<Value>& cut_radius) {
  const Value excess = excess_of(crystal, particle, cold);
  if (!cut_radius) document.left_out("gamma.cut", "the cut radius is not known; add --radius R");
  for (const GammaByRadius& by : gamma_by_radius(crystal, particle, cold, cut_radius)) {
    document.number("gamma." + by.radius_name, by.gamma);
    document.number("radius." + by.radius_name, by.radius);
  }
  document.number("U", cold.energy);
  document.json("N", static_cast<std::uint64_t>(particle.atoms));
  document.line("N", fmt::format("{:.0f}", particle.atoms));
  document.number("excess_energy", excess);
  if (particle.thermal) {
    document.number("thermal_energy", *particle.thermal);
    document.number("kT", cold.kT);
  }
  add_crystal(document, crystal);
  warn_of_particle(document, crystal, particle, cold, excess.value);
}

}  // namespace mdana
