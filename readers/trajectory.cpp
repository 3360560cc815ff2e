// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/trajectory.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

const Format& recognise(ByteSource& bytes, const std::filesystem::path& path) {
  std::array<char, 4096> head;
  bytes.mark();
  const std::string_view text(head.data(), bytes.read(head));
  bytes.reset();
  if (text.empty() && bytes.damage().empty())
    throw InputError(fmt::format("{}: the file is empty", path.string()));
  for (const Format* format : formats())
    if (format->recognises(text)) return *format;
  throw InputError(fmt::format("{}: not a dump that mdana knows{}", path.string(),
                               bytes.damage().empty() ? "" : ": " + bytes.damage()));
}

}  // namespace

std::unique_ptr<FrameSource> open_trajectory(const std::filesystem::path& path,
                                             const ColumnSet& wanted) {
  auto bytes = open_bytes(path);
  const Format& format = recognise(*bytes, path);
  return format.open(std::move(bytes), path, wanted);
}

std::string_view format_of(const std::filesystem::path& path) {
  const auto bytes = open_bytes(path);
  return recognise(*bytes, path).name;
}

FrameHeader first_header(const std::filesystem::path& path) {
  FrameHeader header;
  if (!open_trajectory(path, {})->next(header))
    throw InputError(fmt::format("{}: no frame in the file", path.string()));
  return header;
}

}  // namespace mdana
