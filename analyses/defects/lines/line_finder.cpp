// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/line_finder.hpp"

#include <algorithm>

#include "analyses/defects/lines/network.hpp"
#include "analyses/defects/lines/seeds.hpp"
#include "analyses/defects/lines/segments.hpp"
#include "analyses/defects/lines/surroundings.hpp"

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

/// Marks the places of some atoms.
void mark(std::vector<char>& seeds, const Sites& sites, const Indices& atoms) {
  std::vector<char> wanted(atoms.back() + std::size_t{1});
  for (const std::uint32_t index : atoms) wanted[index] = 1;
  for (std::size_t p = 0; p < seeds.size(); ++p)
    if (sites.index(p) < wanted.size() && wanted[sites.index(p)]) seeds[p] = 1;
}

}  // namespace

/// The lines about some seeds.
struct LineFinder::Found {
  ZoneCrystal crystal;
  LineNetwork network;
  std::vector<Corners> pierced;  ///< before they are tightened
};

struct LineFinder::State {
  Eigen::Vector3d origin;
  double spacing;
  bool everywhere;

  // The slabs that are being added.
  bool first = true;    ///< seeds are those of the rule
  bool trying = false;  ///< seeds are atoms at the surface about ends, which are looked at alone
  Indices wanted;       ///< seeds, but for the first time
  ZoneParts parts;
  std::vector<OwnFrame> own;

  // What is known so far.
  Surroundings known;
  Found found;
  int rounds = 0;

  Surroundings added(std::size_t threads);
  Found find(const Surroundings& about, std::span<const BodyLattice, 2> lattices, std::size_t threads) const;
  Indices near_ends(NodeKind kind) const;
  bool goes_on(const Found& there) const;
  bool look_on();
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
  if (s.first && !s.everywhere) seeds = line_seeds(sites);
  if (!s.first) mark(seeds, sites, s.wanted);
  const auto places = s.parts.add(sites, seeds, 0);
  const auto own = own_frames(sites, places);
  s.own.insert(s.own.end(), own.begin(), own.end());
}

/// What the slabs brought.
Surroundings LineFinder::State::added(std::size_t threads) {
  Surroundings now;
  now.zone = std::move(parts).zone(origin, spacing);
  now.own = std::move(own);
  std::ranges::sort(now.own, {}, &OwnFrame::index);
  now.cells = triangulate(now.zone, true, threads).cells;
  parts = {};
  own = {};
  return now;
}

/// The lines among atoms, their gaps bridged.
LineFinder::Found LineFinder::State::find(const Surroundings& about, std::span<const BodyLattice, 2> lattices,
                                               std::size_t threads) const {
  Found now;
  const Zone& zone = about.zone;
  std::vector<Tetrahedron> cells = about.cells;
  now.crystal = find_frames(zone, about.own, lattices);
  Edges edges = edges_of(zone.size(), cells);
  spread_grains(now.crystal, zone, edges);
  find_vectors(edges, zone, now.crystal, threads);
  const std::vector<Corners> walls = remove_foreign(cells, edges);
  now.pierced = pierced_facets(zone, cells, edges);
  tighten(edges, cells, zone);
  now.network = trace_lines(zone, cells, edges, about.own, walls);
  bridge_gaps(now.network, widest_gap);
  return now;
}

/// Atoms near ends of a kind that were no seeds; near the surface those at it.
Indices LineFinder::State::near_ends(NodeKind kind) const {
  Indices atoms;
  const Zone& zone = known.zone;
  for (const LineNode& node : found.network.nodes) {
    if (node.kind != kind) continue;
    for (std::uint32_t i = 0; i < zone.size(); ++i)
      if (!zone.seed[i] && (zone.at[i] - node.at).squaredNorm() < about_end * about_end &&
          (kind == NodeKind::inside || at_surface(known.own[i].site)))
        atoms.push_back(zone.atom[i]);
  }
  return atoms;
}

/// There are pierced facets that were not found before.
bool LineFinder::State::goes_on(const Found& there) const {
  return std::ranges::any_of(there.pierced,
                             [&](const Corners& f) { return !std::ranges::binary_search(found.pierced, f); });
}

/// About ends inside crystals; if there are none, about those at the surface, to try whether lines go on there.
bool LineFinder::State::look_on() {
  if (++rounds == most_rounds || everywhere) return false;
  first = false;
  wanted = near_ends(NodeKind::inside);
  trying = wanted.empty();
  const Indices beyond = near_ends(NodeKind::surface);
  wanted.insert(wanted.end(), beyond.begin(), beyond.end());
  std::ranges::sort(wanted);
  return !wanted.empty();
}

bool LineFinder::wants_more(std::span<const BodyLattice, 2> lattices, std::size_t threads) {
  State& s = *state_;
  Surroundings now = s.added(threads);
  if (s.trying && !s.goes_on(s.find(now, lattices, threads))) return false;
  s.known.add(std::move(now));
  s.found = s.find(s.known, lattices, threads);
  return s.look_on();
}

DislocationLines LineFinder::lines() {
  Found& found = state_->found;
  if (found.network.segments.empty()) return {};
  contract(found.network, close);
  LineNetwork less_smooth = found.network;
  smooth(found.network, smoothing, step);
  smooth(less_smooth, less_smoothing, step);
  return described(found.network, less_smooth, state_->known.zone, found.crystal);
}

}  // namespace mdana::defects
