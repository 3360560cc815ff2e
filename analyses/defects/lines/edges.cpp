// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/edges.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/ranges.hpp"

namespace mdana::defects {
namespace {

constexpr std::size_t atoms_at_once = 1024;

/// An atom's neighbour and the ideal vector to it.
struct Known {
  std::uint32_t atom;
  Ideal vector;
};

/// What is known of ideal vectors from each atom: its own bonds, and those of others to it.
class Vectors {
 public:
  Vectors(const ZoneCrystal& crystal) : crystal_(crystal), start_(crystal.framed.size() + 1) {
    for_reverse([&](std::uint32_t to, std::uint32_t, const Ideal&) { ++start_[to + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    reverse_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for_reverse([&](std::uint32_t to, std::uint32_t from, const Ideal& v) { reverse_[next[to]++] = {from, -v}; });
  }

  /// All from an atom; of two that differ both.
  void from(std::uint32_t atom, std::vector<Known>& known) const {
    known.clear();
    if (crystal_.framed[atom])
      for (const IdealBond& bond : crystal_.bonds[atom])
        if (bond.atom != no_atom) known.push_back({bond.atom, bond.ideal()});
    known.insert(known.end(), reverse_.begin() + start_[atom], reverse_.begin() + start_[atom + 1]);
  }

 private:
  /// Bonds that only one of the two atoms has, or on which they disagree.
  template <class Use>
  void for_reverse(const Use& use) const {
    for (std::uint32_t i = 0; i < crystal_.framed.size(); ++i) {
      if (!crystal_.framed[i]) continue;
      for (const IdealBond& bond : crystal_.bonds[i])
        if (bond.atom != no_atom && !says(bond.atom, i, -bond.ideal())) use(bond.atom, i, bond.ideal());
    }
  }

  bool says(std::uint32_t atom, std::uint32_t other, const Ideal& v) const {
    return crystal_.framed[atom] && std::ranges::any_of(crystal_.bonds[atom], [&](const IdealBond& bond) {
             return bond.atom == other && bond.ideal() == v;
           });
  }

  const ZoneCrystal& crystal_;
  std::vector<std::uint32_t> start_;
  std::vector<Known> reverse_;
};

/// Vectors that were found for an edge, with how often.
class Votes {
 public:
  void clear() { votes_.clear(); }
  void add(const Ideal& v) {
    for (auto& [vector, count] : votes_)
      if (vector == v) {
        ++count;
        return;
      }
    votes_.emplace_back(v, 1);
  }
  bool empty() const { return votes_.empty(); }
  bool unanimous() const { return votes_.size() == 1; }
  int count() const { return votes_.empty() ? 0 : votes_.front().second; }
  /// Of the most frequent ones that which a function makes least.
  template <class Cost>
  Ideal best(const Cost& cost) const {
    return std::ranges::min_element(votes_, {}, [&](const auto& v) {
             return std::pair(-v.second, cost(v.first));
           })->first;
  }

 private:
  std::vector<std::pair<Ideal, int>> votes_;
};

/// Gives edges their vectors. For one thread.
class VectorFinder {
 public:
  VectorFinder(const Zone& zone, const ZoneCrystal& crystal, const Vectors& vectors)
      : zone_(zone), crystal_(crystal), vectors_(vectors) {}

  void start_at(std::uint32_t low) {
    low_ = low;
    vectors_.from(low, from_low_);
  }

  void find(std::uint32_t high, Ideal& vector, EdgeKind& kind) {
    if (crystal_.grain[low_] != crystal_.grain[high] || crystal_.grain[low_] == ZoneCrystal::no_grain) {
      kind = EdgeKind::foreign;
      vector = Ideal::Zero();
      return;
    }
    votes_.clear();
    for (const Known& k : from_low_)
      if (k.atom == high) votes_.add(k.vector);
    bool direct = !votes_.empty();
    if (!direct) add_two_steps(high);
    if (votes_.empty()) {
      vector = guess(high);
      kind = EdgeKind::guessed;
      return;
    }
    vector = votes_.best([&](const Ideal& v) { return strain(high, v); });
    const bool framed = crystal_.framed[low_] || crystal_.framed[high];
    kind = votes_.unanimous() && (direct || (framed && votes_.count() > 1)) ? EdgeKind::sure : EdgeKind::guessed;
  }

 private:
  Eigen::Vector3d real(std::uint32_t high) const { return zone_.at[high] - zone_.at[low_]; }

  Eigen::Matrix3d map(std::uint32_t high) const {
    return (crystal_.map[low_].cast<double>() + crystal_.map[high].cast<double>()) / 2;
  }

  /// How far an ideal vector is from the edge, squared.
  double strain(std::uint32_t high, const Ideal& v) const {
    return (real(high) - map(high) * v.cast<double>()).squaredNorm();
  }

  void add_two_steps(std::uint32_t high) {
    vectors_.from(high, from_high_);
    for (const Known& k : from_low_)
      for (const Known& m : from_high_)
        if (k.atom == m.atom) votes_.add(k.vector - m.vector);
  }

  /// The vector of the lattices about the two atoms that is nearest to the edge.
  Ideal guess(std::uint32_t high) const {
    const auto of = [&](std::uint32_t atom) -> Ideal {
      const Eigen::Matrix3d turn = crystal_.turn[atom].cast<double>();
      const Eigen::Vector3d v = turn.transpose() * map(high).inverse() * real(high) * (std::sqrt(2.0) / ideal_parts);
      return (turn * nearest_lattice_vector(v).cast<double>()).array().round().matrix().cast<int>();
    };
    const Ideal a = of(low_), b = of(high);
    return strain(high, b) < strain(high, a) ? b : a;
  }

  const Zone& zone_;
  const ZoneCrystal& crystal_;
  const Vectors& vectors_;
  std::uint32_t low_ = 0;
  std::vector<Known> from_low_, from_high_;
  Votes votes_;
};

}  // namespace

std::uint32_t Edges::index(std::uint32_t low, std::uint32_t to) const {
  const auto begin = high.begin() + first[low], end = high.begin() + first[low + 1];
  return static_cast<std::uint32_t>(std::lower_bound(begin, end, to) - high.begin());
}

Ideal Edges::along(std::uint32_t from, std::uint32_t to) const {
  if (from < to) return vector[index(from, to)];
  return -vector[index(to, from)];
}

Ideal circulation(const Edges& edges, const Corners& f) {
  return edges.along(f[0], f[1]) + edges.along(f[1], f[2]) + edges.along(f[2], f[0]);
}

std::vector<Corners> remove_foreign(std::vector<Tetrahedron>& cells, const Edges& edges) {
  std::vector<Corners> walls;
  std::erase_if(cells, [&](const Tetrahedron& t) {
    bool foreign = false;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b)
        foreign |= edges.kind[edges.index(std::min(t[a], t[b]), std::max(t[a], t[b]))] == EdgeKind::foreign;
    if (foreign)
      for (std::size_t side = 0; side < 4; ++side) walls.push_back(ascending(side_of(t, side)));
    return foreign;
  });
  std::ranges::sort(walls);
  return walls;
}

Edges edges_of(std::size_t atoms, std::span<const Tetrahedron> cells) {
  std::vector<std::uint32_t> start(atoms + 1);
  const auto for_edges = [&](auto use) {
    for (const Tetrahedron& t : cells)
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < a; ++b) use(std::min(t[a], t[b]), std::max(t[a], t[b]));
  };
  for_edges([&](std::uint32_t low, std::uint32_t) { ++start[low + 1]; });
  for (std::size_t i = 0; i < atoms; ++i) start[i + 1] += start[i];
  std::vector<std::uint32_t> highs(start.back()), next(start.begin(), start.end() - 1);
  for_edges([&](std::uint32_t low, std::uint32_t high) { highs[next[low]++] = high; });
  Edges edges;
  edges.first.resize(atoms + 1);
  for (std::size_t i = 0; i < atoms; ++i) {
    const auto begin = highs.begin() + start[i], end = highs.begin() + start[i + 1];
    std::sort(begin, end);
    edges.high.insert(edges.high.end(), begin, std::unique(begin, end));
    edges.first[i + 1] = static_cast<std::uint32_t>(edges.high.size());
  }
  return edges;
}

void spread_grains(ZoneCrystal& crystal, const Zone& zone, const Edges& edges) {
  std::vector<std::uint32_t> nearest(zone.size());
  std::vector<double> least(zone.size());
  for (;;) {
    std::ranges::fill(nearest, no_atom);
    std::ranges::fill(least, HUGE_VAL);
    const auto offer = [&](std::uint32_t to, std::uint32_t from) {
      if (crystal.grain[to] != ZoneCrystal::no_grain || crystal.grain[from] == ZoneCrystal::no_grain) return;
      if (zone.body[to] != zone.body[from]) return;
      const double d2 = (zone.at[to] - zone.at[from]).squaredNorm();
      if (!(d2 < least[to])) return;
      least[to] = d2;
      nearest[to] = from;
    };
    for (std::uint32_t low = 0; low < zone.size(); ++low)
      for (std::uint32_t e = edges.first[low]; e < edges.first[low + 1]; ++e) {
        offer(low, edges.high[e]);
        offer(edges.high[e], low);
      }
    bool any = false;
    for (std::uint32_t i = 0; i < zone.size(); ++i) {
      if (nearest[i] == no_atom) continue;
      crystal.grain[i] = crystal.grain[nearest[i]];
      crystal.map[i] = crystal.map[nearest[i]];
      crystal.turn[i] = crystal.turn[nearest[i]];
      any = true;
    }
    if (!any) return;
  }
}

void find_vectors(Edges& edges, const Zone& zone, const ZoneCrystal& crystal, std::size_t threads) {
  edges.vector.resize(edges.size());
  edges.kind.resize(edges.size());
  const Vectors vectors(crystal);
  for_ranges(zone.size(), atoms_at_once, threads, [&](std::size_t first, std::size_t end) {
    VectorFinder finder(zone, crystal, vectors);
    for (auto low = static_cast<std::uint32_t>(first); low < end; ++low) {
      if (edges.first[low] == edges.first[low + 1]) continue;
      finder.start_at(low);
      for (std::uint32_t e = edges.first[low]; e < edges.first[low + 1]; ++e)
        finder.find(edges.high[e], edges.vector[e], edges.kind[e]);
    }
  });
}

}  // namespace mdana::defects
