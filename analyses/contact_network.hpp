// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "analyses/analysis.hpp"
#include "analyses/grain_contacts.hpp"

namespace mdana {

/// What later frames are compared with.
struct ReferenceNetwork {
  std::vector<std::int64_t> ids;  ///< of all grains, sorted
  IdPairs touching;
};

/// Shells and layers of the filling factor map.
inline constexpr std::size_t filling_bins = 8;

struct ContactNetworkSettings {
  std::array<double, 2> radius;        ///< of body 1, 2 [length]
  std::optional<double> grain_radius;  ///< of every grain [length]; else the column `radius`
  GrainLaw law;                        ///< without it: no forces, nothing undecided
  double force_noise = 0;  ///< [force] up to which one is neither tension nor compression
  std::optional<double> strong_force;  ///< [force] contacts above it count as strong
  std::optional<double> compacted;     ///< local filling factor above which a grain is compacted
  std::shared_ptr<const ReferenceNetwork> reference;  ///< grains are followed by id if there is one
  /// Contacts with forces that the simulation lists at a step; null if none are listed. Asked for
  /// ascending steps: sweep on one thread.
  std::function<const LocalFrame*(std::int64_t step)> listed;

  bool followed() const { return reference || listed; }  ///< grains, by the column id
};

/// The network of contacts of grains in two aggregates: numbers of contacts, coordination, normal
/// forces, fabric, filling factors, as far as the settings allow. What the columns are is
/// told in analyses/contact_network/contact_network.md. Keeps the grains of a frame, 48 bytes each,
/// and while it counts some 700 bytes a grain.
std::unique_ptr<Analysis> make_contact_network(ContactNetworkSettings settings);

}  // namespace mdana
