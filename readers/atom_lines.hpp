// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "readers/format.hpp"
#include "readers/line_reader.hpp"

namespace mdana {

/// A dump whose atoms stand one a line, behind the header of their frame.
struct AtomLineDump {
  /// Reads up to the first atom of the frame. Nothing at a clean end of the text; throws
  /// TruncatedInput if it ends within the header and InputError if the header is wrong.
  std::optional<FrameHeader> (*read_header)(LineReader& lines, const std::string& path,
                                            std::uint64_t index);

  /// What its lines look like. Throws InputError if the frame lacks a wanted column.
  std::shared_ptr<const FrameLayout> (*layout)(const FrameHeader& header, const ColumnSet& wanted,
                                               const std::string& path);

  /// What the lines of a header's sections begin with, and those of atoms do not; empty if they cannot
  /// be told apart, and then nothing goes on after faults.
  std::string_view section_start{};
  /// From the beginning of a faulty header to that of the next one; false if there is none.
  bool (*to_next_header)(LineReader& lines) = nullptr;
};

/// The frames of such a dump; `path` is for messages.
std::unique_ptr<FrameSource> open_atom_lines(const AtomLineDump& dump,
                                             std::unique_ptr<ByteSource> bytes,
                                             const std::filesystem::path& path,
                                             const ColumnSet& wanted);

}  // namespace mdana
