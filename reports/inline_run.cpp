// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/inline_run.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "analyses/rigid_rotation.hpp"
#include "readers/inline_log.hpp"
#include "readers/last_digit.hpp"

namespace mdana {
namespace {

using Series = std::vector<double>;

/// Read once: LAMMPS may go on writing. Valid until another file is asked for.
const InlineLog& log_of(const std::filesystem::path& path) {
  static std::optional<InlineLog> log;
  if (!log || log->path != path.string()) log = read_inline_log(path);
  return *log;
}

void refuse(const RunOptions& options) {
  const std::pair<bool, const char*> settled[] = {{!options.masses.empty(), "--masses"},
                                                  {!options.bodies.empty(), "--bodies"},
                                                  {options.timestep.has_value(), "--timestep"},
                                                  {options.selection.has_value(), "--select"}};
  for (const auto& [given, option] : settled)
    if (given)
      throw InputError(fmt::format("{}: {} was settled when LAMMPS wrote this; leave it out", options.dump.string(), option));
}

/// The columns that a dump with the same contents would have.
FrameHeader first_row(const InlineLog& log) {
  FrameHeader first;
  first.step = log.steps.front();
  first.time = log.find("time")->front();
  first.units = log.units;
  first.atoms = static_cast<std::uint64_t>(log.find("n1")->front() + log.find("n2")->front());
  first.columns = {"type", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz"};
  if (log.has("W1")) first.columns.emplace_back("c_pe");
  first.place = log.path + ":3";
  return first;
}

Scene scene_of(const InlineLog& log) {
  Scene scene;
  scene.units = log.units;
  scene.interaction = log.interaction;
  scene.radii = log.radii;
  scene.radius_definition = log.radius_definition;
  return scene;
}

/// Columns of the analyses' tables, made of those of the file. Energies of analyses are in mass velocity^2.
class Columns {
 public:
  explicit Columns(const Run& run) : log_(log_of(run.dump)), dump_(run.dump), factor_(force_per_mass_acceleration(run.units)) {}

  Series column(const std::string& name) const {
    if (const Series* own = log_.find(name)) return *own;
    const std::string body = name.substr(name.size() - 1), what = name.substr(0, name.size() - 1);
    if (name == "atoms_none") return Series(log_.steps.size(), 0);
    if (what == "atoms") return *log_.find("n" + body);
    if (what == "mass") return *log_.find("m" + body);
    if (what == "K_t") return each([&](std::size_t i) { return (*log_.find("Kt" + body))[i] / factor_; });
    if (what == "rotation") return each([&](std::size_t i) { return rotation(body, i).energy; });
    if (what == "degrees_of_freedom") return each([&](std::size_t i) { return freedom(body, i); });
    if (what == "radius") return each([&](std::size_t i) { return radius(body, i); });
    throw InputError(fmt::format("{}: this {}", dump_.string(), needs_atoms));
  }

 private:
  template <class Number>
  Series each(Number&& number) const {
    Series series;
    for (std::size_t i = 0; i < log_.steps.size(); ++i) series.push_back(number(i));
    return series;
  }

  double at(const std::string& column, std::size_t i) const { return (*log_.find(column))[i]; }

  /// Sum of m dx dx^T: tr(I)/2 - I.
  Eigen::Matrix3d spread(const std::string& body, std::size_t i) const {
    const double xx = at("Ixx" + body, i), yy = at("Iyy" + body, i), zz = at("Izz" + body, i);
    const double xy = at("Ixy" + body, i), yz = at("Iyz" + body, i), xz = at("Ixz" + body, i);
    const double half = 0.5 * (xx + yy + zz);
    Eigen::Matrix3d s;
    s << half - xx, -xy, -xz, -xy, half - yy, -yz, -xz, -yz, half - zz;
    return s;
  }

  RigidRotation rotation(const std::string& body, std::size_t i) const {
    return rigid_rotation(spread(body, i), {at("Lx" + body, i), at("Ly" + body, i), at("Lz" + body, i)});
  }

  double freedom(const std::string& body, std::size_t i) const {
    return std::max(0.0, 3 * at("n" + body, i) - 3 - rotation(body, i).axes);
  }

  double radius(const std::string& body, std::size_t i) const {
    return std::sqrt(5.0 / 3.0 * (spread(body, i).trace() / at("m" + body, i)));
  }

  const InlineLog& log_;
  const std::filesystem::path& dump_;
  double factor_;
};

std::vector<std::size_t> chosen_rows(const InlineLog& log, const SweepOptions& options) {
  std::vector<std::size_t> rows;
  for (auto at = options.choice.at_or_after(0); at && *at < log.steps.size(); at = options.choice.at_or_after(*at + 1)) {
    if (options.frames && rows.size() >= *options.frames) break;
    rows.push_back(*at);
  }
  return rows;
}

template <class T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& rows) {
  std::vector<T> some;
  for (const std::size_t i : rows) some.push_back(all[i]);
  return some;
}

SweepResult rows_as_swept(const Run& run, std::span<const std::unique_ptr<Analysis>> analyses, const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const InlineLog& log = log_of(run.dump);
  if (options.strict && !log.cut.empty()) throw TruncatedInput(fmt::format("{}: {}", log.path, log.cut));
  if (options.last_digit_seed || options.dropped_digits > 0)
    throw InputError(fmt::format("{}: moving printed digits {}", log.path, needs_atoms));
  const std::vector<std::size_t> rows = chosen_rows(log, options);
  const Columns columns(run);
  SweepResult swept;
  for (const auto& analysis : analyses) {
    Table& table = swept.tables.emplace_back();
    for (const ColumnSpec& spec : analysis->columns()) table.add_column(spec, chosen(columns.column(spec.name), rows));
  }
  swept.steps = chosen(log.steps, rows);
  swept.stated_times = chosen(*log.find("time"), rows);
  swept.columns_read = log.columns;
  if (!log.cut.empty()) swept.damage = fmt::format("{}: {}", log.path, log.cut);
  swept.inputs = {log.input};
  swept.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return swept;
}

}  // namespace

Run inline_run(const RunOptions& options) {
  refuse(options);
  const InlineLog& log = log_of(options.dump);
  FrameHeader first = first_row(log);
  Scene scene = options.scene.empty() ? scene_of(log) : load_scene(options.scene);
  const StatedUnits units = find_units(options, first, scene);
  if (options.physical && units.units != Units::lj)
    throw InputError(fmt::format("{}: --physical tells what the units lj stand for, but these are {}", options.dump.string(),
                                 name(units.units)));
  return {options.dump, inline_format, std::move(first), std::move(scene), units.units, units.source, log.find("dt")->front(),
          "dump", Masses::uniform("by LAMMPS, in the file"), Bodies("type", {{1, 1, 1}, {2, 2, 2}}, log.bodies), {}, {},
          options.physical};
}

SweepResult sweep_run(const Run& run, std::span<const std::unique_ptr<Analysis>> analyses, const SweepOptions& options) {
  return has_atoms(run) ? sweep(run.dump, run.bodies, run.masses, analyses, options) : rows_as_swept(run, analyses, options);
}

double rounding_of_means(const Run& run, const std::string& column, double atoms1, double atoms2, int dropped_digits) {
  if (has_atoms(run)) return std::sqrt(1 / atoms1 + 1 / atoms2) * rounding_of(run.dump, column, dropped_digits);
  const InlineLog& log = log_of(run.dump);
  double squares = 0;
  for (std::size_t k = 0; k < log.columns.size(); ++k)
    if (log.columns[k] == column + "1" || log.columns[k] == column + "2") squares += log.last_digit[k] * log.last_digit[k];
  return std::sqrt(squares / 12);
}

}  // namespace mdana
