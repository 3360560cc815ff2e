// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "analyses/contact_network.hpp"
#include "analyses/contact_plane.hpp"

namespace mdana {

/// The columns of the analysis contact_network; see contact_network.md.
struct NetworkNumbers {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  double contacts = 0, contacts1 = 0, contacts2 = 0, contacts12 = 0, undecided = 0;
  double listed = unknown, unmatched = unknown;
  double coordination = unknown, coordination_error = unknown;
  double coordination_core = unknown, coordination_core_error = unknown, core_grains = 0;
  double made = unknown, broken = unknown, lost_contacts = unknown;
  double tension = unknown, compression = unknown, tension12 = unknown, compression12 = unknown;
  double strong_tension = unknown, strong_compression = unknown;
  double force_mean = unknown, force_rms = unknown, force_min = unknown, force_q05 = unknown,
         force_q25 = unknown, force_median = unknown, force_q75 = unknown, force_q95 = unknown,
         force_max = unknown, force12 = unknown;
  double fabric_xx = unknown, fabric_yy = unknown, fabric_zz = unknown, fabric_xy = unknown,
         fabric_xz = unknown, fabric_yz = unknown, fabric_line = unknown, fabric_deviator = unknown;
  double compacted_grains = unknown, compacted_volume = unknown;
  std::array<double, filling_bins> shell, layer;  ///< filling factors

  NetworkNumbers() {
    shell.fill(unknown);
    layer.fill(unknown);
  }
};

/// Those that the settings allow.
std::vector<ColumnSpec> network_columns(const ContactNetworkSettings& settings);
void write_row(const NetworkNumbers& numbers, const ContactNetworkSettings& settings,
               std::span<double> row);

/// What is counted in one frame.
struct NetworkFrame {
  std::span<const Grain> grains;
  std::span<const GrainContact> contacts;
  std::array<Eigen::Vector3d, 2> centre;  ///< of body 1, 2 [length]
  const ContactPlane& plane;
  const ContactNetworkSettings& settings;
};

void count_contacts(const NetworkFrame& frame, NetworkNumbers& numbers);
void compare_with_reference(const NetworkFrame& frame, NetworkNumbers& numbers);
void measure_forces(const NetworkFrame& frame, NetworkNumbers& numbers);
void measure_fabric(const NetworkFrame& frame, NetworkNumbers& numbers);
void measure_filling(const NetworkFrame& frame, NetworkNumbers& numbers);

}  // namespace mdana
