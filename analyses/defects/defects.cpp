// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <fmt/format.h>

#include "analyses/defects/atom_measures.hpp"
#include "analyses/defects/labels.hpp"
#include "analyses/defects/lines/columns.hpp"
#include "analyses/defects/lines/find_lines.hpp"
#include "analyses/defects/planes.hpp"
#include "analyses/defects/spacing.hpp"
#include "analyses/defects/surface.hpp"
#include "analyses/moments.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using namespace defects;

/// Throws InputError if a body goes on through a periodic face: its atoms there have no neighbours.
void refuse_wrapped(const FrameAtoms& atoms, const Box& box, double spacing) {
  if (!box.any_periodic()) return;
  const Eigen::Matrix3d scaling = box.edges.inverse();
  for (const int k : {0, 1, 2}) {
    if (!box.periodic[static_cast<std::size_t>(k)]) continue;
    const Eigen::Vector3d across = scaling.row(k);
    std::array<double, 256> lo, hi;
    lo.fill(HUGE_VAL);
    hi.fill(-HUGE_VAL);
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const double s = across.dot(Eigen::Vector3d(atoms.x[i], atoms.y[i], atoms.z[i]));
      lo[atoms.body[i]] = std::min(lo[atoms.body[i]], s);
      hi[atoms.body[i]] = std::max(hi[atoms.body[i]], s);
    }
    for (std::size_t body = 1; body < lo.size(); ++body)
      if (hi[body] - lo[body] > 1 - touching * spacing * across.norm())
        throw InputError(fmt::format(
            "body {} fills the periodic box along {}: it has no surface there, and atoms at the faces "
            "would be taken for one; leave them out by --select, or simulate a particle", body,
            "xyz"[k]));
  }
}

/// The mean place of hcp atoms and bulk defects; zeros if there are none.
Eigen::Vector3d mean_place(const Sites& sites, const FrameAtoms& atoms) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (std::size_t p = 0; p < sites.structure.size(); ++p) {
    if (sites.structure[p] != Structure::hcp && sites.site[p] != Site::bulk_defect) continue;
    const std::uint32_t i = sites.grid.atom[p];
    sum += Eigen::Vector3d(atoms.x[i], atoms.y[i], atoms.z[i]);
    ++count;
  }
  return count > 0 ? Eigen::Vector3d(sum / count) : sum;
}

/// Values by place, in the order of the frame.
template <class T>
std::vector<T> by_atom(const CellGrid& grid, const std::vector<T>& by_place) {
  std::vector<T> values(by_place.size());
  for (std::size_t p = 0; p < by_place.size(); ++p) values[grid.atom[p]] = by_place[p];
  return values;
}

void add_surface_columns(std::vector<ColumnSpec>& all) {
  const ColumnSpec parts[] = {{"surface_area", dimension::area},
                              {"surface_volume", dimension::volume},
                              {"surface_radius", dimension::length},
                              {"voids", dimension::none},
                              {"void_volume", dimension::volume},
                              {"radius_atoms", dimension::length},
                              {"radius_gyration", dimension::length}};
  for (const char* body : {"1", "2"})
    for (const ColumnSpec& part : parts) all.push_back({part.name + body, part.dimension});
  all.push_back({"patch_area", dimension::area});
  all.push_back({"patch_area_error", dimension::area});
}

/// Radii of the ball with as many atoms of fcc, a^3/4 each, and of the one with the same radius of
/// gyration, sqrt(5/3) r_g; 0 without atoms.
std::array<double, 2> ball_radii(const FrameAtoms& atoms, BodyIndex body, double spacing) {
  Moments<3> all;
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (atoms.body[i] == body) all.merge({1, 1, {atoms.x[i], atoms.y[i], atoms.z[i]}, 0});
  if (all.count == 0) return {};
  return {spacing * std::cbrt(3 * all.weight / (4 * std::numbers::pi * std::numbers::sqrt2)),
          std::sqrt(5.0 / 3 * (all.spread / all.weight))};
}

