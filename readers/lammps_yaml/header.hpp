// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "readers/frame.hpp"
#include "readers/line_reader.hpp"

namespace mdana::lammps_yaml {

/// Reads the end of the frame before ("...") and what stands before the rows of this one. Nothing
/// at a clean end of the text; throws TruncatedInput if it ends within the header or without the
/// "...", and InputError if the header is wrong.
std::optional<FrameHeader> read_header(LineReader& lines, const std::string& path,
                                       std::uint64_t index);

/// By the first bytes of a file.
bool begins_header(std::string_view head);

}  // namespace mdana::lammps_yaml
