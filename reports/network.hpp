// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analyses/contact_network.hpp"
#include "fits/force_law.hpp"
#include "reports/document.hpp"
#include "reports/run.hpp"

namespace mdana {

/// What the user says of the grains; what is missing is the scene's.
struct NetworkOptions {
  Grains grains;
  std::optional<double>
      strong_share;                 ///< of F_c, above which a force is strong; default_strong_share
  std::optional<double> compacted;  ///< local filling factor; see NetworkSetup
  std::optional<double> aggregate_modulus;  ///< E* of two equal aggregates [pressure]
  std::filesystem::path contacts;           ///< local dump of contacts and forces; empty: none
  LocalDump::Columns contact_columns{"c_ids[1]", "c_ids[2]", "c_pair[2]"};  ///< of it
};

/// Of the force to pull two grains apart.
inline constexpr double default_strong_share = 0.1;

/// What is to be counted, and what the first frame says of the grains.
struct NetworkSetup {
  Grains grains;  ///< with their mean radius
  std::string radius_source;
  double smallest = 0, largest = 0;  ///< radius [length]
  std::size_t count = 0;
  double filling = 0;  ///< of the aggregates
  std::string filling_source;
  std::optional<ElasticContact> contact;  ///< of two grains of mean radius
  std::string no_contact;                 ///< why there is none
  std::string not_followed;  ///< why contacts are not compared with the first frame; else empty
  std::optional<InputRecord> list;        ///< of contacts
  /// Its `compacted` is the given one, else what 99 % of the first frame's local filling factors
  /// are below.
  ContactNetworkSettings settings;
};

/// Reads the first frame. Throws InputError if the grains' radius is not known, or of gamma, E and
/// nu some are and some are not.
NetworkSetup network_setup(const Run& run, const Radii& radii, const NetworkOptions& options);

/// A row a frame: step, [time,] X, delta, and the columns of the network.
struct MeasuredNetwork {
  SweepResult swept;
  Table table;
  std::size_t most_compressed = 0;  ///< row of the greatest delta
};
MeasuredNetwork measure_network(const Run& run, const Radii& radii, const NetworkSetup& setup,
                                SweepOptions options);

void add_network(Document& document, const NetworkSetup& setup, const MeasuredNetwork& measured);

/// Elastic constants and static yield stress by the estimates of Arakawa et al. 2024, as far as
/// their input is known; `coordination` is the mean inside.
void add_aggregate_constants(Document& document, const NetworkSetup& setup,
                             const NetworkOptions& options, const Value& coordination);

}  // namespace mdana