/// Of the atoms of bodies 1 and 2, a^3/4 each [length^3].
std::array<double, 2> volumes(const FrameAtoms& atoms, double spacing) {
  std::array<double, 2> sum{};
  for (const BodyIndex body : atoms.body)
    if (body == 1 || body == 2) sum[body - 1u] += 1;
  for (double& v : sum) v *= spacing * spacing * spacing / std::numbers::sqrt2;
  return sum;
}

/// In the order of these columns; what is left of the row.
std::span<double> fill_surfaces(const BodySurfaces& surfaces, const FrameAtoms& atoms, double spacing, std::span<double> row) {
  std::size_t next = 0;
  for (std::size_t b = 0; b < surfaces.body.size(); ++b) {
    const SurfaceMesh& mesh = surfaces.body[b];
    const auto radii = ball_radii(atoms, static_cast<BodyIndex>(b + 1), spacing);
    for (const double value : {mesh.area(), mesh.volume(), mesh.radius(spacing), static_cast<double>(mesh.voids()),
                               mesh.void_volume(), radii[0], radii[1]})
      row[next++] = value;
  }
  row[next++] = surfaces.patch.value;
  row[next++] = surfaces.patch.error.value_or(0);
  return row.subspan(next);
}

/// A product on its way to the settings' function.
class DefectProduct final : public Product {
 public:
  DefectProduct(const DefectSettings& settings, const FrameHeader& header,
                std::shared_ptr<const FrameAtoms> atoms, FrameDefects found)
      : settings_(settings), header_(header), atoms_(std::move(atoms)), found_(std::move(found)) {}
  void give() override { settings_.product(header_, *atoms_, found_); }

 private:
  const DefectSettings& settings_;
  FrameHeader header_;
  std::shared_ptr<const FrameAtoms> atoms_;
  FrameDefects found_;
};

class Defects final : public FrameAnalysis {
 public:
  explicit Defects(DefectSettings settings) : settings_(std::move(settings)) {}

