// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "readers/block.hpp"
#include "readers/byte_source.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// The frames of one open input. Cutting is serial; converting a chunk needs nothing but the chunk
/// and may run on any thread while the next chunk is cut (not while `next` moves on).
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Moves to the next frame, passing over what is left of this one. False at a clean end.
  /// Throws TruncatedInput, or InputError if a header is wrong.
  virtual bool next(FrameHeader& header) = 0;

  /// The next AtomBlock::capacity atoms of the frame (fewer in its last chunk), unconverted.
  /// False after the last. Throws TruncatedInput.
  virtual bool cut(Chunk& chunk) = 0;

  /// Fills the wanted columns, and no others, of a chunk of the current frame.
  /// Throws InputError naming line and column.
  virtual void convert(const Chunk& chunk, AtomBlock& block) const = 0;

  /// Back to the first atom of the current frame.
  virtual void restart_frame() = 0;

  /// Significant digits that the numbers of a column are printed with, estimated from the chunk;
  /// 0 for columns that are not decimal text.
  virtual int printed_digits(const Chunk& chunk, std::string_view column) const = 0;

  virtual InputRecord record() = 0;
};

/// A file format: metadata and two functions. The list of formats is in CMakeLists.txt
/// (MDANA_FORMATS); each defines `extern const Format <name>_format`.
struct Format {
  std::string_view name;
  std::string_view summary;
  bool (*recognises)(std::string_view head);  ///< by the first decompressed bytes
  std::unique_ptr<FrameSource> (*open)(std::unique_ptr<ByteSource> bytes,
                                       const std::filesystem::path& path, const ColumnSet& wanted);
};

/// All formats of this build.
std::span<const Format* const> formats();

}  // namespace mdana
