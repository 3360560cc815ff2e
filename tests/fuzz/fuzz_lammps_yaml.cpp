// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void lammps_yaml(std::string_view bytes) { read_dump(input_file("lammps_yaml.input", bytes)); }

}  // namespace mdana::fuzz
