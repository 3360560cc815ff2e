// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyses/contact_network/network_numbers.hpp"
#include "analyses/local_filling.hpp"

namespace mdana {
namespace {

/// Grains in shells of equal width about the centre of their own body, out to its radius: their
/// volume, by their centres, over that of the shells of both bodies.
void measure_shells(const NetworkFrame& frame, NetworkNumbers& n) {
  const auto& radius = frame.settings.radius;
  const double whole = std::max(radius[0], radius[1]);
  const auto cube = [](double r) { return r * r * r; };
  n.shell.fill(0);
  for (const Grain& grain : frame.grains) {
    const std::size_t b = grain.body - 1u;
    const double depth = (grain.position - frame.centre[b]).norm() / radius[b];
    const auto k = static_cast<std::size_t>(std::min(depth, 2.0) * filling_bins);
    if (k < filling_bins) n.shell[k] += cube(grain.radius / whole);
  }
  for (std::size_t k = 0; k < filling_bins; ++k) {
    const double inner = static_cast<double>(k) / filling_bins, outer = inner + 1.0 / filling_bins;
    n.shell[k] /= (cube(outer) - cube(inner)) * (cube(radius[0] / whole) + cube(radius[1] / whole));
  }
}

/// Mean local filling factor in layers of two grain radii on both sides of the contact plane, no
/// farther from the centre line than a quarter of the smaller body's radius.
void measure_layers(const NetworkFrame& frame, std::span<const double> filling, double thickness,
                    NetworkNumbers& n) {
  const double reach = 0.25 * std::min(frame.settings.radius[0], frame.settings.radius[1]);
  std::array<double, filling_bins> count{};
  for (std::size_t i = 0; i < frame.grains.size(); ++i) {
    const Eigen::Vector3d r = frame.grains[i].position - frame.plane.point;
    const double height = std::abs(r.dot(frame.plane.normal));
    if (std::hypot(r.dot(frame.plane.u), r.dot(frame.plane.v)) > reach) continue;
    const auto k = static_cast<std::size_t>(std::min(height / thickness, 2.0 * filling_bins));
    if (k >= filling_bins) continue;
    if (count[k] == 0) n.layer[k] = 0;
    n.layer[k] += (filling[i] - n.layer[k]) / ++count[k];
  }
}

/// Volume that compacted grains take up: that of each over its local filling factor.
void measure_compaction(const NetworkFrame& frame, std::span<const double> filling,
                        NetworkNumbers& n) {
  if (!frame.settings.compacted) return;
  n.compacted_grains = n.compacted_volume = 0;
  for (std::size_t i = 0; i < frame.grains.size(); ++i) {
    if (!(filling[i] > *frame.settings.compacted)) continue;
    const double r = frame.grains[i].radius;
    ++n.compacted_grains;
    n.compacted_volume += 4 * std::numbers::pi / 3 * r * r * r / filling[i];
  }
}

}  // namespace

void measure_filling(const NetworkFrame& frame, NetworkNumbers& n) {
  const std::vector<double> filling = local_filling(frame.grains);
  measure_shells(frame, n);
  measure_layers(frame, filling, 2 * mean_radius(frame.grains), n);
  measure_compaction(frame, filling, n);
}

}  // namespace mdana
