// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "analyses/contact_network/network_numbers.hpp"

namespace mdana {
namespace {

/// Value below which a share of the sorted numbers lies, linear between them.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == sorted.size()) return sorted[below];
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

void describe(std::vector<double> forces, NetworkNumbers& n) {
  if (forces.empty()) return;
  std::sort(forces.begin(), forces.end());
  const auto count = static_cast<double>(forces.size());
  const double scale = std::max(std::abs(forces.front()), std::abs(forces.back()));
  double mean = 0, square = 0;
  for (const double f : forces) {
    mean += f / count;
    square += scale > 0 ? (f / scale) * (f / scale) / count : 0;
  }
  n.force_mean = mean;
  n.force_rms = scale * std::sqrt(square);
  n.force_min = forces.front();
  n.force_max = forces.back();
  n.force_q05 = quantile(forces, 0.05);
  n.force_q25 = quantile(forces, 0.25);
  n.force_median = quantile(forces, 0.5);
  n.force_q75 = quantile(forces, 0.75);
  n.force_q95 = quantile(forces, 0.95);
}

/// Counts a contact by the sign of its force, if that is more than noise, and whether it is strong.
void classify(double force, bool across, const NetworkFrame& frame, NetworkNumbers& n) {
  const double noise = frame.settings.force_noise;
  n.tension += force < -noise;
  n.compression += force > noise;
  n.tension12 += across && force < -noise;
  n.compression12 += across && force > noise;
  if (!frame.settings.strong_force) return;
  n.strong_tension += force < -*frame.settings.strong_force;
  n.strong_compression += force > *frame.settings.strong_force;
}

/// As listed, else by the law; NaN without either.
double force_of(const NetworkFrame& frame, const GrainContact& contact) {
  if (!std::isnan(contact.force) || !frame.settings.law.force) return contact.force;
  return frame.settings.law.force(contact.overlap,
                                  reduced_radius(frame.grains[contact.a], frame.grains[contact.b]));
}

}  // namespace

void measure_forces(const NetworkFrame& frame, NetworkNumbers& n) {
  if (!frame.settings.law.force && std::isnan(n.listed)) return;
  n.tension = n.compression = n.tension12 = n.compression12 = n.force12 = 0;
  if (frame.settings.strong_force) n.strong_tension = n.strong_compression = 0;
  std::vector<double> forces;
  for (const GrainContact& contact : frame.contacts) {
    if (!contact.touching) continue;
    const Grain &a = frame.grains[contact.a], &b = frame.grains[contact.b];
    const double force = force_of(frame, contact);
    if (std::isnan(force)) continue;
    forces.push_back(force);
    classify(force, a.body != b.body, frame, n);
    if (a.body == b.body) continue;
    const double along = contact.normal.dot(frame.plane.normal);  // from body 1 to body 2
    n.force12 += a.body == 1 ? force * along : -force * along;
  }
  describe(std::move(forces), n);
}

void measure_fabric(const NetworkFrame& frame, NetworkNumbers& n) {
  if (n.contacts == 0) return;
  Eigen::Matrix3d fabric = Eigen::Matrix3d::Zero();
  for (const GrainContact& contact : frame.contacts)
    if (contact.touching) fabric += contact.normal * contact.normal.transpose() / n.contacts;
  n.fabric_xx = fabric(0, 0);
  n.fabric_yy = fabric(1, 1);
  n.fabric_zz = fabric(2, 2);
  n.fabric_xy = fabric(0, 1);
  n.fabric_xz = fabric(0, 2);
  n.fabric_yz = fabric(1, 2);
  n.fabric_line = frame.plane.normal.dot(fabric * frame.plane.normal);
  n.fabric_deviator = std::sqrt(1.5) * (fabric - Eigen::Matrix3d::Identity() / 3).norm();
}

}  // namespace mdana
