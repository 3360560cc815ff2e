// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "readers/amber_netcdf/classic_header.hpp"
#include "readers/amber_netcdf/netcdf_file.hpp"
#include "readers/units.hpp"

namespace mdana::amber_netcdf {

/// A variable that has numbers for every atom.
struct AtomVariable {
  int id;
  std::string name;
  Type type;
  std::size_t numbers;  ///< of one atom
  bool in_frames;       ///< else the same for all frames
  double scale;         ///< that numbers are multiplied by
  std::string fill;     ///< bytes of numbers that were never written; empty if there are none
};

/// A column: one number of each atom.
struct AtomColumn {
  std::string name;
  std::optional<std::size_t> variable;  ///< nothing: the atom's number in the file, 1, 2 ...
  std::size_t place = 0;                ///< among the variable's numbers of an atom
};

/// One or three numbers a frame (or the same for all frames).
struct FrameVariable {
  int id;
  Type type;
  std::size_t numbers;
  bool in_frames;
  double scale;
  std::string fill;
};

/// What AMBER's convention says of a file's variables, which is the same for all frames.
struct Content {
  std::uint64_t frames = 0;  ///< as the header says
  bool frames_are_records = true;
  std::uint64_t atoms = 0;
  std::vector<AtomVariable> variables;
  std::vector<AtomColumn> columns;
  std::optional<FrameVariable> time, step, origin, lengths, angles;
  bool time_counts_steps = false;  ///< LAMMPS: its unscaled numbers are steps
  std::optional<Units> units;
};

/// Throws InputError if the file does not follow the convention.
Content read_content(const ClassicHeader& header, const NetcdfFile& file, const std::string& path);

}  // namespace mdana::amber_netcdf
