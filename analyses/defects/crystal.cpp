// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/crystal.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace mdana::defects {
namespace {

Twelve make_fcc() {
  Twelve all;
  std::size_t k = 0;
  for (int zero = 0; zero < 3; ++zero)
    for (const double a : {1.0, -1.0})
      for (const double b : {1.0, -1.0}) {
        Eigen::Vector3d v = Eigen::Vector3d::Zero();
        v[(zero + 1) % 3] = a;
        v[(zero + 2) % 3] = b;
        all[k++] = v / std::sqrt(2.0);
      }
  return all;
}

/// The side above the plane stays; below it stands the mirror image of that.
Template hcp_template(const Eigen::Vector3d& normal) {
  Template made{Structure::hcp, fcc_neighbours()};
  for (auto& v : made.neighbours)
    if (v.dot(normal) < -0.1) v = -v + 2 * v.dot(normal) * normal;  // of -v, which is above
  return made;
}

std::vector<Template> make_templates() {
  std::vector<Template> all{{Structure::fcc, fcc_neighbours()}};
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double z : {1.0, -1.0})
        all.push_back(hcp_template(Eigen::Vector3d(x, y, z).normalized()));
  return all;
}

template <std::size_t N>
double local_cutoff(const std::array<Neighbour, N>& all) {
  double sum = 0;
  for (const Neighbour& n : all) sum += std::sqrt(static_cast<double>(n.d2));
  return between_shells * sum / static_cast<double>(N);
}

/// The N nearest, nearest first; of equal ones the first.
template <std::size_t N>
std::optional<std::array<Neighbour, N>> nearest(const Neighbours& all) {
  if (all.size() < N) return std::nullopt;
  std::array<Neighbour, N> found;
  std::size_t count = 0;
  for (const Neighbour& n : all) {
    if (count == N && !(n.d2 < found[N - 1].d2)) continue;
    std::size_t at = count < N ? count++ : N - 1;
    for (; at > 0 && n.d2 < found[at - 1].d2; --at) found[at] = found[at - 1];
    found[at] = n;
  }
  return found;
}

double between(const Neighbour& a, const Neighbour& b) {
  return (a.offset - b.offset).cast<double>().norm();
}

/// Primitive vectors of a lattice, 60 degrees to each other: three mutual neighbours, right-handed.
std::optional<Eigen::Matrix3d> primitive_vectors(std::span<const Neighbour, 12> all,
                                                 double cutoff) {
  const auto bonded = [&](std::size_t i, std::size_t k) {
    return i != k && between(all[i], all[k]) < cutoff;
  };
  for (std::size_t b = 1; b < 12; ++b)
    for (std::size_t c = b + 1; c < 12; ++c) {
      if (!bonded(0, b) || !bonded(0, c) || !bonded(b, c)) continue;
      Eigen::Matrix3d p;
      p << all[0].offset.cast<double>(), all[b].offset.cast<double>(), all[c].offset.cast<double>();
      if (p.determinant() < 0) p.col(1).swap(p.col(2));
      return p;
    }
  return std::nullopt;
}

/// The primitive vectors in the axes of the cube.
const Eigen::Matrix3d& ideal_primitive() {
  static const Eigen::Matrix3d ideal =
      (Eigen::Matrix3d() << 0, 1, 1, 1, 0, 1, 1, 1, 0).finished() / std::sqrt(2.0);
  return ideal;
}

/// Common neighbours among N: how many of the bonds have `count` of them, each of these bonded to two
/// of the others (a ring).
template <std::size_t N>
int rings(const std::array<Neighbour, N>& all, double cutoff, int count) {
  std::array<std::uint32_t, N> bonded{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (between(all[i], all[k]) < cutoff) {
        bonded[i] |= 1u << k;
        bonded[k] |= 1u << i;
      }
  int found = 0;
  for (const std::uint32_t common : bonded) {
    bool ring = __builtin_popcount(common) == count;
    for (std::size_t m = 0; m < N; ++m)
      if (common >> m & 1) ring = ring && __builtin_popcount(common & bonded[m]) == 2;
    found += ring;
  }
  return found;
}

/// bcc has shells of 8 at sqrt(3)/2 and 6 at 1 edge of the cube, the next at sqrt 2 (Stukowski 2012).
bool is_bcc(const std::array<Neighbour, 14>& all) {
  double first = 0, second = 0;
  for (std::size_t k = 0; k < 14; ++k)
    (k < 8 ? first : second) += std::sqrt(static_cast<double>(all[k].d2));
  const double edge = 0.5 * (first / 8 * 2 / std::sqrt(3.0) + second / 6);
  const double cutoff = between_shells * edge;
  return rings(all, cutoff, 6) == 8 && rings(all, cutoff, 4) == 6;
}

}  // namespace

const Twelve& fcc_neighbours() {
  static const Twelve all = make_fcc();
  return all;
}

std::span<const Template> templates() {
  static const std::vector<Template> all = make_templates();
  return all;
}

std::optional<std::array<Neighbour, 12>> nearest_twelve(const Neighbours& all) {
  return nearest<12>(all);
}

std::optional<Eigen::Matrix3d> deformation(std::span<const Neighbour, 12> all) {
  double sum = 0;
  for (const Neighbour& n : all) sum += std::sqrt(static_cast<double>(n.d2));
  const auto primitive = primitive_vectors(all, between_shells * sum / 12);
  if (!primitive) return std::nullopt;
  const Eigen::Matrix3d inverse = primitive->inverse();
  Eigen::Matrix3d measured = Eigen::Matrix3d::Zero(), ideal = Eigen::Matrix3d::Zero();
  Twelve seen;
  std::size_t count = 0;
  for (const Neighbour& n : all) {
    const Eigen::Vector3d u = n.offset.cast<double>();
    const Eigen::Vector3d v = ideal_primitive() * (inverse * u).array().round().matrix();
    const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::abs(v.squaredNorm() - 1) > 0.1 || std::find(seen.begin(), end, v) != end)
      return std::nullopt;
    seen[count++] = v;
    measured += u * v.transpose();
    ideal += v * v.transpose();
  }
  return Eigen::Matrix3d(measured * ideal.inverse());
}

Labelled common_neighbour_structure(const Neighbours& all) {
  Labelled found;
  if (all.size() < 12) return found;
  if (all.size() > Candidates::capacity) too_many_neighbours();
  found.structure = structure_of(all, &found.margin);
  return found;
}

Structure bcc_or_ico(const Neighbours& all) {
  const auto twelve = nearest<12>(all);
  if (twelve && rings(*twelve, local_cutoff(*twelve), 5) == 12) return Structure::ico;
  const auto fourteen = nearest<14>(all);
  if (fourteen && is_bcc(*fourteen)) return Structure::bcc;
  return Structure::other;
}

}  // namespace mdana::defects
