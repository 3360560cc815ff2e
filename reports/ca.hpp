// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "analyses/dislocation_lines.hpp"
#include "readers/box.hpp"

namespace mdana {

/// Writes the lines as a Crystal Analysis file (.ca, version 6), which OVITO opens; whole or not at all.
void write_ca(const std::filesystem::path& path, const DislocationLines& lines, const Box& box);

}  // namespace mdana
