// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/motion.hpp"

#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> motion_known();

namespace {

struct Atom {
  BodyIndex body;
  double mass;
  Eigen::Vector3d x, v, f;
};

void fill(AtomBlock& block, std::array<const char*, 3> names, const std::vector<Atom>& atoms,
          Eigen::Vector3d Atom::*part) {
  for (int k = 0; k < 3; ++k) {
    const auto column = block.make_real(names[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < atoms.size(); ++i) column[i] = (atoms[i].*part)[k];
  }
}

std::array<BodyMotion, 2> measure(const std::vector<Atom>& atoms) {
  AtomBlock block;
  block.reset(0, atoms.size());
  fill(block, {"x", "y", "z"}, atoms, &Atom::x);
  fill(block, {"vx", "vy", "vz"}, atoms, &Atom::v);
  fill(block, {"fx", "fy", "fz"}, atoms, &Atom::f);
  std::vector<BodyIndex> body;
  std::vector<double> mass;
  for (const Atom& a : atoms) {
    body.push_back(a.body);
    mass.push_back(a.mass);
  }
  const auto motion = make_motion({true, true});
  const FrameHeader header;
  const auto partial = motion->begin({header, {}});
  partial->add({block, body, mass});
  Table table(motion->columns());
  std::vector<double> row(table.columns().size());
  partial->close(row);
  table.add_row(row);
  return body_motion(table, 0);
}

}  // namespace

// Masses 1 and 3; inner forces of 1e16 that cancel; a speed of 1e7 with thermal parts of +-1 on it.
std::vector<KnownAnswer> motion_known() {
  const auto [one, two] = measure({
      {1, 1, {0, 0, 0}, {1e7 + 1, 0, 0}, {1e16, 2, 0}},
      {2, 2, {11, 1, 5}, {-4, 0, 1}, {0, 0, 1}},
      {1, 3, {4, -8, 2}, {1e7 - 1, 0, 4}, {-1e16, -0.5, 0.25}},
      {0, 9, {99, 99, 99}, {99, 99, 99}, {99, 99, 99}},
      {2, 2, {13, 3, 5}, {-6, 0, 3}, {0, -7, 1}},
  });
  return {{"mass", one.mass, 4, 16},
          {"centre of mass, x", one.position.x(), 3, 15},
          {"centre of mass, y", one.position.y(), -6, 15},
          {"velocity on a drift of 1e7", one.velocity.x(), 1e7 - 0.5, 16},
          {"velocity, z", one.velocity.z(), 3, 15},
          {"force of which 1e16 cancels", one.force.x(), 0, 16},
          {"force, y", one.force.y(), 1.5, 15},
          {"centre of mass of body 2, x", two.position.x(), 12, 15},
          {"velocity of body 2, x", two.velocity.x(), -5, 15},
          {"force on body 2, y", two.force.y(), -7, 15}};
}

}  // namespace mdana
