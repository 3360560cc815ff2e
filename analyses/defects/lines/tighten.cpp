// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "analyses/defects/lines/edges.hpp"

namespace mdana::defects {
namespace {

/// A facet at a guessed edge: the other two edges, and how they count.
struct Facet {
  double girth;  ///< of these two [spacings]: for an order that does not depend on how atoms are numbered
  std::uint32_t low_third, high_third;  ///< edges
  int low_sign, high_sign;              ///< in the circulation low, high, third
  bool open = true;                     ///< of one tetrahedron only
  auto operator<=>(const Facet&) const = default;
};

/// Edges whose vectors may be changed, with the facets about them: guessed ones, and those of facets with
/// a Burgers vector; the shortest first.
class Changeable {
 public:
  Changeable(Edges& edges, std::span<const Tetrahedron> cells, const Zone& zone)
      : edges_(edges), zone_(zone), number_(edges.size(), none) {
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      if (edges.kind[e] == EdgeKind::guessed) take(e);
    for (const Tetrahedron& t : cells) take_pierced(t);
    put_in_order();
    facets_.resize(changeable_.size());
    for (const Tetrahedron& t : cells) add(t);
    for (auto& facets : facets_) {
      std::ranges::sort(facets);
      for (std::size_t i = 1; i < facets.size(); ++i)
        if (facets[i] == facets[i - 1]) facets[i - 1].open = facets[i].open = false;
      facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    }
  }

  void tighten() {
    std::set<std::uint32_t> waiting;
    for (std::uint32_t k = 0; k < changeable_.size(); ++k) waiting.insert(k);
    while (!waiting.empty()) {
      const std::uint32_t k = *waiting.begin();
      waiting.erase(waiting.begin());
      if (!improve(k)) continue;
      for (const Facet& f : facets_[k])
        for (const std::uint32_t e : {f.low_third, f.high_third})
          if (number_[e] != none) waiting.insert(number_[e]);
    }
  }

 private:
  static constexpr std::uint32_t none = ~0u;

  void take(std::uint32_t edge) {
    if (number_[edge] != none) return;
    number_[edge] = static_cast<std::uint32_t>(changeable_.size());
    changeable_.push_back(edge);
  }

  void put_in_order() {
    std::vector<double> length(edges_.size());
    for (std::uint32_t low = 0; low < zone_.size(); ++low)
      for (std::uint32_t e = edges_.first[low]; e < edges_.first[low + 1]; ++e)
        if (number_[e] != none) length[e] = distance(low, edges_.high[e]);
    std::ranges::sort(changeable_, {}, [&](std::uint32_t e) { return std::pair(length[e], e); });
    for (std::uint32_t k = 0; k < changeable_.size(); ++k) number_[changeable_[k]] = k;
  }

  double distance(std::uint32_t a, std::uint32_t b) const { return (zone_.at[a] - zone_.at[b]).norm(); }

  void take_pierced(const Tetrahedron& t) {
    for (std::size_t side = 0; side < 4; ++side) {
      const Corners f = side_of(t, side);
      if (defects::circulation(edges_, f).isZero()) continue;
      for (std::size_t k = 0; k < 3; ++k)
        take(edges_.index(std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])));
    }
  }

  void add(const Tetrahedron& t) {
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) {
        if (t[a] >= t[b]) continue;
        const std::uint32_t e = edges_.index(t[a], t[b]);
        if (number_[e] == none) continue;
        for (std::size_t c = 0; c < 4; ++c)
          if (c != a && c != b) facets_[number_[e]].push_back(facet(t[a], t[b], t[c]));
      }
  }

  Facet facet(std::uint32_t low, std::uint32_t high, std::uint32_t third) const {
    const auto side = [&](std::uint32_t a, std::uint32_t b) { return edges_.index(std::min(a, b), std::max(a, b)); };
    return {distance(low, third) + distance(high, third), side(low, third), side(high, third), third < low ? 1 : -1, high < third ? 1 : -1};
  }

  Ideal circulation(std::uint32_t k, const Facet& f) const {
    return edges_.vector[changeable_[k]] + f.high_sign * edges_.vector[f.high_third] +
           f.low_sign * edges_.vector[f.low_third];
  }

  /// A sure vector that all about it contradict in the same way is wrong.
  static bool encircled(const std::vector<Ideal>& about) {
    return about.size() > 2 && std::ranges::all_of(about, [&](const Ideal& b) { return b == about.front(); });
  }

  /// The squares about an edge, of all facets and of the open ones.
  struct Cost {
    std::int64_t all = 0, open = 0;
    /// Ends at the surface may vanish, but not slide along it.
    bool less(const Cost& other, bool at_surface) const {
      return all < other.all && (!at_surface || open <= other.open);
    }
  };

  Cost cost(std::uint32_t k, const std::vector<Ideal>& about, const Ideal& change) const {
    Cost sum;
    for (std::size_t i = 0; i < about.size(); ++i) {
      const std::int64_t square = (about[i] - change).squaredNorm();
      sum.all += square;
      if (facets_[k][i].open) sum.open += square;
    }
    return sum;
  }

  /// Takes the change that makes the sum least, of equal ones the first; false if none makes it less.
  bool improve(std::uint32_t k) {
    std::vector<Ideal> about;
    for (const Facet& f : facets_[k]) about.push_back(circulation(k, f));
    const Cost now = cost(k, about, Ideal::Zero());
    if (now.all == 0) return false;
    if (edges_.kind[changeable_[k]] != EdgeKind::guessed && !encircled(about)) return false;
    const bool at_surface = std::ranges::any_of(facets_[k], &Facet::open);
    Cost least = now;
    Ideal best = Ideal::Zero();
    for (const Ideal& change : about) {
      const Cost then = cost(k, about, change);
      if (!then.less(least, at_surface)) continue;
      least = then;
      best = change;
    }
    if (best.isZero()) return false;
    edges_.vector[changeable_[k]] -= best;
    return true;
  }

  Edges& edges_;
  const Zone& zone_;
  std::vector<std::uint32_t> changeable_;
  std::vector<std::vector<Facet>> facets_;
  std::vector<std::uint32_t> number_;  ///< of each edge among the guessed ones
};

}  // namespace

void tighten(Edges& edges, std::span<const Tetrahedron> cells, const Zone& zone) {
  Changeable(edges, cells, zone).tighten();
}

}  // namespace mdana::defects
