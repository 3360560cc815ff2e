// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace mdana::fuzz {

// One function a reader, in fuzz_<reader>.cpp: reads the bytes as the file of a user. Reading them or
// refusing them clearly (see reading.hpp) is right; whatever else leaves the function is a defect.
void amber_netcdf(std::string_view bytes);
void document(std::string_view bytes);
void frame_index(std::string_view bytes);
void gzip(std::string_view bytes);
void h5md(std::string_view bytes);
void lammps_binary(std::string_view bytes);
void lammps_text(std::string_view bytes);
void lammps_yaml(std::string_view bytes);
void local_dump(std::string_view bytes);
void scene(std::string_view bytes);
void study(std::string_view bytes);
void table(std::string_view bytes);
void thermo_log(std::string_view bytes);
void zstd(std::string_view bytes);

}  // namespace mdana::fuzz
