// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/surroundings.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace mdana::defects {
namespace {

/// Where the atoms of two zones are in the one of both.
struct Places {
  std::vector<std::uint32_t> of_first, of_second;
};

void append(Zone& zone, const Zone& from, std::size_t i) {
  zone.atom.push_back(from.atom[i]);
  zone.at.push_back(from.at[i]);
  zone.number.push_back(from.number[i]);
  zone.body.push_back(from.body[i]);
  zone.seed.push_back(from.seed[i]);
}

Zone united(const Zone& a, const Zone& b, Places& places) {
  Zone both;
  both.origin = a.origin;
  both.spacing = a.spacing;
  for (std::size_t i = 0, k = 0; i < a.size() || k < b.size();) {
    const bool first = k == b.size() || (i < a.size() && a.atom[i] <= b.atom[k]);
    const bool second = i == a.size() || (k < b.size() && b.atom[k] <= a.atom[i]);
    const auto place = static_cast<std::uint32_t>(both.size());
    append(both, first ? a : b, first ? i : k);
    if (second) both.seed.back() = std::max(both.seed.back(), b.seed[k]);
    if (first) places.of_first.push_back(place), ++i;
    if (second) places.of_second.push_back(place), ++k;
  }
  return both;
}

void move_to(std::vector<Tetrahedron>& cells, const std::vector<std::uint32_t>& places) {
  for (Tetrahedron& t : cells)
    for (std::uint32_t& corner : t) corner = places[corner];
}

/// Both without what is in both, in order.
template <class T, class By>
std::vector<T> merged(const std::vector<T>& a, const std::vector<T>& b, const By& by) {
  std::vector<T> all;
  all.reserve(a.size() + b.size());
  std::ranges::set_union(a, b, std::back_inserter(all), {}, by, by);
  return all;
}

}  // namespace

void Surroundings::add(Surroundings other) {
  if (zone.size() == 0) {
    *this = std::move(other);
    return;
  }
  Places places;
  zone = united(zone, other.zone, places);
  move_to(cells, places.of_first);
  move_to(other.cells, places.of_second);
  cells = merged(cells, other.cells, std::identity());
  own = merged(own, other.own, &OwnFrame::index);
}

}  // namespace mdana::defects
