// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "readers/input_record.hpp"
#include "readers/scene.hpp"
#include "readers/units.hpp"

namespace mdana {

/// What LAMMPS wrote of two bodies during a run by the lines of `mdana emit --for lammps-inline`: no atoms, but sums over
/// those of each body. Columns: time, time step dt, and for b = 1, 2 number of atoms n, mass m, centre of mass x y z, its velocity
/// vx vy vz, summed force fx fy fz, and kinetic energy about the centre of mass Kt, angular momentum
/// Lx Ly Lz and moments of inertia Ixx Iyy Izz Ixy Iyz Ixz about it; potential energy W, if it was asked for.
struct InlineLog {
  std::string path;
  Units units = Units::lj;
  Interaction interaction = Interaction::unknown;
  std::vector<double> radii;        ///< [length] of body 1, 2, as the scene stated them; else empty
  std::string radius_definition;
  std::string bodies;               ///< in words
  std::vector<std::string> columns; ///< besides the step
  std::vector<std::int64_t> steps;
  std::vector<std::vector<double>> values;  ///< a column each
  std::vector<double> last_digit;   ///< of each column, the unit of the finest printed digit
  std::string cut;                  ///< what is missing at the end; else empty
  InputRecord input;

  /// Null if there is none.
  const std::vector<double>* find(std::string_view column) const;
  bool has(std::string_view column) const { return find(column) != nullptr; }
};

/// The first words of such a file, and of its line of columns.
inline constexpr std::string_view inline_title = "# mdana-inline 1 ";
inline constexpr std::string_view inline_columns_title = "# TimeStep ";

/// Names of the columns besides the step, in their order: time and time step dt, then those of body 1 and of body 2.
std::vector<std::string> inline_columns(bool potential);

/// By its first bytes. False if there is no such file, too.
bool is_inline_log(const std::filesystem::path& path);

/// Reads such a file, plain or compressed; of one that ends within a row, as while LAMMPS runs, the whole rows. Throws InputError naming
/// the line if the head or a row is not as it is written, a value is not finite, or steps do not grow.
InlineLog read_inline_log(const std::filesystem::path& path);

}  // namespace mdana
