// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

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

/// The header of the first frame. Throws InputError if there is none.
FrameHeader first_header(const std::filesystem::path& path);

/// Calls `use(block)` for each block of the first frame in order, of selected atoms if there is a
/// selection; throws as reading does.
template <class Use>
FrameHeader for_first_frame(const std::filesystem::path& path, ColumnSet wanted, Use&& use,
                            const std::optional<Selection>& selection = {}) {
  if (selection) wanted.select(*selection);
  const auto source = open_trajectory(path, wanted);
  FrameHeader header;
  if (!source->next(header)) return header;
  Chunk chunk;
  AtomBlock block;
  while (source->cut(chunk)) {
    convert(chunk, block);
    use(static_cast<const AtomBlock&>(block));
  }
  return header;
}

}  // namespace mdana
