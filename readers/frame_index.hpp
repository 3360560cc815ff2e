// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mdana {

/// Where the frames of a large plain file begin, kept in a file beside it (<name>.mdana-index) so
/// that a later run can go to a frame without reading what lies before.
struct FrameIndex {
  struct Entry {
    std::uint64_t offset;  ///< of the frame's first byte
    std::uint64_t line;    ///< before it, of a text
    std::int64_t step;
    std::uint64_t atoms;
  };
  std::vector<Entry> frames;  ///< all of the file
  std::string hash;           ///< of the whole file, see InputRecord
};

/// Files smaller than this get no index: reading them takes less than a second.
constexpr std::uint64_t least_indexed_size = std::uint64_t{256} << 20;

/// The index beside the file, if it fits: the file's size, time of change and a sample of its
/// content are those of when the index was made. Nothing if there is none, or it is damaged or of
/// another state of the file.
std::optional<FrameIndex> load_frame_index(const std::filesystem::path& file);

/// Writes the index beside the file, whole or not at all. False if that is not possible there, and on other ranks than the
/// first.
bool save_frame_index(const FrameIndex& index, const std::filesystem::path& file);

/// The name of the index.
std::filesystem::path frame_index_path(const std::filesystem::path& file);

/// The index of a file that is being read: filled frame by frame, written when the end is reached,
/// looked up to go ahead.
class FrameIndexing {
 public:
  explicit FrameIndexing(std::filesystem::path file) : file_(std::move(file)) {}

  /// Frame number `number` was met.
  void met(std::uint64_t number, const FrameIndex::Entry& frame);

  /// The end was reached behind so many frames. Whether an index is to be written: the file is large,
  /// all frames were met, and no index fits.
  bool wanted(std::uint64_t frames, std::uint64_t size) const;
  void write(const std::string& hash) const;

  /// The frame `number`, or the last one before it that there is, if an index fits; and its number.
  struct Found {
    std::uint64_t number;
    FrameIndex::Entry frame;
    std::string hash;  ///< of the file
  };
  std::optional<Found> find(std::uint64_t number);

  /// The file is not as the index says: it is not used again, and written anew if the end is reached.
  void discard() { loaded_.reset(); }

 private:
  std::filesystem::path file_;
  std::vector<FrameIndex::Entry> met_;
  bool looked_ = false;
  std::optional<FrameIndex> loaded_;
};

}  // namespace mdana
