// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "readers/byte_source.hpp"
#include "readers/columns.hpp"
#include "readers/frame_layout.hpp"
#include "readers/frame_writer.hpp"

namespace mdana {

/// The frames of one open input. Cutting is serial; chunks are converted by their own layout, on any
/// thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Moves to the next frame, passing over what is left of this one. False at a clean end.
  /// Throws TruncatedInput, or InputError if a header is wrong.
  virtual bool next(FrameHeader& header) = 0;

  /// The next `most` atoms of the frame (fewer in its last chunk), unconverted. False after the
  /// last. Throws TruncatedInput.
  virtual bool cut(Chunk& chunk, std::size_t most = AtomBlock::capacity) = 0;

  /// Back to the first atom of the current frame.
  virtual void restart_frame() = 0;

  virtual std::vector<InputRecord> records() = 0;  ///< one a file
};

/// A file format: metadata and functions. The list of formats is in CMakeLists.txt
/// (MDANA_FORMATS); each defines `extern const Format <name>_format`.
struct Format {
  std::string_view name;
  std::string_view summary;
  bool (*recognises)(std::string_view head);  ///< by the first decompressed bytes
  std::unique_ptr<FrameSource> (*open)(std::unique_ptr<ByteSource> bytes,
                                       const std::filesystem::path& path, const ColumnSet& wanted);

  /// Of formats that are written, too: the endings of file names, as words ("dump dump.gz"), and what
  /// opens a new file.
  std::string_view ending{};
  std::unique_ptr<FrameWriter> (*create)(const std::filesystem::path& path) = nullptr;
};

/// All formats of this build.
std::span<const Format* const> formats();

}  // namespace mdana
