// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/slim_svg.hpp"

#include <algorithm>
#include <vector>

namespace mdana {
namespace {

/// Lines without indentation; empty ones are left out.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// A symbol of points that the picture does not show. Symbols refer to others of a lower number.
bool unused_symbol(std::string_view line, std::string_view svg) {
  const std::size_t id = line.find("id='gp");
  if (id == std::string_view::npos) return false;
  const std::string_view name = line.substr(id + 4, line.find('\'', id + 4) - id - 4);
  return svg.find("#" + std::string(name) + "'") == std::string_view::npos;
}

std::string without(std::string text, std::string_view part) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;) text.erase(at, part.size());
  return text;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// 12.34 -> 12.3
std::string one_decimal(std::string_view line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool second = i >= 2 && line[i - 2] == '.' && is_digit(line[i - 1]) && is_digit(line[i]) &&
                        (i + 1 == line.size() || !is_digit(line[i + 1]));
    if (!second) text += line[i];
  }
  return text;
}

/// Words stay as they are.
std::string kept(std::string_view line) {
  return line.find("<text") == std::string_view::npos ? one_decimal(line) : std::string(line);
}

}  // namespace

std::string slim_svg(std::string_view svg) {
  const std::vector<std::string_view> lines = lines_of(svg);
  std::string text;
  bool filter = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    filter = filter || lines[i].starts_with("<filter");
    if (lines[i].starts_with("<g fill=\"none\"") && i + 1 < lines.size() && lines[i + 1] == "</g>")
      ++i;
    else if (!filter && !unused_symbol(lines[i], svg))
      text += kept(lines[i]) + "\n";
    if (lines[i].starts_with("</filter")) filter = false;
  }
  return without(without(std::move(text), " stroke-linecap=\"butt\""), " stroke-linejoin=\"miter\"");
}

}  // namespace mdana