  Needs needs() const override {
    Needs needs{{"x", "y", "z"}, false, /*whole_frame=*/true};
    if (settings_.ids) needs.columns.add("id");
    if (settings_.types) needs.columns.add("type");
    return needs;
  }

  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> all{{"spacing", dimension::length}};
    for (const char* name : {"fcc", "hcp", "bcc", "ico", "other", "surface", "contact",
                             "bulk_defect", "repaired"})
      all.push_back({name, dimension::none});
    for (const char* of : {"", "1", "2"})
      for (const char* kind : {"fault_area", "twin_area"})
        all.push_back({std::string(kind) + of, dimension::area});
    for (const char* axis : {"x", "y", "z"})
      all.push_back({std::string("defect_") + axis, dimension::length});
    for (const char* body : {"1", "2"})
      for (const char* part : {"lattice_w", "lattice_x", "lattice_y", "lattice_z", "lattice_share"})
        all.push_back({std::string(part) + body, dimension::none});
    if (settings_.surface) add_surface_columns(all);
    if (settings_.lines) add_line_columns(all);
    return all;
  }

  std::unique_ptr<Product> look(const FrameHeader& header, std::shared_ptr<const FrameAtoms> atoms,
                                std::size_t threads, std::span<double> row) const override {
    const CellGrid grid(*atoms, settings_.spacing ? *settings_.spacing
                                                  : nearest_neighbour_spacing(*atoms, threads));
    refuse_wrapped(*atoms, header.box, grid.spacing);
    const SearchMaker search = settings_.by_cgal ? tree_search(grid) : cell_search(grid);
    Sites sites{grid, search, threads, {}, {}, {}, {}};
    for (const std::uint32_t i : grid.atom) sites.body.push_back(atoms->body[i]);
    sites.structure.resize(atoms->size());
    if (settings_.labels) sites.margin.resize(atoms->size());
    FrameDefects found;
    found.step = header.step;
    std::array<BodyLattice, 2> lattices;
    auto rest = fill(*atoms, sites, row, found.planes, lattices);
    found.spacing = grid.spacing;
    for (std::size_t b = 0; b < 2; ++b)
      if (lattices[b].share > 0) found.lattice[b] = lattices[b].turn;
    if (settings_.surface)
      rest = fill_surfaces(found.surfaces = find_surfaces(sites, *atoms), *atoms, grid.spacing, rest);
    if (settings_.lines)
      fill_lines(found.lines = find_lines(sites, *atoms, lattices, settings_.lines_everywhere),
                 volumes(*atoms, grid.spacing), grid.spacing, rest);
    if (!settings_.product) return nullptr;
    found.labels = labels(sites);
    return std::make_unique<DefectProduct>(settings_, header, std::move(atoms), std::move(found));
  }

 private:
  /// Labels the atoms and fills the row, in the order of the columns; what is left of it.
  std::span<double> fill(const FrameAtoms& atoms, Sites& sites, std::span<double> row,
            std::vector<FaultPlane>& planes, std::array<BodyLattice, 2>& lattices) const {
    label_structures(sites, settings_.by_cgal);
    const std::size_t repaired = find_sites(sites, atoms);
    const OtherStructures others = find_other_structures(sites, settings_.bcc, settings_.ico);
    planes = find_planes(sites, atoms);
    auto next = row.begin();
    const auto put = [&](auto value) { *next++ = static_cast<double>(value); };
    const auto of = [&](Structure s) { return std::ranges::count(sites.structure, s); };
    put(sites.grid.spacing);
    put(of(Structure::fcc));
    put(of(Structure::hcp));
    put(others.bcc);
    put(others.ico);
    put(of(Structure::other));
    for (const Site site : {Site::surface, Site::contact, Site::bulk_defect})
      put(std::ranges::count(sites.site, site));
    put(repaired);
    for (const int body : {0, 1, 2})
      for (const bool twin : {false, true}) put(area(planes, body, twin));
    for (const double value : mean_place(sites, atoms)) put(value);
    for (const int body : {1, 2}) {
      const BodyLattice& lattice = lattices[static_cast<std::size_t>(body - 1)] =
          find_lattice(sites, static_cast<BodyIndex>(body));
      for (const double value : {lattice.turn.w(), lattice.turn.x(), lattice.turn.y(),
                                 lattice.turn.z(), lattice.share})
        put(value);
    }
    return row.subspan(static_cast<std::size_t>(next - row.begin()));
  }

  /// Of a body, or of all (0).
  static double area(const std::vector<FaultPlane>& planes, int body, bool twin) {
    double sum = 0;
    for (const FaultPlane& plane : planes)
      if ((body == 0 || plane.body == body) && (plane.kind == PlanarFault::twin) == twin)
        sum += plane.area;
    return sum;
  }

  AtomLabels labels(const Sites& sites) const {
    AtomLabels labels;
    if (!settings_.labels) return labels;
    labels.structure = by_atom(sites.grid, sites.structure);
    labels.site = by_atom(sites.grid, sites.site);
    labels.margin = by_atom(sites.grid, sites.margin);
    labels.cluster = by_atom(sites.grid, find_fcc_clusters(sites));
    if (settings_.centro_symmetry)
      labels.centro_symmetry = by_atom(sites.grid, centro_symmetry(sites));
    if (settings_.coordination) labels.coordination = by_atom(sites.grid, coordination(sites));
    return labels;
  }

  DefectSettings settings_;
};

}  // namespace

std::string_view name(PlanarFault kind) {
  switch (kind) {
    case PlanarFault::intrinsic: return "intrinsic";
    case PlanarFault::extrinsic: return "extrinsic";
    case PlanarFault::twin: return "twin";
    case PlanarFault::none: break;
  }
  return "none";
}

std::unique_ptr<Analysis> make_defects(DefectSettings settings) {
  return std::make_unique<Defects>(std::move(settings));
}

std::optional<Eigen::Quaterniond> lattice_turn(const Table& table, std::size_t row, int body) {
  const auto value = [&](const char* part) {
    return table.column(fmt::format("lattice_{}{}", part, body))[row];
  };
  const Eigen::Quaterniond turn(value("w"), value("x"), value("y"), value("z"));
  if (turn.squaredNorm() == 0) return std::nullopt;
  return turn;
}

extern const AnalysisMember defects_analysis;
const AnalysisMember defects_analysis{
    "defects", "crystal structure of the atoms, stacking faults and twins",
    [](const AnalysisSetup& setup) {
      DefectSettings settings;
      settings.ids = setup.first.has_column("id");
      return make_defects(std::move(settings));
    }};

}  // namespace mdana
