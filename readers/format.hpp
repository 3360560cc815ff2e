// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "readers/block.hpp"
#include "readers/byte_source.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// How decimal text shows the numbers of a column.
struct PrintedPrecision {
  int digits = 0;      ///< significant digits at most; 0 if the column is not decimal fractions
  int decimals = 0;    ///< digits behind the point at most
  bool fixed = false;  ///< every number has as many decimals (as by %.6f), else digits count (%.10g)
};

/// The frames of one open input. Cutting is serial; converting a chunk needs nothing but the chunk
/// and may run on any thread while the next chunk is cut (not while `next` moves on).
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Moves to the next frame, passing over what is left of this one. False at a clean end.
  /// Throws TruncatedInput, or InputError if a header is wrong.
  virtual bool next(FrameHeader& header) = 0;

  /// The next `most` atoms of the frame (fewer in its last chunk), unconverted. False after the
  /// last. Throws TruncatedInput.
  virtual bool cut(Chunk& chunk, std::size_t most = AtomBlock::capacity) = 0;

  /// Fills the wanted columns, and no others, of a chunk of the current frame.
  /// Throws InputError naming line and column.
  virtual void convert(const Chunk& chunk, AtomBlock& block) const = 0;

  /// Back to the first atom of the current frame.
  virtual void restart_frame() = 0;

  /// How the numbers of a column are printed, estimated from the chunk.
  virtual PrintedPrecision printed_precision(const Chunk& chunk, std::string_view column) const = 0;

  virtual std::vector<InputRecord> records() = 0;  ///< one a file
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
