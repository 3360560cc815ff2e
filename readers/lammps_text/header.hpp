// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "readers/frame.hpp"
#include "readers/line_reader.hpp"

namespace mdana::lammps_text {

/// What the first line of every section begins with.
inline constexpr std::string_view section_start = "ITEM: ";

/// The first word of a section: TIMESTEP, TIME, UNITS, NUMBER, BOX, ATOMS.
std::string section_name(std::string_view item);

/// Reads the ITEM sections before a frame's atoms. Nothing at a clean end of the text; throws
/// TruncatedInput if it ends within the header and InputError if the header is wrong.
std::optional<FrameHeader> read_header(LineReader& lines, const std::string& path,
                                       std::uint64_t index);

}  // namespace mdana::lammps_text
