// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/SVD>

#include "analyses/defects/atom_hash.hpp"
#include "analyses/ranges.hpp"

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

constexpr std::size_t atoms_at_once = 65536;
constexpr std::size_t sample = 300;   ///< fcc atoms
constexpr std::size_t candidates = 9; ///< of them, for the lattice that most agree with
constexpr double agreeing = 10 * std::numbers::pi / 180;

/// The turn in a deformation (its polar decomposition).
Turn turn_of(const Eigen::Matrix3d& map) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Turn(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose()));
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

void LatticeSample::take(const Sites& sites, std::size_t first, std::size_t end) {
  for (auto place = static_cast<std::uint32_t>(first); place < end; ++place)
    if (sites.structure[place] == Structure::fcc && sites.body[place] == body_ && sites.is_own(place))
      take(hash_of(static_cast<std::uint64_t>(sites.number(place))), sites.index(place), place);
}

void LatticeSample::add(const Sites& sites) {
  const std::size_t count = sites.structure.size();
  std::vector<LatticeSample> parts(count / atoms_at_once + 1, LatticeSample(body_));
  for_ranges(count, atoms_at_once, sites.threads,
             [&](std::size_t first, std::size_t end) { parts[first / atoms_at_once].take(sites, first, end); });
  for (const LatticeSample& part : parts)
    for (const Atom& atom : part.atoms_) take(atom.hash, atom.index, atom.place);
  std::vector<std::uint32_t> places;
  std::vector<Atom*> atoms;
  for (Atom& atom : atoms_) {
    if (atom.known) continue;
    places.push_back(atom.place);
    atoms.push_back(&atom);
  }
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& neighbours, NeighbourSearch&) {
    const auto twelve = nearest_twelve(neighbours);
    const auto map = twelve ? deformation(*twelve) : std::nullopt;
    if (map) atoms[k]->turn = turn_of(*map);
    atoms[k]->known = true;
  });
}

/// The sample is a heap, highest hash first.
void LatticeSample::take(std::uint64_t hash, std::uint32_t index, std::uint32_t place) {
  const auto lower = [](const Atom& a, const Atom& b) {
    return a.hash < b.hash || (a.hash == b.hash && a.index < b.index);
  };
  const Atom atom{hash, index, place, false, {}};
  if (atoms_.size() == sample) {
    if (!lower(atom, atoms_.front())) return;
    std::ranges::pop_heap(atoms_, lower);
    atoms_.pop_back();
  }
  atoms_.push_back(atom);
  std::ranges::push_heap(atoms_, lower);
}

std::vector<Turn> LatticeSample::turns() const {
  std::vector<Atom> sorted = atoms_;
  std::ranges::sort(sorted, {}, [](const Atom& atom) { return std::pair(atom.hash, atom.index); });
  std::vector<Turn> all;
  for (const Atom& atom : sorted)
    if (atom.turn) all.push_back(*atom.turn);
  return all;
}

BodyLattice LatticeSample::lattice() const {
  const std::vector<Turn> all = turns();
  BodyLattice best;
  for (std::size_t k = 0; k < std::min(candidates, all.size()); ++k) {
    const BodyLattice lattice = about(all, all[k * all.size() / std::min(candidates, all.size())]);
    if (lattice.share > best.share) best = lattice;
  }
  if (best.share > 0) best.turn = nearest_turn(best.turn, Turn::Identity());
  return best;
}

}  // namespace defects
}  // namespace mdana
