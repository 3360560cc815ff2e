// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/line_finder.hpp"

#include <algorithm>

#include "analyses/defects/lines/network.hpp"
#include "analyses/defects/lines/seeds.hpp"
#include "analyses/defects/lines/segments.hpp"

namespace mdana::defects {
namespace {

// In spacings.
constexpr double widest_gap = 2.5;       ///< of a line in crystal that was not triangulated, or in a hole of its core
constexpr Closeness close{1.2, 2.5, 2};  ///< cores are not resolved, nor is the boundary to another lattice
constexpr double smoothing = 4;          ///< along a line on either side
constexpr double less_smoothing = 2.5;
constexpr double step = 0.5;       ///< between the points of a line
constexpr double about_end = 2;    ///< of a line: what may belong to it
constexpr int most_rounds = 8;     ///< of looking at more atoms

using Indices = std::vector<std::uint32_t>;  ///< of atoms in the frame, in order

/// The facets with a Burgers vector, as atoms of the frame; in order.
std::vector<Corners> pierced_facets(const Zone& zone, std::span<const Tetrahedron> cells, const Edges& edges) {
  std::vector<Corners> facets;
  for (const Tetrahedron& t : cells)
    for (std::size_t side = 0; side < 4; ++side) {
      const Corners f = ascending(side_of(t, side));
      if (!circulation(edges, f).isZero()) facets.push_back({zone.atom[f[0]], zone.atom[f[1]], zone.atom[f[2]]});
    }
  std::ranges::sort(facets);
  return facets;
}

}  // namespace

/// What is found about some seeds.
struct LineFinder::Found {
  Zone zone;
  std::vector<Site> site;  ///< of its atoms
  ZoneCrystal crystal;
  LineNetwork network;
  std::vector<Corners> pierced;  ///< before they are tightened
};

struct LineFinder::State {
  Eigen::Vector3d origin;
  double spacing;
  bool everywhere;

  // The slabs that are being added.
  Indices wanted;          ///< seeds
  bool by_rule = true;     ///< and those of the rule
  ZoneParts parts;
  std::vector<OwnFrame> own;

  // What is known so far.
  Indices more;    ///< seeds besides those of the rule
  Indices beyond;  ///< atoms at the surface about ends, which are looked at alone
  Found found;
  int rounds = 0;

  Found look(std::span<const BodyLattice, 2> lattices, std::size_t threads);
  Indices near_ends(NodeKind kind) const;
  bool goes_on(const Found& there) const;
  bool look_again(Indices seeds, bool rule);
  void add_seeds(const Indices& seeds);
};

LineFinder::LineFinder(const Eigen::Vector3d& origin, double spacing, bool everywhere)
    : state_(std::make_unique<State>()) {
  state_->origin = origin;
  state_->spacing = spacing;
  state_->everywhere = everywhere;
}

LineFinder::~LineFinder() = default;

void LineFinder::add(const Sites& sites) {
  State& s = *state_;
  std::vector<char> seeds(sites.site.size(), s.everywhere);
  if (s.by_rule && !s.everywhere) seeds = line_seeds(sites);
  if (!s.wanted.empty()) {
    std::vector<char> wanted(s.wanted.back() + std::size_t{1});
    for (const std::uint32_t index : s.wanted) wanted[index] = 1;
    for (std::size_t p = 0; p < seeds.size(); ++p)
      if (sites.index(p) < wanted.size() && wanted[sites.index(p)]) seeds[p] = 1;
  }
  const auto places = s.parts.add(sites, seeds, 0);
  const auto own = own_frames(sites, places);
  s.own.insert(s.own.end(), own.begin(), own.end());
}

/// The lines among the atoms that were added, their gaps bridged.
LineFinder::Found LineFinder::State::look(std::span<const BodyLattice, 2> lattices, std::size_t threads) {
  Found now;
  now.zone = std::move(parts).zone(origin, spacing);
  std::ranges::sort(own, {}, &OwnFrame::index);
  for (const OwnFrame& frame : own) now.site.push_back(frame.site);
  const Zone& zone = now.zone;
  if (zone.size() >= 4) {
    std::vector<Tetrahedron> cells = triangulate(zone, true, threads).cells;
    now.crystal = find_frames(zone, own, lattices);
    Edges edges = edges_of(zone.size(), cells);
    spread_grains(now.crystal, zone, edges);
    find_vectors(edges, zone, now.crystal, threads);
    const std::vector<Corners> walls = remove_foreign(cells, edges);
    now.pierced = pierced_facets(zone, cells, edges);
    tighten(edges, cells);
    now.network = trace_lines(zone, cells, edges, now.site, walls);
    bridge_gaps(now.network, widest_gap);
  }
  parts = {};
  own = {};
  return now;
}

/// Atoms of the zone near ends of a kind that were no seeds; near the surface those at it.
Indices LineFinder::State::near_ends(NodeKind kind) const {
  Indices atoms;
  const Zone& zone = found.zone;
  for (const LineNode& node : found.network.nodes) {
    if (node.kind != kind) continue;
    for (std::uint32_t i = 0; i < zone.size(); ++i)
      if (!zone.seed[i] && (zone.at[i] - node.at).squaredNorm() < about_end * about_end &&
          (kind == NodeKind::inside || at_surface(found.site[i])))
        atoms.push_back(zone.atom[i]);
  }
  return atoms;
}

/// There are pierced facets that were not found before.
bool LineFinder::State::goes_on(const Found& there) const {
  return std::ranges::any_of(there.pierced,
                             [&](const Corners& f) { return !std::ranges::binary_search(found.pierced, f); });
}

void LineFinder::State::add_seeds(const Indices& seeds) {
  more.insert(more.end(), seeds.begin(), seeds.end());
  std::ranges::sort(more);
  more.erase(std::unique(more.begin(), more.end()), more.end());
}

/// The slabs are to be added again.
bool LineFinder::State::look_again(Indices seeds, bool rule) {
  wanted = std::move(seeds);
  std::ranges::sort(wanted);
  by_rule = rule;
  return true;
}

bool LineFinder::wants_more(std::span<const BodyLattice, 2> lattices, std::size_t threads) {
  State& s = *state_;
  bool again = false;
  if (s.by_rule) {
    s.found = s.look(lattices, threads);
    if (++s.rounds == most_rounds || s.everywhere) return false;
    const Indices inside = s.near_ends(NodeKind::inside);
    s.add_seeds(inside);
    s.beyond = s.near_ends(NodeKind::surface);
    if (inside.empty() && !s.beyond.empty()) return s.look_again(s.beyond, false);
    again = !inside.empty();
  } else {
    again = s.goes_on(s.look(lattices, threads));
  }
  s.add_seeds(s.beyond);
  return again && s.look_again(s.more, true);
}

DislocationLines LineFinder::lines() {
  Found& found = state_->found;
  if (found.network.segments.empty()) return {};
  contract(found.network, close);
  LineNetwork less_smooth = found.network;
  smooth(found.network, smoothing, step);
  smooth(less_smooth, less_smoothing, step);
  return described(found.network, less_smooth, found.zone, found.crystal);
}

}  // namespace mdana::defects
