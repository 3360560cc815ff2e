// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/frames.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace mdana::defects {
namespace {

constexpr double farthest = 0.45;  ///< [spacings] of a neighbour from its ideal place, as in repair
/// Vectors that two bonded atoms have in common: each other, and their neighbours.
constexpr std::size_t full_agreement = 5, least_agreeing = 3;

/// Bodies turned by less against each other may be one crystal [rad].
constexpr double same_lattice = 5 * std::numbers::pi / 180;

/// A crystalline atom with what it has in the axes of its own cube.
struct OwnFrame {
  int kind = -1;        ///< of templates(); -1: not found
  Eigen::Matrix3d map;  ///< from them to [spacings]
  std::array<std::uint32_t, 12> places;
};

/// Fills the places of a template; false if one stays empty.
bool fill(OwnFrame& frame, int kind, const Eigen::Matrix3d& map, const Neighbours& found) {
  std::uint64_t taken = 0;
  const auto& ideal = templates()[static_cast<std::size_t>(kind)].neighbours;
  for (std::size_t k = 0; k < 12; ++k) {
    const Eigen::Vector3d at = map * ideal[k];
    double least = farthest * farthest;
    std::size_t filler = 64;
    for (std::size_t n = 0; n < std::min<std::size_t>(found.size(), 64); ++n) {
      const double d2 = (found[n].offset.cast<double>() - at).squaredNorm();
      if (!(d2 < least)) continue;
      least = d2;
      filler = n;
    }
    if (filler == 64 || (taken >> filler & 1)) return false;
    taken |= std::uint64_t{1} << filler;
    frame.places[k] = found[filler].place;
  }
  frame.kind = kind;
  frame.map = map;
  return true;
}

/// Linear map from the template's neighbours to those that fill it: least squares.
Eigen::Matrix3d fitted(const OwnFrame& frame, const Neighbours& found) {
  const auto& ideal = templates()[static_cast<std::size_t>(frame.kind)].neighbours;
  Eigen::Matrix3d measured = Eigen::Matrix3d::Zero(), square = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 12; ++k) {
    const auto n = std::ranges::find(found, frame.places[k], &Neighbour::place);
    measured += n->offset.cast<double>() * ideal[k].transpose();
    square += ideal[k] * ideal[k].transpose();
  }
  return measured * square.inverse();
}

/// The map of a hcp atom: three neighbours on one side of its layer are primitive vectors of fcc.
std::optional<Eigen::Matrix3d> hcp_map(const Neighbours& found) {
  const auto twelve = nearest_twelve(found);
  if (!twelve) return std::nullopt;
  const HcpLayer layer = hcp_layer(*twelve);
  Eigen::Matrix3d side;
  int count = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    const Eigen::Vector3d u = (*twelve)[k].offset.cast<double>();
    if (layer.in_plane[k] || u.dot(layer.normal) < 0) continue;
    if (count == 3) return std::nullopt;
    side.col(count++) = u;
  }
  if (count != 3) return std::nullopt;
  if (side.determinant() < 0) side.col(1).swap(side.col(2));
  Eigen::Matrix3d ideal;  // the upper neighbours of the template, whose normal is [111]
  ideal << 0, 1, 1, 1, 0, 1, 1, 1, 0;
  return Eigen::Matrix3d(side * (ideal / std::sqrt(2.0)).inverse());
}

OwnFrame own_frame(Structure structure, const Neighbours& found) {
  OwnFrame frame;
  std::optional<Eigen::Matrix3d> map;
  if (structure == Structure::hcp) {
    map = hcp_map(found);
  } else {
    const auto twelve = nearest_twelve(found);
    if (twelve) map = deformation(*twelve);
  }
  if (map && fill(frame, structure == Structure::hcp ? 1 : 0, *map, found)) frame.map = fitted(frame, found);
  return frame;
}

/// The frame that a fcc neighbour's lattice gives an atom.
OwnFrame frame_beside(const Eigen::Matrix3d& map, Structure structure, const Neighbours& found) {
  OwnFrame frame;
  if (structure == Structure::fcc) {
    fill(frame, 0, map, found);
  } else {
    for (int kind = 1; kind < 9 && frame.kind < 0; ++kind) fill(frame, kind, map, found);
  }
  if (frame.kind >= 0) frame.map = fitted(frame, found);
  return frame;
}

class FrameFinder {
 public:
  FrameFinder(const Sites& sites, const Zone& zone, std::span<const std::uint32_t> places,
              std::span<const BodyLattice, 2> lattices)
      : sites_(sites), zone_(zone), places_(places.begin(), places.end()), lattices_(lattices), own_(zone.size()) {
    one_lattice_ = lattices[0].share > 0 && lattices[1].share > 0 &&
                   misorientation(lattices[0].turn, lattices[1].turn) < same_lattice;
    for (std::uint32_t i = 0; i < places_.size(); ++i) by_place_.emplace_back(places_[i], i);
    std::ranges::sort(by_place_);
  }

