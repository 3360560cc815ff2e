// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_network.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "analyses/motion.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> contact_network_known();

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The nearest neighbours of a point of an fcc lattice at a distance of 2, and the point itself.
Points cuboctahedron() {
  Points points{{0, 0, 0}};
  const double s = std::sqrt(2.0);
  for (const double p : {-s, s})
    for (const double q : {-s, s}) {
      points.emplace_back(p, q, 0);
      points.emplace_back(p, 0, q);
      points.emplace_back(0, p, q);
    }
  return points;
}

/// Columns of the network of two bodies, of grains of radius r, with the centres of the bodies on
/// the x axis.
std::map<std::string, double> network(const Points& body1, const Points& body2, double r) {
  AtomBlock block;
  block.reset(0, body1.size() + body2.size());
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  std::vector<BodyIndex> body;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool one = i < body1.size();
    const Eigen::Vector3d& p = one ? body1[i] : body2[i - body1.size()];
    x[i] = p.x();
    y[i] = p.y();
    z[i] = p.z();
    body.push_back(one ? 1 : 2);
  }
  const std::vector<double> mass(x.size(), 1.0);
  std::array<BodyMotion, 2> motion;
  motion[1].position = {100, 0, 0};
  ContactNetworkSettings settings;
  settings.radius = {3, 3};
  settings.grain_radius = r;
  settings.law = {[](double overlap, double reduced) { return reduced * (overlap - 0.25); },
                  [](double reduced) { return -reduced; }};
  const auto analysis = make_contact_network(settings);
  const FrameHeader header;
  const auto partial = analysis->begin({header, motion});
  partial->add({block, body, mass});
  const auto columns = analysis->columns();
  std::vector<double> row(columns.size());
  partial->close(row);
  std::map<std::string, double> named;
  for (std::size_t k = 0; k < columns.size(); ++k) named[columns[k].name] = row[k];
  return named;
}

}  // namespace

// A cuboctahedron has 24 edges and 12 spokes; cubic symmetry makes its fabric isotropic. The chain
// lies along x, its bonds have the overlaps 0, 0.5, 0 (within body 1, across, within body 2) and a
// grain apart by less than pull-off behind it. With F = (overlap - 1/4)/2 two are in tension and
// the one across in compression.
std::vector<KnownAnswer> contact_network_known() {
  auto fcc = network(cuboctahedron(), {{50, 0, 0}}, 1.0625);
  auto chain = network({{0, 0, 0}, {2, 0, 0}}, {{3.5, 0, 0}, {5.5, 0, 0}, {7.75, 0, 0}}, 1);
  return {{"contacts of an fcc cluster", fcc["contacts1"], 36, 16},
          {"coordination of an fcc cluster and a single grain", fcc["coordination"], 72.0 / 14, 15},
          {"coordination of the grain in its core", fcc["coordination_core"], 12, 16},
          {"fabric of an fcc cluster along x", fcc["fabric_xx"], 1.0 / 3, 14},
          {"fabric of an fcc cluster, anisotropy", fcc["fabric_deviator"], 0, 14},
          {"contacts of a chain", chain["contacts"], 3, 16},
          {"contacts between the bodies", chain["contacts12"], 1, 16},
          {"pairs that may hold", chain["undecided"], 1, 16},
          {"fabric of a chain, along it", chain["fabric_line"], 1, 15},
          {"fabric of a chain, anisotropy", chain["fabric_deviator"], 1, 15},
          {"contacts in tension", chain["tension"], 2, 16},
          {"contacts in compression across", chain["compression12"], 1, 16},
          {"force across", chain["force12"], 0.125, 15},
          {"least force", chain["force_min"], -0.125, 15},
          {"mean force", chain["force_mean"], -0.125 / 3, 15}};
}

}  // namespace mdana
