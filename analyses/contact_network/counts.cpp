// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "analyses/contact_network/network_numbers.hpp"
#include "analyses/local_filling.hpp"
#include "analyses/moments.hpp"

namespace mdana {
namespace {

using Degrees = Moments<1>;

void add(Degrees& degrees, double degree) { degrees.merge({1, 1, Degrees::Vector(degree), 0}); }

/// Standard error of the mean as if contacts were independent of each other, each of which counts
/// for two grains; unknown for fewer than two grains.
double standard_error(const Degrees& degrees) {
  if (degrees.count < 2) return NetworkNumbers::unknown;
  const auto n = static_cast<double>(degrees.count);
  return std::sqrt(2 * degrees.spread / (n * (n - 1)));
}

/// Contacts of each grain.
std::vector<std::uint32_t> degrees_of(const NetworkFrame& frame) {
  std::vector<std::uint32_t> degree(frame.grains.size(), 0);
  for (const GrainContact& contact : frame.contacts)
    if (contact.touching) {
      ++degree[contact.a];
      ++degree[contact.b];
    }
  return degree;
}

/// Deeper than two grain radii under the sphere that its aggregate was cut from: all its places in
/// the packing are in the aggregate.
bool in_core(const NetworkFrame& frame, const Grain& grain, double two_radii) {
  const std::size_t b = grain.body - 1u;
  return (grain.position - frame.centre[b]).norm() <= frame.settings.radius[b] - two_radii;
}

void measure_coordination(const NetworkFrame& frame, NetworkNumbers& n) {
  const std::vector<std::uint32_t> degree = degrees_of(frame);
  const double two_radii = 2 * mean_radius(frame.grains);
  Degrees all, core;
  for (std::size_t i = 0; i < degree.size(); ++i) {
    add(all, degree[i]);
    if (in_core(frame, frame.grains[i], two_radii)) add(core, degree[i]);
  }
  n.coordination = all.mean[0];
  n.coordination_error = standard_error(all);
  n.core_grains = static_cast<double>(core.count);
  if (core.count == 0) return;
  n.coordination_core = core.mean[0];
  n.coordination_core_error = standard_error(core);
}

}  // namespace

void count_contacts(const NetworkFrame& frame, NetworkNumbers& n) {
  for (const GrainContact& contact : frame.contacts) {
    if (!contact.touching) {
      ++n.undecided;
      continue;
    }
    const BodyIndex a = frame.grains[contact.a].body, b = frame.grains[contact.b].body;
    ++(a != b ? n.contacts12 : a == 1 ? n.contacts1 : n.contacts2);
  }
  n.contacts = n.contacts1 + n.contacts2 + n.contacts12;
  measure_coordination(frame, n);
}

void compare_with_reference(const NetworkFrame& frame, NetworkNumbers& n) {
  if (!frame.settings.reference) return;
  const ReferenceNetwork& reference = *frame.settings.reference;
  const IdPairs now = touching_pairs(frame.grains, frame.contacts);
  std::vector<std::int64_t> ids;
  for (const Grain& grain : frame.grains) ids.push_back(grain.id);
  std::sort(ids.begin(), ids.end());
  const auto there = [&](std::int64_t id) {
    return std::binary_search(ids.begin(), ids.end(), id);
  };

  n.made = n.broken = n.lost_contacts = 0;
  for (const auto& pair : now)
    if (!std::binary_search(reference.touching.begin(), reference.touching.end(), pair)) ++n.made;
  for (const auto& pair : reference.touching) {
    if (std::binary_search(now.begin(), now.end(), pair)) continue;
    ++(there(pair.first) && there(pair.second) ? n.broken : n.lost_contacts);
  }
}

}  // namespace mdana
