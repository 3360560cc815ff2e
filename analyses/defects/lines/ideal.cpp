// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/ideal.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace mdana::defects {
namespace {

const double parts_a_neighbour = ideal_parts / std::sqrt(2.0);

Ideal rounded(const Eigen::Vector3d& v) {
  return (v * parts_a_neighbour).array().round().matrix().cast<int>();
}

/// The turn that makes w1, w2 out of u1, u2, if it is one between lattices.
std::optional<LatticeTurn> turn_between(const IdealPair& a, const IdealPair& b) {
  Eigen::Matrix3d from, to;
  const auto fill = [](Eigen::Matrix3d& m, const Ideal& u, const Ideal& v) {
    const Eigen::Vector3d x = u.cast<double>(), y = v.cast<double>();
    m << x, y, x.cross(y) / ideal_parts;
  };
  fill(from, a.first, b.first);
  fill(to, a.second, b.second);
  const double volume = from.determinant();
  if (!(std::abs(volume) > 1)) return std::nullopt;
  const Eigen::Matrix3d exact = LatticeTurn::parts * to * from.inverse();
  LatticeTurn turn{exact.array().round().matrix().cast<int>()};
  constexpr int square = LatticeTurn::parts * LatticeTurn::parts;
  if (turn.matrix * turn.matrix.transpose() != Eigen::Matrix3i(square * Eigen::Matrix3i::Identity()))
    return std::nullopt;
  return turn;
}

std::size_t agreeing(const LatticeTurn& turn, std::span<const IdealPair> pairs) {
  return static_cast<std::size_t>(std::ranges::count_if(
      pairs, [&](const IdealPair& p) { return turn.turned(p.first) == p.second; }));
}

Eigen::Matrix3i whole(const Eigen::Matrix3d& turn) {
  return (LatticeTurn::parts * turn).array().round().matrix().cast<int>();
}

/// Turns of the cube into itself: permutations of the axes with signs, of determinant 1.
std::vector<Eigen::Matrix3i> cube_turns() {
  std::vector<Eigen::Matrix3i> all;
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3i m = Eigen::Matrix3i::Zero();
      for (int k = 0; k < 3; ++k) m(k, axes[static_cast<std::size_t>(k)]) = (signs >> k & 1) ? -1 : 1;
      if (m.cast<double>().determinant() > 0) all.push_back(m);
    }
  } while (std::ranges::next_permutation(axes).found);
  return all;
}

/// Half turns about <111>, which make twins.
std::vector<Eigen::Matrix3d> twin_turns() {
  std::vector<Eigen::Matrix3d> all;
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0}) {
      const Eigen::Vector3d n = Eigen::Vector3d(x, y, 1).normalized();
      all.push_back(2 * n * n.transpose() - Eigen::Matrix3d::Identity());
    }
  return all;
}

std::vector<OrderedTurn> make_lattice_turns() {
  std::vector<OrderedTurn> all;
  const auto add = [&](const Eigen::Matrix3d& twin, int order) {
    for (const Eigen::Matrix3i& cube : cube_turns())
      all.push_back({{whole(twin * cube.cast<double>())}, order});
  };
  add(Eigen::Matrix3d::Identity(), 0);
  for (const auto& twin : twin_turns()) add(twin, 1);
  for (const auto& first : twin_turns())
    for (const auto& second : twin_turns())
      if (first != second) add(first * second, 2);
  return all;
}

std::vector<IdealTwelve> make_ideal_neighbours() {
  std::vector<IdealTwelve> all;
  for (const Template& t : templates()) std::ranges::transform(t.neighbours, all.emplace_back().begin(), rounded);
  return all;
}

}  // namespace

std::optional<Ideal> LatticeTurn::turned(const Ideal& v) const {
  const Ideal product = matrix * v;
  if ((product.array() - parts * (product.array() / parts) != 0).any()) return std::nullopt;
  return Ideal(product / parts);
}

Agreement best_turn(std::span<const IdealPair> pairs) {
  Agreement best;
  for (std::size_t a = 0; a < pairs.size(); ++a)
    for (std::size_t b = a + 1; b < pairs.size(); ++b) {
      if (best.pairs == pairs.size()) return best;
      const auto turn = turn_between(pairs[a], pairs[b]);
      if (!turn) continue;
      const std::size_t count = agreeing(*turn, pairs);
      if (count > best.pairs) best = {*turn, count};
    }
  return best;
}

std::span<const OrderedTurn> lattice_turns() {
  static const std::vector<OrderedTurn> all = make_lattice_turns();
  return all;
}

std::span<const IdealTwelve> ideal_neighbours() {
  static const std::vector<IdealTwelve> all = make_ideal_neighbours();
  return all;
}

Ideal nearest_lattice_vector(const Eigen::Vector3d& v) {
  const Eigen::Vector3d x = std::sqrt(2.0) * v;  // in half edges of the cube: whole, with an even sum
  Ideal n = x.array().round().matrix().cast<int>();
  if (n.sum() % 2 != 0) {
    Eigen::Index worst = 0;
    const Eigen::Vector3d off = x - n.cast<double>();
    off.cwiseAbs().maxCoeff(&worst);
    n[worst] += off[worst] > 0 ? 1 : -1;
  }
  return ideal_parts / 2 * n;
}

}  // namespace mdana::defects
