// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_radius.hpp"

#include <cmath>
#include <numbers>

#include "analyses/motion.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> contact_radius_known();

namespace {

// A right-handed set of axes with rational components; the bodies' centres lie along n.
const Eigen::Vector3d n = Eigen::Vector3d(1, 2, 2) / 3;
const Eigen::Vector3d u = Eigen::Vector3d(2, 1, -2) / 3;
const Eigen::Vector3d v = Eigen::Vector3d(2, -2, 1) / 3;

struct Atoms {
  std::vector<Eigen::Vector3d> at;
  std::vector<BodyIndex> body;

  void ring(double radius, double height, int count, BodyIndex b) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      at.push_back(height * n + radius * (std::cos(angle) * u + std::sin(angle) * v));
      body.push_back(b);
    }
  }
};

/// Two spheres with centres at -4n and `second` n.
struct Spheres {
  std::array<double, 2> radius;
  double second;
};

constexpr Spheres equal{{5, 5}, 4};

/// Contact radius from a layer of thickness 1.
double contact_radius(const Atoms& atoms, const Spheres& spheres = equal) {
  AtomBlock block;
  block.reset(0, atoms.at.size());
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  for (std::size_t i = 0; i < atoms.at.size(); ++i) {
    x[i] = atoms.at[i].x();
    y[i] = atoms.at[i].y();
    z[i] = atoms.at[i].z();
  }
  const std::vector<double> mass(atoms.at.size(), 1.0);
  std::array<BodyMotion, 2> motion;
  motion[0].position = -4 * n;
  motion[1].position = spheres.second * n;
  const FrameHeader header;
  const auto partial = make_contact_radius({spheres.radius, 0.5})->begin({header, motion});
  partial->add({block, atoms.body, mass});
  std::array<double, 4> row{};
  partial->close(row);
  return row[0];
}

/// Rings at radii R sqrt((k + 1/2)/K): equal areas, mean square radius exactly R^2/2.
Atoms disk(double radius, int rings) {
  Atoms atoms;
  for (int k = 0; k < rings; ++k)
    atoms.ring(radius * std::sqrt((k + 0.5) / rings), k % 2 ? 0.25 : -0.25, 24, k % 2 ? 2 : 1);
  return atoms;
}

}  // namespace

std::vector<KnownAnswer> contact_radius_known() {
  Atoms ring;
  ring.ring(3, -0.25, 12, 1);
  ring.ring(3, 0.25, 12, 2);
  Atoms beside = ring;  // atoms outside the layer do not count
  beside.ring(7, -0.75, 12, 1);
  beside.ring(5, 0.75, 12, 2);
  Atoms apart;  // one body alone in the layer
  apart.ring(3, -0.25, 12, 1);
  return {{"a of a ring is sqrt(2) its radius", contact_radius(ring), 3 * std::sqrt(2.0), 14},
          {"a of a disk is its radius", contact_radius(disk(2, 40)), 2, 14},
          {"a without the atoms outside", contact_radius(beside), 3 * std::sqrt(2.0), 14},
          // 3-4-5 and 3-1-sqrt(10): the spheres meet in a circle of radius 3 at the height 0.
          {"a of unequal spheres", contact_radius(beside, {{5, std::sqrt(10.0)}, 1}),
           3 * std::sqrt(2.0), 14},
          {"a without contact", contact_radius(apart), 0, 16}};
}

}  // namespace mdana
