// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/input_record.hpp"
#include "readers/units.hpp"

namespace mdana {

/// Thermodynamic output as columns of equal length. Of multi-line blocks the first two are Step and
/// CPU, which their head states.
struct ThermoTable {
  struct Column {
    std::string name;            ///< as printed: Step, Temp, c_thermo_press[1], ...
    std::vector<double> values;  ///< in the log's units
    double last_digit = 0;       ///< unit of the last printed digit, the finest of the column
  };
  std::vector<Column> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  const Column* find(std::string_view name) const;  ///< null if there is none
};

/// What LAMMPS printed during one run (or minimization).
struct ThermoSection {
  ThermoTable table;
  std::uint64_t first_line = 0;    ///< of its keywords; the number of the line in the log
  std::optional<double> timestep;  ///< [time], as last set before the run; if the log shows it
  std::uint64_t other_lines = 0;   ///< between its rows: warnings, what fixes and scripts print
  bool finished = false;           ///< the run ended, and said so
};

/// The thermodynamic output of a LAMMPS log: thermo_style one, custom, multi and yaml.
struct ThermoLog {
  std::string path;
  std::string version;         ///< of LAMMPS: "29 Sep 2021 - Update 2"
  std::optional<Units> units;  ///< of the command `units`, if the log shows it
  std::vector<ThermoSection> sections;
  std::uint64_t warnings = 0;  ///< lines that begin with WARNING
  std::string error;           ///< the line that begins with ERROR, if LAMMPS stopped so
  std::string cut;             ///< what is missing at the end of a log that was cut; else empty
  InputRecord input;
};

/// By its first bytes: "LAMMPS (". False if there is no such file, too.
bool is_lammps_log(const std::filesystem::path& path);

/// Reads a log, plain or compressed. Of a log that ends within a row, as while LAMMPS runs, the
/// whole rows are returned, and `cut` says so. Throws InputError naming the line if a row does not
/// have the columns of its section, or if units change.
ThermoLog read_thermo_log(const std::filesystem::path& path);

/// All sections one behind the other; the first row of a run that repeats the step of the row
/// before is dropped. Throws InputError if it says something else than that row (but for what
/// counts anew with each run, such as CPU), if columns differ between sections, or steps go back.
ThermoTable join_sections(const ThermoLog& log);

}  // namespace mdana
