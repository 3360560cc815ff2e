// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/frames.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace mdana::defects {
namespace {

/// Vectors that two bonded atoms have in common: each other, and their neighbours.
constexpr std::size_t full_agreement = 5, least_agreeing = 3;

/// Bodies turned by less against each other may be one crystal [rad].
constexpr double same_lattice = 5 * std::numbers::pi / 180;

class FrameFinder {
 public:
  FrameFinder(const Zone& zone, std::span<const OwnFrame> own, std::span<const BodyLattice, 2> lattices)
      : zone_(zone), lattices_(lattices), own_(own.begin(), own.end()) {
    one_lattice_ = lattices[0].share > 0 && lattices[1].share > 0 &&
                   misorientation(lattices[0].turn, lattices[1].turn) < same_lattice;
    for (OwnFrame& frame : own_)
      for (std::uint32_t& neighbour : frame.neighbours)
        if (frame.kind >= 0) neighbour = zone_atom(neighbour);
  }

  ZoneCrystal find() {
    crystal_.grain.assign(zone_.size(), ZoneCrystal::no_grain);
    crystal_.framed.resize(zone_.size());
    crystal_.bonds.resize(zone_.size());
    crystal_.map.resize(zone_.size());
    crystal_.turn.resize(zone_.size());
    for (const std::uint32_t i : roots())
      if (!crystal_.framed[i]) grow(i);
    unite_aligned();
    return std::move(crystal_);
  }

 private:
  BodyIndex body(std::uint32_t i) const { return zone_.body[i]; }

  /// Of an index in the frame.
  std::uint32_t zone_atom(std::uint32_t index) const {
    const auto at = std::ranges::lower_bound(zone_.atom, index);
    return at != zone_.atom.end() && *at == index ? static_cast<std::uint32_t>(at - zone_.atom.begin()) : no_atom;
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
      if (own.neighbours[k] == no_atom) continue;
      if (own.neighbours[k] == from) {
        pairs.emplace_back(ideal(own)[k], -to_next->ideal());
        mutual = true;
        continue;
      }
      const auto shared = std::ranges::find(crystal_.bonds[from], own.neighbours[k], &IdealBond::atom);
      if (shared != crystal_.bonds[from].end())
        pairs.emplace_back(ideal(own)[k], shared->ideal() - to_next->ideal());
    }
    if (!mutual) pairs.clear();
    return pairs;
  }

  void set(std::uint32_t i, const LatticeTurn& turn, std::uint32_t grain) {
    crystal_.framed[i] = 1;
    crystal_.grain[i] = grain;
    for (std::size_t k = 0; k < 12; ++k) {
      IdealBond& bond = crystal_.bonds[i][k];
      bond.atom = own_[i].neighbours[k];
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

  /// Where grains may begin: fcc atoms first, those with the least misfit first.
  std::vector<std::uint32_t> roots() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < zone_.size(); ++i)
      if (own_[i].kind >= 0) all.push_back(i);
    std::ranges::sort(all, {}, [&](std::uint32_t i) { return std::tuple(own_[i].structure != Structure::fcc, own_[i].misfit, i); });
    return all;
  }

  /// From a framed atom to a neighbour; the turn of the neighbour if it is known already.
  struct Step {
    double worse, better;  ///< misfits
    std::uint32_t from, next;
    LatticeTurn turn = {};

    /// Later.
    bool operator<(const Step& other) const {
      return std::tie(worse, better, from, next) > std::tie(other.worse, other.better, other.from, other.next);
    }
  };

  /// The steps of a grain that are to do: those not looked at, and others by how many pairs agree; each time
  /// the one with the least misfit. So which way leads from one atom to another does not depend on where a grain begins: it is
  /// that of a minimum spanning tree.
  struct Steps {
    std::priority_queue<Step> fresh;
    std::array<std::priority_queue<Step>, 13> doubtful;

    std::priority_queue<Step>* next() {
      if (!fresh.empty()) return &fresh;
      const auto most = std::find_if(doubtful.rbegin(), doubtful.rend(), [](const auto& s) { return !s.empty(); });
      return most == doubtful.rend() ? nullptr : &*most;
    }
  };

  void add_steps(Steps& steps, std::uint32_t from) const {
    for (const IdealBond& bond : crystal_.bonds[from])
      if (bond.atom != no_atom && own_[bond.atom].kind >= 0 && !crystal_.framed[bond.atom] &&
          (one_lattice_ || body(bond.atom) == body(from))) {
        const auto [better, worse] = std::minmax(own_[from].misfit, own_[bond.atom].misfit);
        steps.fresh.push({worse, better, from, bond.atom});
      }
  }

  /// Looks at a step: true if all agree on it, else it is doubtful, or none.
  bool certain(Step& step, Steps& steps) const {
    const auto pairs = common(step.next, step.from);
    const Agreement found = best_turn(pairs);
    if (found.pairs < least_agreeing || 2 * found.pairs <= pairs.size()) return false;
    if (!exact(own_[step.next], found.turn)) return false;
    step.turn = found.turn;
    if (found.pairs == pairs.size() && found.pairs == full_agreement) return true;
    steps.doubtful[found.pairs].push(step);
    return false;
  }

  /// A grain from an atom on, first where atoms agree on all.
  void grow(std::uint32_t root) {
    const auto grain = static_cast<std::uint32_t>(crystal_.grains.size());
    crystal_.grains.push_back({body(root), false});
    set(root, root_turn(root, crystal_.grains.back().aligned), grain);
    Steps steps;
    add_steps(steps, root);
    while (auto* const most = steps.next()) {
      const bool fresh = most == &steps.fresh;
      Step step = most->top();
      most->pop();
      if (crystal_.framed[step.next] || (fresh && !certain(step, steps))) continue;
      set(step.next, step.turn, grain);
      add_steps(steps, step.next);
    }
  }

  /// Grains in the axes of one lattice are one.
  void unite_aligned() {
    std::array<std::uint32_t, 2> of_body{ZoneCrystal::no_grain, ZoneCrystal::no_grain};
    std::vector<std::uint32_t> becomes(crystal_.grains.size());
    for (std::uint32_t g = 0; g < becomes.size(); ++g) {
      becomes[g] = g;
      if (!crystal_.grains[g].aligned) continue;
      std::uint32_t& first = of_body[one_lattice_ ? 0 : crystal_.grains[g].body - 1u];
      if (first == ZoneCrystal::no_grain) first = g;
      becomes[g] = first;
    }
    for (std::uint32_t& grain : crystal_.grain)
      if (grain != ZoneCrystal::no_grain) grain = becomes[grain];
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

  const Zone& zone_;
  std::span<const BodyLattice, 2> lattices_;
  bool one_lattice_;           ///< the two bodies are one crystal where they touch
  std::vector<OwnFrame> own_;  ///< neighbours are atoms of the zone
  ZoneCrystal crystal_;
};

}  // namespace

ZoneCrystal find_frames(const Zone& zone, std::span<const OwnFrame> own, std::span<const BodyLattice, 2> lattices) {
  return FrameFinder(zone, own, lattices).find();
}

}  // namespace mdana::defects
