// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_patch.hpp"

#include <cmath>
#include <numbers>

#include "analyses/motion.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> contact_patch_known();

namespace {

/// Square lattice of `side` by `side` atoms a spacing of 1 apart.
std::vector<Eigen::Vector2d> square(int side) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.emplace_back(i, j);
  return points;
}

double area(const std::vector<Eigen::Vector2d>& points) { return patch_area(points, 1).area; }

struct Radii {
  double alpha, neighbours;
};

/// A lattice of `side1` by `side1` atoms of body 1 over one of body 2, both at a height of 1/2 (the
/// spacing is 1); the layer holds both.
Radii contact_radii(int side1, int side2) {
  const auto first = square(side1), second = square(side2);
  AtomBlock block;
  block.reset(0, first.size() + second.size());
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  std::vector<BodyIndex> body;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool one = i < first.size();
    const Eigen::Vector2d& p = one ? first[i] : second[i - first.size()];
    x[i] = p.x();
    y[i] = p.y();
    z[i] = one ? -0.5 : 0.5;
    body.push_back(one ? 1 : 2);
  }
  const std::vector<double> mass(x.size(), 1.0);
  std::array<BodyMotion, 2> motion;
  motion[0].position = {0, 0, -4};
  motion[1].position = {0, 0, 4};
  const FrameHeader header;
  const auto partial = make_contact_patch({{5, 5}, 0.5, 1, 1.2})->begin({header, motion});
  partial->add({block, body, mass});
  std::array<double, 6> row{};
  partial->close(row);
  return {row[0], row[2]};
}

}  // namespace

std::vector<KnownAnswer> contact_patch_known() {
  auto stray = square(10);
  stray.emplace_back(20, 3);
  auto holed = square(20);  // a hole of 9 atoms: its edge atoms own half a cell of it
  std::erase_if(holed, [](const auto& p) {
    return std::abs(p.x() - 10) < 1.5 && std::abs(p.y() - 10) < 1.5;
  });
  const double root_pi = std::sqrt(std::numbers::pi);
  // Square lattices: as many cells of area 1 as atoms.
  return {{"area of a square lattice", area(square(10)), 100, 14},
          {"area without a stray atom", area(stray), 100, 14},
          {"area about a hole", area(holed), 391, 14},
          {"area of atoms on a line", area({{0, 0}, {1, 1}, {2, 2}, {5, 5}}), 0, 16},
          {"a of a layer, alpha", contact_radii(12, 12).alpha, 12 / root_pi, 14},
          {"a of a layer, the larger body counts", contact_radii(6, 12).alpha, 12 / root_pi, 14},
          // 36 atoms over the corner of 144: the twelve beyond the edge are at sqrt(2) > 1.2.
          {"a of the neighbours, the smaller body counts", contact_radii(6, 12).neighbours,
           6 / root_pi, 14},
          {"a without the other body", contact_radii(12, 0).alpha, 0, 16}};
}

}  // namespace mdana
