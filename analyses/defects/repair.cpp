// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {
namespace {

// In spacings. Between neighbours of fcc and of hcp lie 3 x (1/sqrt 3)^2 = 1 in the sum of squares.
constexpr double farthest = 0.45;        ///< of an atom from where the template has it
constexpr double greatest_sum = 0.5;     ///< of squares: 0.2 for each of twelve
constexpr double least_distance = 0.25;  ///< to the sum of the best template of another structure
constexpr int least_near = 12;           ///< atoms within `touching` of one that may be repaired
constexpr int least_hcp = 2;             ///< hcp neighbours of an atom that may be hcp, too

/// Sum of the squared distances between a template and the atoms that fill it, one each, without what
/// all have in common (the displacement of the atom itself); infinite if it is not filled.
double misfit(const Twelve& ideal, const Eigen::Matrix3d& map, const Neighbours& all) {
  std::uint64_t taken = 0;
  double sum = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : ideal) {
    const Eigen::Vector3d p = map * v;
    double least = farthest * farthest;
    std::size_t filler = 64;
    Eigen::Vector3d between = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Eigen::Vector3d d = all[k].offset.cast<double>() - p;
      if (!(d.squaredNorm() < least)) continue;
      least = d.squaredNorm();
      filler = k;
      between = d;
    }
    if (filler == 64 || (taken >> filler & 1)) return HUGE_VAL;
    taken |= std::uint64_t{1} << filler;
    sum += least;
    mean += between / 12;
  }
  return sum - 12 * mean.squaredNorm();
}

/// The structure of the best template, if it fits and the other structure's fit clearly worse.
Labelled fitted(const Eigen::Matrix3d& map, const Neighbours& all, bool hcp_too) {
  double fcc = HUGE_VAL, hcp = HUGE_VAL;
  for (const Template& t : templates()) {
    if (t.structure == Structure::hcp && !hcp_too) break;
    double& best = t.structure == Structure::fcc ? fcc : hcp;
    best = std::min(best, misfit(t.neighbours, map, all));
  }
  const double best = std::min(fcc, hcp), other = std::max(fcc, hcp);
  if (!(best <= greatest_sum) || !(other >= best + least_distance)) return {};
  return {fcc < hcp ? Structure::fcc : Structure::hcp, static_cast<float>(1 - best / greatest_sum)};
}

/// Not at the surface, where 9 neighbours at most are so near.
bool is_inner(const Neighbours& all) {
  return std::count_if(all.begin(), all.end(), [](const Neighbour& n) {
           return n.d2 < touching * touching;
         }) >= least_near;
}

/// A fault goes on beside the atom: noise alone makes no hcp.
bool beside_hcp(const Sites& sites, const Neighbours& all) {
  return std::count_if(all.begin(), all.end(), [&](const Neighbour& n) {
           return n.d2 < touching * touching && sites.structure[n.place] == Structure::hcp;
         }) >= least_hcp;
}

/// The nearest fcc neighbour, or the next one behind another; null if there is none.
const Neighbour* fcc_neighbour(const Sites& sites, const Neighbours& all, const Neighbour* before) {
  const Neighbour* next = nullptr;
  for (const Neighbour& n : all) {
    if (sites.structure[n.place] != Structure::fcc || !(n.d2 < touching * touching)) continue;
    if (before && (n.d2 < before->d2 || (n.d2 == before->d2 && &n <= before))) continue;
    if (!next || n.d2 < next->d2) next = &n;
  }
  return next;
}

}  // namespace

Labelled repaired(const Sites& sites, const Neighbours& found, NeighbourSearch& search) {
  if (found.size() < 12 || found.size() > 60 || !is_inner(found)) return {};
  Neighbours theirs;
  const Neighbour* fcc = nullptr;
  for (int tries = 0; tries < 3; ++tries) {
    fcc = fcc_neighbour(sites, found, fcc);
    if (!fcc) break;
    search.about(fcc->place, theirs);
    const auto twelve = nearest_twelve(theirs);
    const auto map = twelve ? deformation(*twelve) : std::nullopt;
    if (!map) continue;
    const Labelled labelled = fitted(*map, found, beside_hcp(sites, found));
    if (labelled.structure != Structure::other) return labelled;
  }
  return {};
}

}  // namespace mdana::defects
