// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "readers/frame.hpp"
#include "readers/lammps_binary/stretches.hpp"

namespace mdana::lammps_binary {

struct Header {
  FrameHeader frame;
  bool swapped = false;    ///< numbers are not in this machine's byte order
  std::int32_t ranks = 1;  ///< blocks that the atoms come in, one from each rank of the run
};

/// Reads what stands before a frame's atoms. Nothing at a clean end of the file; throws
/// TruncatedInput if it ends within the header and InputError if the header is wrong.
std::optional<Header> read_header(Stretches& file, std::uint64_t index);

/// By the first bytes: the beginning of a header that names itself (since October 2020).
bool begins_header(std::string_view head);

/// By the first bytes: a whole header of the time before.
bool begins_old_header(std::string_view head);

}  // namespace mdana::lammps_binary
