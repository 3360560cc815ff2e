// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/planes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Eigenvalues>

#include "analyses/moments.hpp"
#include "readers/disjoint_sets.hpp"

namespace mdana::defects {
namespace {

constexpr double parallel = 0.9;      ///< least cosine between the normals of one fault
constexpr double in_layer = 0.41;     ///< [spacings] half of the distance of layers, sqrt(2/3)
constexpr double second_layer = 1.2;  ///< [spacings]; it is 2 sqrt(2/3) = 1.63 away
constexpr std::uint32_t none = ~0u;

/// A hcp atom of a slab: its close-packed layer and the three neighbours on either side.
struct LayerAtom {
  std::uint32_t place = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double area = 0;  ///< in its layer [spacings^2]
  std::vector<std::uint32_t> in_plane, side[2];  ///< places
  std::vector<std::uint32_t> partners;           ///< places of those two layers away
  bool hcp_beside = false;  ///< one of those is hcp with a parallel layer
  bool sure = false;        ///< all about it have a structure, or one tells the kind
  PlanarFault kind = PlanarFault::none;
};

/// The six of the twelve that lie opposite to each other: those of the layer.
std::array<bool, 12> opposite_six(const std::array<Neighbour, 12>& all) {
  std::array<bool, 12> chosen{};
  for (int pair = 0; pair < 3; ++pair) {
    float least = far_away;
    std::size_t a = 0, b = 0;
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        if (chosen[i] || chosen[k]) continue;
        const float sum = (all[i].offset + all[k].offset).squaredNorm();
        if (sum >= least) continue;
        least = sum;
        a = i;
        b = k;
      }
    chosen[a] = chosen[b] = true;
  }
  return chosen;
}

Moments<1> length_of(const Neighbour& n) {
  return {1, 1, Moments<1>::Vector(n.offset.cast<double>().norm()), 0};
}

/// Area of an atom in its layer [spacings^2] by its distances to neighbours. Vibration lengthens them, in the
/// mean by their variance over the mean.
double layer_area(const Moments<1>& distances) {
  const double mean = distances.mean[0], rest = mean - distances.spread / distances.weight / mean;
  return std::sqrt(3.0) / 2 * rest * rest;
}

LayerAtom layer_atom(std::uint32_t place, const Neighbours& found) {
  LayerAtom atom;
  atom.place = place;
  const auto twelve = nearest_twelve(found);
  if (!twelve) return atom;
  const HcpLayer layer = hcp_layer(*twelve);
  atom.normal = layer.normal;
  Moments<1> distances;
  for (std::size_t k = 0; k < 12; ++k) {
    const Neighbour& n = (*twelve)[k];
    distances.merge(length_of(n));
    const bool above = n.offset.cast<double>().dot(atom.normal) > 0;
    (layer.in_plane[k] ? atom.in_plane : atom.side[above]).push_back(n.place);
  }
  atom.area = layer_area(distances);
  return atom;
}

/// The direction that most of some normals have, of either sign, and its mean; nothing without one.
std::optional<Eigen::Vector3d> most_frequent(const std::vector<Eigen::Vector3d>& normals) {
  const auto alike = [&](const Eigen::Vector3d& n) {
    return std::ranges::count_if(normals, [&](const Eigen::Vector3d& other) { return std::abs(n.dot(other)) > parallel; });
  };
  const auto best = std::ranges::max_element(normals, {}, alike);
  if (best == normals.end()) return {};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& n : normals)
    if (std::abs(n.dot(*best)) > parallel) mean += n.dot(*best) < 0 ? Eigen::Vector3d(-n) : n;
  return mean.normalized();
}

/// The same of a layer whose normal is known.
LayerAtom layer_atom(std::uint32_t place, const Neighbours& found, const Eigen::Vector3d& normal) {
  LayerAtom atom;
  atom.place = place;
  atom.normal = normal;
  Moments<1> distances;
  for (const Neighbour& n : found) {
    if (n.d2 > touching * touching) continue;
    const double height = n.offset.cast<double>().dot(normal);
    (std::abs(height) < in_layer ? atom.in_plane : atom.side[height > 0]).push_back(n.place);
    distances.merge(length_of(n));
  }
  atom.area = layer_area(distances);
  return atom;
}

