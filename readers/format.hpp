// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
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

  /// Makes `next` give frame `index`, not before the one it would give, without reading what lies
  /// between, if the format can; else does nothing. Frames passed over are not validated.
  virtual void seek(std::uint64_t) {}

  /// How much of the input lies behind, 0 to 1; nothing if that is not known.
  virtual std::optional<double> share() const { return std::nullopt; }

  /// Back to the first atom of the current frame.
  virtual void restart_frame() = 0;

  /// Said before the first frame by those who go on after faults: a frame with fewer atoms than its
  /// header says then ends where the next header begins, if the format tells them apart; its last
  /// chunk may be short. `cut` gives all atoms that are there before it throws.
  virtual void expect_faults() {}

  /// After `next` or `cut` has thrown: passes on to where the next frame may begin, if that can be
  /// found. A frame whose header was wrong counts for the numbers of the following ones.
  virtual bool recover() { return false; }

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
