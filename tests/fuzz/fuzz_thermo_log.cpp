// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/thermo_log.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void thermo_log(std::string_view bytes) {
  const auto file = input_file("log.lammps", bytes);
  is_lammps_log(file);
  read_or_refuse(file, [&] { join_sections(read_thermo_log(file)); });
}

}  // namespace mdana::fuzz
