// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/dislocation_lines.hpp"

#include <algorithm>
#include <cmath>

namespace mdana {

std::string_view name(LineFamily family) {
  constexpr std::array<std::string_view, line_families> names{"perfect", "shockley", "stair_rod", "hirth", "frank", "other"};
  return names[static_cast<std::size_t>(family)];
}

std::string_view name(LineEnd end) {
  constexpr std::array<std::string_view, 6> names{"junction", "surface", "contact", "lattice", "inside", "closed"};
  return names[static_cast<std::size_t>(end)];
}

Value DislocationLines::length(BodyIndex body, std::optional<LineFamily> family) const {
  double sum = 0, alike = 0, square = 0;
  for (const DislocationSegment& s : segments) {
    if ((body != 0 && s.body != body) || (family && s.family != *family)) continue;
    sum += s.length.value;
    if (s.ends[0] != LineEnd::closed) alike += *s.length.error;
    else square += *s.length.error * *s.length.error;
  }
  return {sum, std::hypot(alike, std::sqrt(square)), dimension::length};
}

double DislocationLines::length_below(double shortest) const {
  double sum = 0;
  for (const DislocationSegment& s : segments)
    if (s.length.value < shortest) sum += s.length.value;
  return sum;
}

}  // namespace mdana
