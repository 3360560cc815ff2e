// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/grain_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "readers/cell_list.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// A grain on average; hard grains of any radii have some 6 to 12.
constexpr std::size_t most_contacts = 64;

std::string place(const Grain& grain) {
  return fmt::format("at {:.9g} {:.9g} {:.9g}", grain.position.x(), grain.position.y(),
                     grain.position.z());
}

void check(std::span<const Grain> grains) {
  if (grains.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("more than 4294967295 grains");
  for (const Grain& grain : grains) {
    if (!grain.position.allFinite())
      throw InputError(
          fmt::format("a grain of body {} is {}: not a place", grain.body, place(grain)));
    if (!(grain.radius > 0) || !std::isfinite(grain.radius))
      throw InputError(fmt::format("the grain {} has the radius {:g}; it must be positive",
                                   place(grain), grain.radius));
  }
}

Eigen::Matrix3Xd positions(std::span<const Grain> grains) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(grains.size()));
  for (std::size_t i = 0; i < grains.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = grains[i].position;
  return points;
}

double largest_radius(std::span<const Grain> grains) {
  double largest = 0;
  for (const Grain& grain : grains) largest = std::max(largest, grain.radius);
  return largest;
}

double least_overlap(const GrainLaw& law, double reduced) {
  return law.least_overlap ? law.least_overlap(reduced) : 0;
}

}  // namespace

double reduced_radius(const Grain& a, const Grain& b) {
  return a.radius * (b.radius / (a.radius + b.radius));
}

std::vector<GrainContact> find_contacts(std::span<const Grain> grains, const GrainLaw& law) {
  std::vector<GrainContact> contacts;
  if (grains.empty()) return contacts;
  check(grains);
  const Eigen::Matrix3Xd points = positions(grains);
  const double largest = largest_radius(grains);
  const CellList cells(points, 2 * largest - least_overlap(law, largest / 2));
  cells.for_pairs([&](Eigen::Index one, Eigen::Index other, double squared) {
    const auto [first, second] = std::minmax(one, other);
    const auto a = static_cast<std::uint32_t>(first), b = static_cast<std::uint32_t>(second);
    const double distance = std::sqrt(squared);
    if (!(distance > 0)) throw InputError(fmt::format("two grains coincide {}", place(grains[a])));
    const double overlap = grains[a].radius + grains[b].radius - distance;
    if (overlap < 0 && !(overlap > least_overlap(law, reduced_radius(grains[a], grains[b]))))
      return;
    if (contacts.size() / most_contacts >= grains.size())
      throw InputError(fmt::format(
          "more than {} contacts a grain: are radii (the greatest is {:g}) and positions in "
          "the same unit?",
          most_contacts, largest));
    contacts.push_back(
        {a, b, overlap, (points.col(second) - points.col(first)) / distance, overlap >= 0});
  });
  std::sort(contacts.begin(), contacts.end(), [](const GrainContact& p, const GrainContact& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return contacts;
}

ListedShare decide_by_list(std::span<const Grain> grains, std::span<GrainContact> contacts,
                           std::span<const ListedContact> list) {
  const auto ids = [](const ListedContact& c) { return std::pair(c.id1, c.id2); };
  ListedShare share;
  for (GrainContact& contact : contacts) {
    const std::pair<std::int64_t, std::int64_t> pair =
        std::minmax(grains[contact.a].id, grains[contact.b].id);
    const auto at = std::ranges::lower_bound(list, pair, {}, ids);
    if (at == list.end() || ids(*at) != pair || at->force == 0) continue;
    contact.touching = true;
    contact.force = at->force;
    ++share.listed;
  }
  const auto acting =
      std::ranges::count_if(list, [](const ListedContact& c) { return c.force != 0; });
  share.unmatched = static_cast<std::size_t>(acting) - share.listed;
  return share;
}

IdPairs touching_pairs(std::span<const Grain> grains, std::span<const GrainContact> contacts) {
  IdPairs pairs;
  for (const GrainContact& contact : contacts)
    if (contact.touching) pairs.push_back(std::minmax(grains[contact.a].id, grains[contact.b].id));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace mdana
