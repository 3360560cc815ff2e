// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/trajectory.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>

#include "readers/file_set.hpp"
#include "readers/inline_log.hpp"
#include "readers/input_error.hpp"
#include "readers/pieces_source.hpp"
#include "readers/sequence_source.hpp"

namespace mdana {
namespace {

/// Null if no format recognises the file.
const Format* find_format(ByteSource& bytes, const std::filesystem::path& path) {
  std::array<char, 4096> head;
  bytes.mark();
  const std::string_view text(head.data(), bytes.read(head));
  bytes.reset();
  if (text.empty() && bytes.damage().empty())
    throw InputError(fmt::format("{}: the file is empty", path.string()));
  for (const Format* format : formats())
    if (format->recognises(text)) return format;
  if (text.starts_with(inline_title))
    throw InputError(fmt::format("{}: holds no atoms, but sums over two bodies that LAMMPS wrote (mdana emit --for lammps-inline): force, "
                                 "fit-hertz, fit-force and energy tell of it", path.string()));
  return nullptr;
}

const Format& recognise(ByteSource& bytes, const std::filesystem::path& path) {
  if (const Format* format = find_format(bytes, path)) return *format;
  throw InputError(fmt::format("{}: not a dump that mdana knows{}", path.string(),
                               bytes.damage().empty() ? "" : ": " + bytes.damage()));
}

std::unique_ptr<FrameSource> open_file(const std::filesystem::path& path, const ColumnSet& wanted) {
  auto bytes = open_bytes(path);
  const Format& format = recognise(*bytes, path);
  return format.open(std::move(bytes), path, wanted);
}

using Paths = std::vector<std::filesystem::path>;

std::unique_ptr<FrameSource> open_pieces(const Paths& files, const ColumnSet& wanted) {
  if (files.size() == 1) return open_file(files.front(), wanted);
  std::vector<std::unique_ptr<FrameSource>> pieces;
  for (const auto& file : files) pieces.push_back(open_file(file, wanted));
  return join_pieces(std::move(pieces));
}

std::filesystem::path first_file(const std::filesystem::path& path) {
  const auto files = find_file_set(path);
  return files ? files->front().front() : path;
}

}  // namespace

std::unique_ptr<FrameSource> open_trajectory(const std::filesystem::path& path,
                                             const ColumnSet& wanted) {
  auto files = find_file_set(path);
  if (!files) return open_file(path, wanted);
  if (files->size() == 1) return open_pieces(files->front(), wanted);
  return open_sequence(std::move(*files),
                       [wanted](const Paths& pieces) { return open_pieces(pieces, wanted); });
}

std::string_view format_of(const std::filesystem::path& path) {
  const std::filesystem::path first = first_file(path);
  return recognise(*open_bytes(first), first).name;
}

std::optional<std::string_view> recognised_format(const std::filesystem::path& path) {
  const std::filesystem::path first = first_file(path);
  const Format* format = find_format(*open_bytes(first), first);
  if (!format) return std::nullopt;
  return format->name;
}

const Format* format_to_write(const std::filesystem::path& name) {
  for (const Format* format : formats()) {
    if (!format->create) continue;
    std::istringstream endings{std::string(format->ending)};
    for (std::string ending; endings >> ending;)
      if (name.filename().string().ends_with("." + ending)) return format;
  }
  return nullptr;
}

std::uint64_t count_frames(const std::filesystem::path& path) {
  const auto source = open_trajectory(path, {});
  FrameHeader header;
  std::uint64_t frames = 0;
  try {
    while (source->next(header)) ++frames;
  } catch (const InputError&) {
    if (frames == 0) throw;  // else the sweep will tell
  }
  return frames;
}

FrameHeader first_header(const std::filesystem::path& path) {
  FrameHeader header;
  if (!open_trajectory(path, {})->next(header))
    throw InputError(fmt::format("{}: no frame in the file", path.string()));
  return header;
}

}  // namespace mdana