  ZoneCrystal find() {
    find_own();
    find_beside();
    crystal_.grain.assign(zone_.size(), ZoneCrystal::no_grain);
    crystal_.framed.resize(zone_.size());
    crystal_.bonds.resize(zone_.size());
    crystal_.map.resize(zone_.size());
    crystal_.turn.resize(zone_.size());
    for (const Structure root : {Structure::fcc, Structure::hcp})
      for (std::uint32_t i = 0; i < zone_.size(); ++i)
        if (own_[i].kind >= 0 && !crystal_.framed[i] && structure(i) == root) grow(i);
    spread();
    return std::move(crystal_);
  }

 private:
  BodyIndex body(std::uint32_t i) const { return sites_.body[places_[i]]; }
  Structure structure(std::uint32_t i) const { return sites_.structure[places_[i]]; }

  std::uint32_t zone_atom(std::uint32_t place) const {
    const auto at = std::ranges::lower_bound(by_place_, std::pair{place, 0u});
    return at != by_place_.end() && at->first == place ? at->second : no_atom;
  }

  static bool crystalline(Structure s) { return s == Structure::fcc || s == Structure::hcp; }

  void find_own() {
    for_neighbours(sites_, places_, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
      const Structure s = sites_.structure[places_[k]];
      if (crystalline(s)) own_[k] = own_frame(s, found);
      for (std::uint32_t& place : own_[k].places)
        if (own_[k].kind >= 0) place = zone_atom(place);
    });
  }

  /// Atoms whose frame noise hides get it from a fcc neighbour.
  void find_beside() {
    std::vector<std::uint32_t> hidden, places;
    for (std::uint32_t i = 0; i < own_.size(); ++i)
      if (own_[i].kind < 0 && crystalline(structure(i))) hidden.push_back(i);
    for (const std::uint32_t i : hidden) places.push_back(places_[i]);
    std::vector<OwnFrame> frames(hidden.size());
    for_neighbours(sites_, places, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
      for (const Neighbour& n : found) {
        if (frames[k].kind >= 0 || n.d2 > touching * touching) continue;
        const std::uint32_t beside = zone_atom(n.place);
        if (beside == no_atom || own_[beside].kind != 0) continue;
        frames[k] = frame_beside(own_[beside].map, structure(hidden[k]), found);
      }
      for (std::uint32_t& place : frames[k].places)
        if (frames[k].kind >= 0) place = zone_atom(place);
    });
    for (std::size_t k = 0; k < hidden.size(); ++k) own_[hidden[k]] = frames[k];
  }

  static std::span<const Ideal, 12> ideal(const OwnFrame& frame) {
    return ideal_neighbours()[static_cast<std::size_t>(frame.kind)];
  }

  /// What an unframed atom and a framed one, bonded to each other, say of each other and of their common
  /// neighbours: in the axes of the first, and in those of the grain.
  std::vector<IdealPair> common(std::uint32_t next, std::uint32_t from) const {
    std::vector<IdealPair> pairs;
    const OwnFrame& own = own_[next];
    const auto to_next = std::ranges::find(crystal_.bonds[from], next, &IdealBond::atom);
    if (to_next == crystal_.bonds[from].end()) return pairs;
    bool mutual = false;
    for (std::size_t k = 0; k < 12; ++k) {
      if (own.places[k] == no_atom) continue;
      if (own.places[k] == from) {
        pairs.emplace_back(ideal(own)[k], -to_next->ideal());
        mutual = true;
        continue;
      }
      const auto shared = std::ranges::find(crystal_.bonds[from], own.places[k], &IdealBond::atom);
      if (shared != crystal_.bonds[from].end())
        pairs.emplace_back(ideal(own)[k], shared->ideal() - to_next->ideal());
    }
    if (!mutual) pairs.clear();
    return pairs;
  }

  void set(std::uint32_t i, const LatticeTurn& turn, std::uint32_t grain) {
    crystal_.framed[i] = 1;
    crystal_.grain[i] = grain;
    ++crystal_.grains[grain].atoms;
    for (std::size_t k = 0; k < 12; ++k) {
      IdealBond& bond = crystal_.bonds[i][k];
      bond.atom = own_[i].places[k];
      const Ideal v = *turn.turned(ideal(own_[i])[k]);
      for (Eigen::Index a = 0; a < 3; ++a) bond.vector[static_cast<std::size_t>(a)] = static_cast<std::int8_t>(v[a]);
    }
    const double neighbour = ideal_parts / std::sqrt(2.0);
    crystal_.turn[i] = turn.real().cast<float>();
    crystal_.map[i] = (own_[i].map * turn.real().transpose() / neighbour).cast<float>();
  }

  /// All bonds of a template have whole components after the turn.
  static bool exact(const OwnFrame& frame, const LatticeTurn& turn) {
    return std::ranges::all_of(ideal(frame), [&](const Ideal& v) { return turn.turned(v).has_value(); });
  }

  /// From a framed atom to a neighbour; the turn of the neighbour if it is known already.
  struct Step {
    std::uint32_t from, next;
    LatticeTurn turn;
  };

  /// The steps of a grain that are to do: those not looked at, and others by how many pairs agree.
  struct Steps {
    std::vector<Step> fresh;
    std::array<std::vector<Step>, 13> doubtful;

    std::vector<Step>* next() {
      if (!fresh.empty()) return &fresh;
      const auto most = std::find_if(doubtful.rbegin(), doubtful.rend(), [](const auto& s) { return !s.empty(); });
      return most == doubtful.rend() ? nullptr : &*most;
    }
  };

  void add_steps(Steps& steps, std::uint32_t from) const {
    for (const IdealBond& bond : crystal_.bonds[from])
      if (bond.atom != no_atom && own_[bond.atom].kind >= 0 && !crystal_.framed[bond.atom] &&
          (one_lattice_ || body(bond.atom) == body(from)))
        steps.fresh.push_back({from, bond.atom, {}});
  }

  /// Looks at a step: true if all agree on it, else it is doubtful, or none.
  bool certain(Step& step, Steps& steps) const {
    const auto pairs = common(step.next, step.from);
    const Agreement found = best_turn(pairs);
    if (found.pairs < least_agreeing || 2 * found.pairs <= pairs.size()) return false;
    if (!exact(own_[step.next], found.turn)) return false;
    step.turn = found.turn;
    if (found.pairs == pairs.size() && found.pairs == full_agreement) return true;
    steps.doubtful[found.pairs].push_back(step);
    return false;
  }

  /// A grain from an atom on, first where atoms agree on all.
  void grow(std::uint32_t root) {
    const auto grain = static_cast<std::uint32_t>(crystal_.grains.size());
    crystal_.grains.push_back({body(root), 0, false});
    set(root, root_turn(root, crystal_.grains.back().aligned), grain);
    Steps steps;
    add_steps(steps, root);
    while (auto* const most = steps.next()) {
      const bool fresh = most == &steps.fresh;
      Step step = most->back();
      most->pop_back();
      if (crystal_.framed[step.next] || (fresh && !certain(step, steps))) continue;
      set(step.next, step.turn, grain);
      add_steps(steps, step.next);
    }
  }

  /// From the cube about an atom to the axes of its body's lattice, if that is the same or a twin.
  LatticeTurn root_turn(std::uint32_t i, bool& aligned) const {
    constexpr double degree = std::numbers::pi / 180;
    constexpr std::array<double, 3> most{25 * degree, 20 * degree, 10 * degree};
    const BodyLattice& lattice = lattices_[body(i) - 1u];
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(own_[i].map, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
    const Eigen::Matrix3d wanted =
        lattice.share > 0 ? Eigen::Matrix3d(lattice.turn.toRotationMatrix().transpose() * turn) : turn;
    const OrderedTurn* best = nullptr;
    double least = HUGE_VAL;
    for (const OrderedTurn& t : lattice_turns()) {
      const double angle = Eigen::AngleAxisd(Eigen::Matrix3d(t.turn.real().transpose() * wanted)).angle();
      const bool fits = angle < most[static_cast<std::size_t>(t.order)];
      if (fits == aligned ? angle >= least : !fits) continue;
      if (fits && aligned && best && t.order > best->order && angle + 5 * degree > least) continue;
      best = &t;
      least = angle;
      aligned = fits;
    }
    return best->turn;
  }

  /// Atoms without a frame get grain and map of the nearest framed ones of their body, from neighbour to
  /// neighbour.
  void spread() {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < zone_.size(); ++i)
      if (!crystal_.framed[i]) left.push_back(i);
    while (!left.empty()) {
      std::vector<std::uint32_t> places, from(left.size(), no_atom);
      for (const std::uint32_t i : left) places.push_back(places_[i]);
      for_neighbours(sites_, places, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
        float least = HUGE_VALF;
        for (const Neighbour& n : found) {
          const std::uint32_t i = zone_atom(n.place);
          if (i == no_atom || crystal_.grain[i] == ZoneCrystal::no_grain || !(n.d2 < least)) continue;
          if (sites_.body[n.place] != sites_.body[places[k]]) continue;
          least = n.d2;
          from[k] = i;
        }
      });
      std::vector<std::uint32_t> still;
      for (std::size_t k = 0; k < left.size(); ++k) {
        if (from[k] == no_atom) {
          still.push_back(left[k]);
          continue;
        }
        crystal_.grain[left[k]] = crystal_.grain[from[k]];
        crystal_.map[left[k]] = crystal_.map[from[k]];
        crystal_.turn[left[k]] = crystal_.turn[from[k]];
      }
      if (still.size() == left.size()) return;
      left = std::move(still);
    }
  }

  const Sites& sites_;
  const Zone& zone_;
  std::vector<std::uint32_t> places_;
  std::span<const BodyLattice, 2> lattices_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_place_;  ///< and atom of the zone
  bool one_lattice_;           ///< the two bodies are one crystal where they touch
  std::vector<OwnFrame> own_;  ///< their places are atoms of the zone
  ZoneCrystal crystal_;
};

}  // namespace

ZoneCrystal find_frames(const Sites& sites, const Zone& zone, std::span<const std::uint32_t> places,
                        std::span<const BodyLattice, 2> lattices) {
  return FrameFinder(sites, zone, places, lattices).find();
}

}  // namespace mdana::defects
