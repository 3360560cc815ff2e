// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/logged_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

[[noreturn]] void fail(const ThermoLog& log, const std::string& what) {
  throw InputError(log.path + ": " + what);
}

/// The last runs in which steps do not go back, as after reset_timestep.
ThermoLog last_runs(const ThermoLog& log) {
  ThermoLog last = log;
  auto& sections = last.sections;
  std::erase_if(sections, [](const ThermoSection& s) { return s.table.rows() == 0; });
  for (std::size_t k = sections.size(); k > 1; --k) {
    const auto *before = sections[k - 2].table.find("Step"), *after = sections[k - 1].table.find("Step");
    if (!before || !after || after->values.front() >= before->values.back()) continue;
    sections.erase(sections.begin(), sections.begin() + static_cast<std::ptrdiff_t>(k - 1));
    break;
  }
  return last;
}

/// A column, or the sum or difference of some.
struct Energies {
  std::vector<double> values;
  double last_digit = 0;
};

std::optional<Energies> combined(const ThermoTable& table, std::initializer_list<const char*> names,
                                 double sign) {
  Energies result;
  for (const char* name : names) {
    const auto* column = table.find(name);
    if (!column) return std::nullopt;
    if (result.values.empty()) {
      result.values = column->values;
    } else {
      for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] += sign * column->values[i];
    }
    result.last_digit += column->last_digit;
  }
  return result;
}

Energies potential_of(const ThermoLog& log, const ThermoTable& table) {
  if (const auto w = combined(table, {"PotEng"}, 1)) return *w;
  if (const auto w = combined(table, {"E_pair", "E_mol"}, 1)) return *w;
  if (const auto w = combined(table, {"E_pair"}, 1)) return *w;
  fail(log, "no potential energy among its columns (PotEng, E_pair); add pe to thermo_style");
}

Energies kinetic_of(const ThermoLog& log, const ThermoTable& table) {
  if (const auto k = combined(table, {"KinEng"}, 1)) return *k;
  if (const auto k = combined(table, {"TotEng", "PotEng"}, -1)) return *k;
  if (const auto k = combined(table, {"TotEng", "E_pair", "E_mol"}, -1)) return *k;
  fail(log, "neither KinEng nor TotEng among its columns, by which energies per atom are told from "
            "those of all atoms; add ke to thermo_style");
}

/// Row of each frame's step, or none.
std::vector<std::optional<std::size_t>> rows_of(const ThermoTable::Column& logged,
                                                const std::vector<std::int64_t>& steps) {
  std::map<double, std::size_t> row;
  for (std::size_t i = 0; i < logged.values.size(); ++i) row[logged.values[i]] = i;
  std::vector<std::optional<std::size_t>> rows;
  for (const std::int64_t step : steps) {
    const auto found = row.find(static_cast<double>(step));
    rows.push_back(found == row.end() ? std::nullopt : std::optional(found->second));
  }
  return rows;
}

/// Greatest difference of the log's kinetic energy times `factor` from the dump's, beyond what its
/// digits leave open, over the greatest of the dump.
double mismatch(const Energies& logged, const std::vector<std::optional<std::size_t>>& rows,
                const std::vector<double>& kinetic, double factor) {
  double most = 0, difference = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i]) continue;
    const double apart = std::abs(factor * logged.values[*rows[i]] - kinetic[i]);
    if (std::isnan(apart)) return apart;
    most = std::max(most, kinetic[i]);
    difference = std::max(difference, apart - factor * logged.last_digit);
  }
  return difference / most;
}

/// 1 or the number of atoms, by which the log's energies are to be multiplied.
double normalisation(const ThermoLog& log, const Energies& logged,
                     const std::vector<std::optional<std::size_t>>& rows,
                     const std::vector<double>& kinetic, double atoms) {
  const double whole = mismatch(logged, rows, kinetic, 1);
  const double per_atom = mismatch(logged, rows, kinetic, atoms);
  const bool is_whole = whole <= kinetic_tolerance, is_per_atom = per_atom <= kinetic_tolerance;
  if (is_whole && is_per_atom)
    fail(log, "its kinetic energies have too few digits to tell whether they are per atom");
  if (!is_whole && !is_per_atom)
    fail(log, fmt::format("its kinetic energy is not that of the dump, neither as it stands (off by "
                          "{:.2g} of it) nor times {:.0f} atoms (off by {:.2g}): another run, other "
                          "masses, or other atoms", whole, atoms, per_atom));
  return is_whole ? 1 : atoms;
}

}  // namespace

LoggedEnergy logged_energy(const ThermoLog& log, const std::vector<std::int64_t>& steps,
                           const std::vector<double>& kinetic, double atoms) {
  const ThermoTable table = join_sections(last_runs(log));
  const auto* logged_steps = table.find("Step");
  if (!logged_steps) fail(log, "no column Step in its thermodynamic output");
  const Energies w = potential_of(log, table), k = kinetic_of(log, table);
  const auto rows = rows_of(*logged_steps, steps);
  LoggedEnergy result;
  result.frames = static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); }));
  if (result.frames == 0)
    fail(log, "none of its steps is that of a frame; thermo and dump must print at common steps");
  const double factor = normalisation(log, k, rows, kinetic, atoms);
  result.per_atom = factor != 1;
  result.rounding = factor * w.last_digit;
  result.kinetic_mismatch = std::max(0.0, mismatch(k, rows, kinetic, factor));
  for (const auto& row : rows)
    result.potential.push_back(row ? factor * w.values[*row]
                                   : std::numeric_limits<double>::quiet_NaN());
  return result;
}

}  // namespace mdana
