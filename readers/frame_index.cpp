// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/frame_index.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include "readers/ranks.hpp"

namespace mdana {
namespace {

constexpr std::string_view title = "mdana-index 1";
constexpr std::size_t sample_size = 4096;
constexpr std::uint64_t samples = 64;
constexpr std::uintmax_t longest_index = std::uintmax_t{1} << 28;  ///< in bytes: 10^7 frames

std::string hash_text(std::string_view bytes) {
  const XXH128_hash_t h = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", h.high64, h.low64);
}

/// Pieces of the file from its start to its end, evenly spaced.
std::string sampled(const std::filesystem::path& file, std::uint64_t size) {
  std::ifstream stream(file, std::ios::binary);
  std::string content;
  std::array<char, sample_size> piece;
  for (std::uint64_t k = 0; k < samples && stream; ++k) {
    const std::uint64_t last = size > sample_size ? size - sample_size : 0;
    stream.seekg(static_cast<std::streamoff>(last / (samples - 1) * k + (k + 1 == samples ? last % (samples - 1) : 0)));
    stream.read(piece.data(), piece.size());
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    stream.clear();
  }
  return hash_text(content);
}

/// What tells one state of a file from another; nothing if the file cannot be looked at.
std::optional<std::string> state_of(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return fmt::format("size {} time {}.{:09} sample {}", size, status.st_mtim.tv_sec,
                     status.st_mtim.tv_nsec, sampled(file, size));
}

std::string body(const FrameIndex& index, const std::string& state) {
  std::string text = fmt::format("{}\n{}\nhash {}\nframes {}\n", title, state, index.hash,
                                 index.frames.size());
  for (const auto& e : index.frames)
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", e.offset, e.line, e.step, e.atoms);
  return text;
}

/// The text before the last line, if that line is its hash.
std::optional<std::string> checked_body(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  if (unknown || size > longest_index) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::size_t end = text.rfind("check ");
  if (end == std::string::npos) return std::nullopt;
  const std::string check = text.substr(end);
  text.resize(end);
  if (check != fmt::format("check {}\n", hash_text(text))) return std::nullopt;
  return text;
}

std::optional<FrameIndex> parse(const std::string& text, const std::string& state) {
  std::istringstream lines(text);
  std::string line, word;
  if (!std::getline(lines, line) || line != title) return std::nullopt;
  if (!std::getline(lines, line) || line != state) return std::nullopt;
  FrameIndex index;
  std::size_t count = 0;
  if (!(lines >> word >> index.hash >> word >> count)) return std::nullopt;
  FrameIndex::Entry e{};
  while (lines >> e.offset >> e.line >> e.step >> e.atoms) index.frames.push_back(e);
  if (index.frames.size() != count) return std::nullopt;
  return index;
}

}  // namespace

void FrameIndexing::met(std::uint64_t number, const FrameIndex::Entry& frame) {
  if (number == met_.size()) met_.push_back(frame);
}

bool FrameIndexing::wanted(std::uint64_t frames, std::uint64_t size) const {
  return size >= least_indexed_size && frames > 0 && met_.size() == frames && !loaded_ &&
         !load_frame_index(file_);
}

void FrameIndexing::write(const std::string& hash) const { save_frame_index({met_, hash}, file_); }

std::optional<FrameIndexing::Found> FrameIndexing::find(std::uint64_t number) {
  if (!looked_) loaded_ = load_frame_index(file_);
  looked_ = true;
  if (!loaded_ || loaded_->frames.empty()) return std::nullopt;
  number = std::min<std::uint64_t>(number, loaded_->frames.size() - 1);
  return Found{number, loaded_->frames[number], loaded_->hash};
}

std::filesystem::path frame_index_path(const std::filesystem::path& file) {
  return file.string() + ".mdana-index";
}

std::optional<FrameIndex> load_frame_index(const std::filesystem::path& file) {
  const auto text = checked_body(frame_index_path(file));
  if (!text) return std::nullopt;
  const auto state = state_of(file);
  return state ? parse(*text, *state) : std::nullopt;
}

bool save_frame_index(const FrameIndex& index, const std::filesystem::path& file) {
  if (!is_first_rank()) return false;
  const auto state = state_of(file);
  if (!state) return false;
  std::string text = body(index, *state);
  text += fmt::format("check {}\n", hash_text(text));
  const std::filesystem::path path = frame_index_path(file);
  const std::filesystem::path temporary = fmt::format("{}.{}", path.string(), ::getpid());
  std::error_code failed;
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
      std::filesystem::remove(temporary, failed);
      return false;
    }
  }
  std::filesystem::rename(temporary, path, failed);
  if (failed) std::filesystem::remove(temporary, failed);
  return !failed;
}

}  // namespace mdana
