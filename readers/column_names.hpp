// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace mdana {

// More is a sign of damage. LAMMPS has no limits of its own.
constexpr std::size_t most_columns = 4096;
constexpr std::size_t longest_column_name = 256;  ///< [bytes]

/// What is wrong with the names of a frame's columns: too many, too long, one twice. Empty if nothing.
std::string wrong_names(std::span<const std::string> columns);

}  // namespace mdana
