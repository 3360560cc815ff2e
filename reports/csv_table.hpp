// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "analyses/table.hpp"

namespace mdana {

/// A table that is read from CSV: columns with a cell that is no number are labels. Dimensions are not known.
/// Throws InputError with file and line.
Table read_csv_table(const std::filesystem::path& file);

}  // namespace mdana
