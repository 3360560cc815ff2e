// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/frame_choice.hpp"

#include <array>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

[[noreturn]] void unclear(const std::string& text) {
  throw InputError(fmt::format(
      "frames '{}': FIRST:END or FIRST:END:STRIDE expected, counted from 0, without END", text));
}

std::optional<std::uint64_t> number(std::string_view part, const std::string& text) {
  if (part.empty()) return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc{} || end != part.data() + part.size()) unclear(text);
  return value;
}

}  // namespace

std::optional<std::uint64_t> FrameChoice::at_or_after(std::uint64_t index) const {
  std::uint64_t chosen = first;
  if (index > first) {
    const std::uint64_t beyond = (index - first) % stride;
    chosen = beyond == 0 ? index : index + (stride - beyond);
  }
  if (chosen < index || (end && chosen >= *end)) return std::nullopt;
  return chosen;
}

FrameChoice parse_frame_choice(const std::string& text) {
  std::array<std::optional<std::uint64_t>, 3> parts;
  std::string_view rest = text;
  std::size_t k = 0;
  for (;; ++k) {
    if (k == parts.size()) unclear(text);
    const std::size_t colon = rest.find(':');
    parts[k] = number(rest.substr(0, colon), text);
    if (colon == std::string_view::npos) break;
    rest.remove_prefix(colon + 1);
  }
  if (k == 0) unclear(text);
  const FrameChoice choice{parts[0].value_or(0), parts[1], parts[2].value_or(1)};
  if (choice.stride == 0 || (choice.end && *choice.end <= choice.first)) unclear(text);
  return choice;
}

}  // namespace mdana