/// All hcp atoms of a slab, and which of them stack to what.
class Layers {
 public:
  explicit Layers(const Sites& sites) : sites_(sites), places_(places_of(sites, Structure::hcp)) {
    atoms_.resize(places_.size());
    for_neighbours(sites, places_, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
      atoms_[k] = layer_atom(places_[k], found);
    });
    settle_normals();
    for (LayerAtom& atom : atoms_)
      atom.hcp_beside = any_parallel(atom, atom.side[0]) || any_parallel(atom, atom.side[1]);
    find_kinds();
    settle_kinds();
  }

  const std::vector<LayerAtom>& atoms() const { return atoms_; }

  /// Index of the layer atom at a place, if there is one and its layer is parallel.
  std::uint32_t parallel_at(const LayerAtom& atom, std::uint32_t place) const {
    const auto at = std::lower_bound(places_.begin(), places_.end(), place);
    if (at == places_.end() || *at != place) return none;
    const auto k = static_cast<std::size_t>(at - places_.begin());
    const bool same = sites_.body[place] == sites_.body[atom.place] &&
                      std::abs(atoms_[k].normal.dot(atom.normal)) > parallel;
    return same ? static_cast<std::uint32_t>(k) : none;
  }

 private:
  bool is_hcp(std::uint32_t place) const { return sites_.structure[place] == Structure::hcp; }

  /// Fewer than half of the hcp atoms about it have the same layer, or it has none.
  bool is_doubtful(const LayerAtom& atom) const {
    long about = 0, same = 0;
    for (const auto* places : {&atom.in_plane, &atom.side[0], &atom.side[1]})
      for (const std::uint32_t place : *places) {
        about += is_hcp(place);
        same += parallel_at(atom, place) != none;
      }
    return atom.in_plane.empty() || 2 * same < about;
  }

  /// Where noise hides which six lie opposite to each other, the layer is that of most hcp atoms about.
  void settle_normals() {
    std::vector<std::uint32_t> doubtful;
    for (const LayerAtom& atom : atoms_)
      if (is_doubtful(atom)) doubtful.push_back(atom.place);
    std::vector<LayerAtom> settled(doubtful.size());
    for_neighbours(sites_, doubtful, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
      settled[k] = by_neighbours(doubtful[k], found);
    });
    for (LayerAtom& atom : settled) atoms_[index_of(atom.place)] = std::move(atom);
  }

  LayerAtom by_neighbours(std::uint32_t place, const Neighbours& found) const {
    std::vector<Eigen::Vector3d> normals;
    for (const Neighbour& n : found)
      if (n.d2 <= touching * touching && is_hcp(n.place) && !atoms_[index_of(n.place)].in_plane.empty())
        normals.push_back(atoms_[index_of(n.place)].normal);
    const auto normal = most_frequent(normals);
    return normal ? layer_atom(place, found, *normal) : atoms_[index_of(place)];
  }

  std::size_t index_of(std::uint32_t place) const {  // of one that is hcp
    return static_cast<std::size_t>(std::ranges::lower_bound(places_, place) - places_.begin());
  }

  bool any_parallel(const LayerAtom& atom, const std::vector<std::uint32_t>& places) const {
    return std::any_of(places.begin(), places.end(), [&](std::uint32_t place) {
      return parallel_at(atom, place) != none;
    });
  }

  bool any_other(const LayerAtom& atom) const {
    const auto other = [&](std::uint32_t place) {
      return sites_.structure[place] == Structure::other;
    };
    return std::any_of(atom.side[0].begin(), atom.side[0].end(), other) ||
           std::any_of(atom.side[1].begin(), atom.side[1].end(), other);
  }

  void find_kinds() {
    for_neighbours(sites_, places_, [&](std::size_t k, const Neighbours& found, NeighbourSearch& search) {
      LayerAtom& atom = atoms_[k];
      if (atom.side[0].size() != 3 || atom.side[1].size() != 3) return;
      if (!atom.hcp_beside) find_partners(atom, found, search);
      atom.kind = atom.hcp_beside ? PlanarFault::intrinsic
                  : atom.partners.empty() ? PlanarFault::twin : PlanarFault::extrinsic;
      atom.sure = atom.kind != PlanarFault::twin || !any_other(atom);
    });
  }

  /// Where atoms beside the layer have no structure, as at the surface, the kind is that of most
  /// neighbours in the layer.
  void settle_kinds() {
    std::vector<PlanarFault> settled;
    for (const LayerAtom& atom : atoms_) settled.push_back(atom.sure ? atom.kind : most(atom));
    for (std::size_t k = 0; k < atoms_.size(); ++k) atoms_[k].kind = settled[k];
  }

  PlanarFault most(const LayerAtom& atom) const {
    std::array<int, 4> votes{};
    for (const std::uint32_t place : atom.in_plane) {
      const std::uint32_t k = parallel_at(atom, place);
      if (k != none && atoms_[k].sure) ++votes[static_cast<std::size_t>(atoms_[k].kind)];
    }
    const auto best = std::max_element(votes.begin(), votes.end());
    return *best > 0 ? static_cast<PlanarFault>(best - votes.begin()) : atom.kind;
  }

  /// Parallel hcp atoms two layers away, through the neighbours on either side.
  void find_partners(LayerAtom& atom, const Neighbours& found, NeighbourSearch& search) const {
    Neighbours theirs;
    for (const Neighbour& n : found) {
      const double height = n.offset.cast<double>().dot(atom.normal);
      const bool beside = std::find(atom.side[height > 0].begin(), atom.side[height > 0].end(),
                                    n.place) != atom.side[height > 0].end();
      if (!beside) continue;
      search.about(n.place, theirs);
      for (const Neighbour& next : theirs) {
        const double more = next.offset.cast<double>().dot(atom.normal);
        if (next.d2 > touching * touching || std::abs(height + more) < second_layer) continue;
        if (parallel_at(atom, next.place) != none) atom.partners.push_back(next.place);
      }
    }
    std::sort(atom.partners.begin(), atom.partners.end());
    atom.partners.erase(std::unique(atom.partners.begin(), atom.partners.end()),
                        atom.partners.end());
  }

  const Sites& sites_;
  std::vector<std::uint32_t> places_;
  std::vector<LayerAtom> atoms_;
};

