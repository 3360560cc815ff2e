// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/SVD>

#include "analyses/defects/planes.hpp"
#include "readers/disjoint_sets.hpp"

namespace mdana {
namespace {

using Turn = Eigen::Quaterniond;

/// The 24 turns of the cube into itself.
std::vector<Turn> make_cube_turns() {
  std::vector<Turn> all;
  const double r = std::sqrt(0.5);
  for (int k = 0; k < 4; ++k) {
    Eigen::Vector4d v = Eigen::Vector4d::Zero();
    v[k] = 1;
    all.emplace_back(v[0], v[1], v[2], v[3]);
    for (int m = 0; m < k; ++m)
      for (const double sign : {r, -r}) {
        v.setZero();
        v[k] = sign;
        v[m] = r;
        all.emplace_back(v[0], v[1], v[2], v[3]);
      }
  }
  for (const double x : {0.5, -0.5})
    for (const double y : {0.5, -0.5})
      for (const double z : {0.5, -0.5}) all.emplace_back(0.5, x, y, z);
  return all;
}

const std::vector<Turn>& cube_turns() {
  static const std::vector<Turn> all = make_cube_turns();
  return all;
}

}  // namespace

Turn nearest_turn(const Turn& turn, const Turn& to) {
  Turn best = turn;
  double most = -1;
  for (const Turn& cube : cube_turns()) {
    const Turn same = turn * cube;
    const double dot = same.dot(to);
    if (std::abs(dot) <= most + 1e-12) continue;
    most = std::abs(dot);
    best = dot < 0 ? Turn(Eigen::Vector4d(-same.coeffs())) : same;
  }
  return best;
}

double misorientation(const Turn& a, const Turn& b) {
  const Turn near = nearest_turn(a, b);
  return 4 * std::atan2((near.coeffs() - b.coeffs()).norm(), (near.coeffs() + b.coeffs()).norm());
}

namespace defects {
namespace {

constexpr std::size_t sample = 300;   ///< fcc atoms
constexpr std::size_t candidates = 9; ///< of them, for the lattice that most agree with
constexpr double agreeing = 10 * std::numbers::pi / 180;

/// The turn in a deformation (its polar decomposition).
Turn turn_of(const Eigen::Matrix3d& map) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Turn(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose()));
}

/// Evenly chosen fcc atoms of a body.
std::vector<std::uint32_t> sampled(const Sites& sites, BodyIndex body) {
  auto places = places_of(sites, Structure::fcc);
  std::erase_if(places, [&](std::uint32_t place) { return sites.body[place] != body; });
  if (places.size() <= sample) return places;
  std::vector<std::uint32_t> chosen;
  for (std::size_t k = 0; k < sample; ++k) chosen.push_back(places[k * places.size() / sample]);
  return chosen;
}

std::vector<Turn> turns(const Sites& sites, const std::vector<std::uint32_t>& places) {
  std::vector<std::optional<Turn>> found(places.size());
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& neighbours, NeighbourSearch&) {
    const auto twelve = nearest_twelve(neighbours);
    const auto map = twelve ? deformation(*twelve) : std::nullopt;
    if (map) found[k] = turn_of(*map);
  });
  std::vector<Turn> all;
  for (const auto& turn : found)
    if (turn) all.push_back(*turn);
  return all;
}

/// Mean of those that agree with one of them, and their share.
BodyLattice about(const std::vector<Turn>& all, const Turn& middle) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  double count = 0;
  for (const Turn& turn : all) {
    if (misorientation(turn, middle) > agreeing) continue;
    sum += nearest_turn(turn, middle).coeffs();
    ++count;
  }
  return {Turn(Eigen::Vector4d(sum.normalized())), count / static_cast<double>(all.size())};
}

}  // namespace

BodyLattice find_lattice(const Sites& sites, BodyIndex body) {
  const std::vector<Turn> all = turns(sites, sampled(sites, body));
  BodyLattice best;
  for (std::size_t k = 0; k < std::min(candidates, all.size()); ++k) {
    const BodyLattice lattice = about(all, all[k * all.size() / std::min(candidates, all.size())]);
    if (lattice.share > best.share) best = lattice;
  }
  if (best.share > 0) best.turn = nearest_turn(best.turn, Turn::Identity());
  return best;
}

std::vector<std::uint32_t> find_fcc_clusters(const Sites& sites) {
  const auto places = places_of(sites, Structure::fcc);
  DisjointSets sets(sites.structure.size());
  const auto search = sites.search();
  Neighbours found;
  for (const std::uint32_t place : places) {
    search->about(place, found);
    for (const Neighbour& n : found)
      if (n.place < place && n.d2 < between_shells * between_shells &&
          sites.structure[n.place] == Structure::fcc)
        sets.join(place, n.place);
  }
  std::vector<std::uint32_t> lowest(sites.structure.size(), ~0u);  // atom of each root
  for (const std::uint32_t place : places) {
    std::uint32_t& atom = lowest[sets.root(place)];
    atom = std::min(atom, sites.grid.atom[place]);
  }
  std::vector<std::uint32_t> roots;
  for (const std::uint32_t place : places)
    if (sets.root(place) == place) roots.push_back(place);
  std::sort(roots.begin(), roots.end(),
            [&](std::uint32_t a, std::uint32_t b) { return lowest[a] < lowest[b]; });
  std::vector<std::uint32_t> number(sites.structure.size());
  for (std::size_t k = 0; k < roots.size(); ++k)
    number[roots[k]] = static_cast<std::uint32_t>(k + 1);
  for (const std::uint32_t place : places) number[place] = number[sets.root(place)];
  return number;
}

}  // namespace defects
}  // namespace mdana
