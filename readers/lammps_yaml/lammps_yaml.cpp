// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/atom_lines.hpp"
#include "readers/format.hpp"
#include "readers/lammps_yaml/header.hpp"
#include "readers/lammps_yaml/rows.hpp"

namespace mdana {
namespace {

std::shared_ptr<const FrameLayout> layout(const FrameHeader& header, const ColumnSet& wanted,
                                          const std::string& path) {
  return std::make_shared<lammps_yaml::Rows>(header, wanted, path);
}

std::unique_ptr<FrameSource> open(std::unique_ptr<ByteSource> bytes,
                                  const std::filesystem::path& path, const ColumnSet& wanted) {
  return open_atom_lines({lammps_yaml::read_header, layout}, std::move(bytes), path, wanted);
}

}  // namespace

extern const Format lammps_yaml_format;
const Format lammps_yaml_format{"lammps_yaml", "LAMMPS YAML dump (style yaml)",
                                lammps_yaml::begins_header, open};

}  // namespace mdana
