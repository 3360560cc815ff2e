// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "readers/columns.hpp"
#include "readers/frame_layout.hpp"

namespace mdana {

/// Adds to every wanted real column that the dump prints as decimal text a random number, uniform
/// within half a unit of the value's last printed digit: what the dump leaves open about the value.
/// Masses are constants of the model and stay.
/// The same seed moves the same value in the same way, whatever the threads or memory. Positions
/// are moved by the digits of the columns that they are made from.
void move_last_digits(const Chunk& chunk, const FrameHeader& header, const ColumnSet& wanted,
                      std::uint64_t seed, AtomBlock& block);

/// Rounds the same columns to so many decimal digits fewer than the dump prints.
void drop_digits(const Chunk& chunk, const FrameHeader& header, const ColumnSet& wanted, int dropped, AtomBlock& block);

/// Standard deviation that rounding to the printed digits gives the numbers of a real column, by the
/// first block of the dump; 0 if they are exact. For `x` of positions in the length unit, whatever
/// columns they are made from. Throws InputError as reading does. `dropped`: after drop_digits.
double rounding_of(const std::filesystem::path& dump, const std::string& column, int dropped = 0);

}  // namespace mdana
