// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

/// A dump without names of columns has them in a file beside it; here there always is one.
void lammps_binary(std::string_view bytes) {
  input_file("lammps_binary.input.columns", "id type x y z\n");
  read_dump(input_file("lammps_binary.input", bytes));
}

}  // namespace mdana::fuzz
