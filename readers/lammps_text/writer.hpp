// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "readers/frame_writer.hpp"

namespace mdana::lammps_text {

/// Writes a text dump, compressed if the name ends in `.gz` or `.zst`. Real numbers are the shortest
/// decimals that read back as the same bits.
std::unique_ptr<FrameWriter> create_writer(const std::filesystem::path& path);

}  // namespace mdana::lammps_text
