// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "readers/format.hpp"
#include "readers/selection.hpp"

namespace mdana {

/// Opens a dump of any known format for the wanted columns: a file, or a set of files by a name with
/// `*` and `%` (see readers/file_set.hpp).
/// Throws InputError if it is missing, empty or of no known format.
std::unique_ptr<FrameSource> open_trajectory(const std::filesystem::path& path,
                                             const ColumnSet& wanted);

/// The name of the format that recognises the (first) file; throws like open_trajectory.
std::string_view format_of(const std::filesystem::path& path);

/// The same; nothing if no format does. Throws InputError if the file is missing.
std::optional<std::string_view> recognised_format(const std::filesystem::path& path);

/// The format that files of this name are written in, by its ending; null if there is none.
const Format* format_to_write(const std::filesystem::path& name);

/// How many frames can be told apart, without reading their atoms; throws like open_trajectory.
std::uint64_t count_frames(const std::filesystem::path& path);

/// The header of the first frame. Throws InputError if there is none.
FrameHeader first_header(const std::filesystem::path& path);

/// Calls `use(block)` for each block of frame `index` (counted from 0) in order, of selected atoms if
/// there is a selection; throws as reading does. Without such a frame the header is empty.
template <class Use>
FrameHeader for_frame(const std::filesystem::path& path, std::uint64_t index, ColumnSet wanted,
                      Use&& use, const std::optional<Selection>& selection = {}) {
  if (selection) wanted.select(*selection);
  const auto source = open_trajectory(path, wanted);
  FrameHeader header;
  if (index > 0) source->seek(index);
  do {
    if (!source->next(header)) return {};
  } while (header.index < index);
  Chunk chunk;
  AtomBlock block;
  while (source->cut(chunk)) {
    convert(chunk, block);
    use(static_cast<const AtomBlock&>(block));
  }
  return header;
}

/// The same of the first frame.
template <class Use>
FrameHeader for_first_frame(const std::filesystem::path& path, const ColumnSet& wanted, Use&& use,
                            const std::optional<Selection>& selection = {}) {
  return for_frame(path, 0, wanted, std::forward<Use>(use), selection);
}

}  // namespace mdana