bool at_edge(Site site) { return site == Site::surface || site == Site::contact; }

/// The layer atoms of one fault together.
class Piece {
 public:
  void add(const FaultFinder::Atom& atom) {
    if (plane_.atoms++ == 0) {
      plane_.kind = atom.kind;
      plane_.body = atom.body;
      plane_.normal = plane_.centre = Eigen::Vector3d::Zero();
      first_ = atom.normal;
    }
    plane_.centre += atom.at;
    plane_.normal += atom.normal.dot(first_) < 0 ? Eigen::Vector3d(-atom.normal) : atom.normal;
    area_ += atom.area;
  }
  void add_edge(std::uint32_t atom) { edge_.push_back(atom); }
  std::size_t atoms() const { return plane_.atoms; }

  /// Two layers of hcp atoms make a stacking fault, one a twin boundary. The atoms at the surface go on
  /// with the layer.
  FaultPlane finish(double spacing) {
    std::sort(edge_.begin(), edge_.end());
    edge_.erase(std::unique(edge_.begin(), edge_.end()), edge_.end());
    const auto count = static_cast<double>(plane_.atoms);
    const auto edge = static_cast<double>(edge_.size());
    const double layers = plane_.kind == PlanarFault::twin ? 1 : 2;
    const double cell = area_ / count * spacing * spacing / layers;
    plane_.area = cell * (count + edge);
    plane_.error = cell * std::max(1.0, 2 * std::sqrt(edge / 12));
    plane_.centre /= count;
    plane_.normal.normalize();
    return plane_;
  }

 private:
  FaultPlane plane_;
  Eigen::Vector3d first_;
  double area_ = 0;                  ///< [spacings^2]
  std::vector<std::uint32_t> edge_;  ///< indices in the frame
};

}  // namespace

HcpLayer hcp_layer(const std::array<Neighbour, 12>& twelve) {
  HcpLayer layer{opposite_six(twelve), {}};
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 12; ++k) {
    const Eigen::Vector3d u = twelve[k].offset.cast<double>();
    if (layer.in_plane[k]) spread += u * u.transpose();
  }
  layer.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return layer;
}

void FaultFinder::add(const Sites& sites) {
  const Layers layers(sites);
  for (const LayerAtom& atom : layers.atoms()) {
    if (!sites.is_own(atom.place)) continue;
    const std::uint32_t index = sites.index(atom.place);
    atoms_.push_back({index, sites.body[atom.place], atom.kind, atom.area, atom.normal, sites.position(atom.place)});
    for (const auto* places : {&atom.in_plane, &atom.side[0], &atom.side[1], &atom.partners})
      for (const std::uint32_t place : *places)
        if (layers.parallel_at(atom, place) != none) links_.emplace_back(index, sites.index(place));
    for (const std::uint32_t place : atom.in_plane)
      if (at_edge(sites.site[place])) edges_.emplace_back(index, sites.index(place));
  }
}

std::size_t FaultFinder::place_of(std::uint32_t index) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(atoms_, index, {}, &Atom::index) - atoms_.begin());
}

std::vector<FaultPlane> FaultFinder::planes(double spacing) {
  std::ranges::sort(atoms_, {}, &Atom::index);
  DisjointSets sets(atoms_.size());
  for (const auto& [from, to] : links_) {
    const std::size_t a = place_of(from), b = place_of(to);
    if (atoms_[a].kind == atoms_[b].kind) sets.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  }
  std::map<std::uint32_t, Piece> pieces;
  for (std::uint32_t k = 0; k < atoms_.size(); ++k)
    if (atoms_[k].kind != PlanarFault::none) pieces[sets.root(k)].add(atoms_[k]);
  for (const auto& [atom, edge] : edges_) {
    const auto piece = pieces.find(sets.root(static_cast<std::uint32_t>(place_of(atom))));
    if (piece != pieces.end()) piece->second.add_edge(edge);
  }
  std::vector<FaultPlane> planes;
  for (auto& [root, piece] : pieces)
    if (piece.atoms() >= least_plane) planes.push_back(piece.finish(spacing));
  std::ranges::stable_sort(planes, std::greater(), &FaultPlane::area);
  return planes;
}

}  // namespace mdana::defects
