// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/find_lines.hpp"

#include <algorithm>

#include "analyses/defects/lines/network.hpp"
#include "analyses/defects/lines/segments.hpp"

namespace mdana::defects {
namespace {

// In spacings.
constexpr double widest_gap = 2.5;   ///< of a line in crystal that was not triangulated, or in a hole of its core
constexpr Closeness close{1.2, 2.5, 2};  ///< cores are not resolved, nor is the boundary to another lattice
constexpr double smoothing = 4;      ///< along a line on either side
constexpr double less_smoothing = 2.5;
constexpr double about_end = 2;      ///< of a line: what may belong to it
constexpr int most_rounds = 8;       ///< of a wider zone, while lines leave it
constexpr double step = 0.5;         ///< between the points of a line

bool at_surface(Site site) { return site == Site::surface || site == Site::contact; }

/// Atoms at the surface that touch a seed become seeds.
void add_surface_beside(std::vector<char>& seeds, const Sites& sites) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t p = 0; p < seeds.size(); ++p)
    if (seeds[p]) places.push_back(p);
  std::vector<std::vector<std::uint32_t>> beside(places.size());
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    for (const Neighbour& n : found)
      if (n.d2 < touching * touching && at_surface(sites.site[n.place])) beside[k].push_back(n.place);
  });
  for (const auto& some : beside)
    for (const std::uint32_t place : some) seeds[place] = 1;
}

/// Atoms in and beside dislocations: bulk defects, hcp atoms at the rim of their layer, and atoms at the surface that
/// touch one of these.
std::vector<char> line_seeds(const Sites& sites) {
  std::vector<char> seeds(sites.site.size());
  const auto hcp = places_of(sites, Structure::hcp);
  for_neighbours(sites, hcp, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    const auto twelve = nearest_twelve(found);
    if (!twelve) return;
    const HcpLayer layer = hcp_layer(*twelve);
    for (std::size_t n = 0; n < 12; ++n)
      if (layer.in_plane[n] && sites.structure[(*twelve)[n].place] != Structure::hcp) seeds[hcp[k]] = 1;
  });
  for (std::uint32_t p = 0; p < seeds.size(); ++p)
    if (sites.site[p] == Site::bulk_defect) seeds[p] = 1;
  add_surface_beside(seeds, sites);
  return seeds;
}

/// The places of the zone's atoms, whose order is that of the frame.
std::vector<std::uint32_t> places_in(const Sites& sites, const Zone& zone) {
  std::vector<std::uint32_t> places(zone.size());
  for (std::uint32_t p = 0; p < sites.grid.atom.size(); ++p) {
    const auto at = std::ranges::lower_bound(zone.atom, sites.grid.atom[p]);
    if (at != zone.atom.end() && *at == sites.grid.atom[p]) places[static_cast<std::size_t>(at - zone.atom.begin())] = p;
  }
  return places;
}

/// What is found about some seeds.
struct Found {
  Zone zone;
  ZoneCrystal crystal;
  LineNetwork network;
  std::vector<Corners> pierced;  ///< facets before they are tightened, as atoms of the frame; in order
};

/// The facets with a Burgers vector, as atoms of the frame.
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

/// The lines among the atoms about the seeds, their gaps bridged.
Found look_about(const std::vector<char>& seeds, const Sites& sites, const FrameAtoms& atoms,
                 std::span<const BodyLattice, 2> lattices) {
  Found found;
  found.zone = zone_about(sites, atoms, seeds, 0);
  const Zone& zone = found.zone;
  if (zone.size() < 4) return found;
  const std::vector<std::uint32_t> places = places_in(sites, zone);
  std::vector<Tetrahedron> cells = triangulate(zone, true, sites.threads).cells;
  found.crystal = find_frames(sites, zone, places, lattices);
  Edges edges = find_edges(zone, found.crystal, cells, sites.threads);
  const std::vector<Corners> walls = remove_foreign(cells, edges);
  found.pierced = pierced_facets(zone, cells, edges);
  tighten(edges, cells);
  std::vector<Site> site;
  for (const std::uint32_t place : places) site.push_back(sites.site[place]);
  found.network = trace_lines(zone, cells, edges, site, walls);
  bridge_gaps(found.network, widest_gap);
  return found;
}

/// Finds lines in a zone that grows where they leave it.
class Search {
 public:
  Search(const Sites& sites, const FrameAtoms& atoms, std::span<const BodyLattice, 2> lattices, std::vector<char> seeds)
      : sites_(sites), atoms_(atoms), lattices_(lattices), seeds_(std::move(seeds)) {}

  Found run() {
    Found found = look_about(seeds_, sites_, atoms_, lattices_);
    for (int round = 1; round < most_rounds && grow(found); ++round)
      found = look_about(seeds_, sites_, atoms_, lattices_);
    return found;
  }

 private:
  /// True if there are more seeds: about ends inside the crystal, and at the surface about ends beyond which
  /// the line goes on.
  bool grow(const Found& found) {
    const std::vector<char> inside = places_about(found, NodeKind::inside), end = places_about(found, NodeKind::surface);
    const bool more = std::ranges::any_of(inside, [](char c) { return c; });
    const bool further = goes_on(found, end);
    for (std::size_t p = 0; p < seeds_.size(); ++p)
      if (inside[p] || (further && end[p])) seeds_[p] = 1;
    return more || further;
  }

  /// Atoms of the zone near ends of a kind that are no seeds; near the surface those at it.
  std::vector<char> places_about(const Found& found, NodeKind kind) const {
    std::vector<char> wanted(atoms_.size()), places(atoms_.size());
    for (const LineNode& node : found.network.nodes) {
      if (node.kind != kind) continue;
      for (std::uint32_t i = 0; i < found.zone.size(); ++i)
        if (!found.zone.seed[i] && (found.zone.at[i] - node.at).squaredNorm() < about_end * about_end)
          wanted[found.zone.atom[i]] = 1;
    }
    for (std::size_t p = 0; p < places.size(); ++p)
      places[p] = wanted[sites_.grid.atom[p]] && (kind == NodeKind::inside || at_surface(sites_.site[p]));
    return places;
  }

  /// There are pierced facets about more seeds that were not found before.
  bool goes_on(const Found& found, const std::vector<char>& more) const {
    if (std::ranges::none_of(more, [](char c) { return c; })) return false;
    const Found beyond = look_about(more, sites_, atoms_, lattices_);
    return std::ranges::any_of(beyond.pierced, [&](const Corners& f) { return !std::ranges::binary_search(found.pierced, f); });
  }

  const Sites& sites_;
  const FrameAtoms& atoms_;
  std::span<const BodyLattice, 2> lattices_;
  std::vector<char> seeds_;
};

}  // namespace

DislocationLines find_lines(const Sites& sites, const FrameAtoms& atoms, std::span<const BodyLattice, 2> lattices,
                            bool everywhere) {
  const std::vector<char> seeds = everywhere ? std::vector<char>(sites.site.size(), 1) : line_seeds(sites);
  Found found = Search(sites, atoms, lattices, seeds).run();
  LineNetwork& network = found.network;
  if (network.segments.empty()) return {};
  contract(network, close);
  LineNetwork less_smooth = network;
  smooth(network, smoothing, step);
  smooth(less_smooth, less_smoothing, step);
  return described(network, less_smooth, found.zone, found.crystal, atoms, sites.grid.spacing);
}

}  // namespace mdana::defects
