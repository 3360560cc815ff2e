// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/frame_look.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyses/defects/atom_measures.hpp"
#include "analyses/defects/lines/columns.hpp"
#include "analyses/defects/spacing.hpp"

namespace mdana::defects {
namespace {

constexpr double parts_a_spacing = 0x1p40;  ///< positions reach 2^22 spacings: 62 bits

double spacing_of(const DefectSettings& settings, const FrameStore& frame, std::size_t threads) {
  return settings.spacing ? *settings.spacing : nearest_neighbour_spacing(frame, threads);
}

/// Of the planes of a body, or of all (0).
double area(const std::vector<FaultPlane>& planes, int body, bool twin) {
  double sum = 0;
  for (const FaultPlane& plane : planes)
    if ((body == 0 || plane.body == body) && (plane.kind == PlanarFault::twin) == twin)
      sum += plane.area;
  return sum;
}

}  // namespace

void ExactMean::add(const Eigen::Vector3d& at) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const auto whole = static_cast<std::int64_t>(
        std::llround((at[axis] - space_.origin[axis]) / space_.spacing * parts_a_spacing));
    high_[k] += whole >> 32;
    low_[k] += static_cast<std::uint64_t>(whole) & 0xffffffffu;
  }
  ++count_;
}

Eigen::Vector3d ExactMean::mean() const {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  if (count_ == 0) return mean;
  for (std::size_t k = 0; k < 3; ++k) {
    const double sum = static_cast<double>(high_[k]) * 0x1p32 + static_cast<double>(low_[k]);
    mean[static_cast<Eigen::Index>(k)] = sum / parts_a_spacing / static_cast<double>(count_);
  }
  return space_.origin + space_.spacing * mean;
}

FrameLook::FrameLook(const DefectSettings& settings, const FrameHeader& header, const FrameStore& frame,
                     std::size_t threads)
    : settings_(settings),
      header_(header),
      frame_(frame),
      threads_(threads),
      shape_(shape_of(frame, settings.surface || settings.lines)),
      space_(shape_.box, spacing_of(settings, frame, threads)),
      defects_(space_),
      lattices_{LatticeSample(1), LatticeSample(2)},
      surfaces_(shape_, space_.spacing),
      lines_(shape_.box.min(), space_.spacing, settings.lines_everywhere) {
  refuse_wrapped(frame, header.box, space_.spacing);
  if (settings.labels) labels_ = collect_labels(frame);
}

FrameDefects FrameLook::fill(std::span<double> row) {
  const Slabs slabs(frame_, space_);
  for (std::size_t k = 0; k < slabs.count(); ++k) {
    auto slab = std::make_unique<LabelledSlab>(slabs.slab(k), space_, settings_, threads_);
    look_at(*slab);
    if (settings_.lines && slab->slab.whole()) whole_ = std::move(slab);
  }
  FrameDefects found;
  found.step = header_.step;
  found.planes = faults_.planes(space_.spacing);
  if (labels_) found.atoms = labels_->finish(clusters_.numbers());
  double* next = put_counts(row.data());
  for (const int body : {0, 1, 2})
    for (const bool twin : {false, true}) *next++ = area(found.planes, body, twin);
  for (const double value : defects_.mean()) *next++ = value;
  next = put_lattices(next);
  found.spacing = space_.spacing;
  if (settings_.surface) next = put_surfaces(found.surfaces = std::move(surfaces_).surfaces(threads_), next);
  if (settings_.lines) {
    find_lines(slabs, found);
    fill_lines(found.lines, found.volume, space_.spacing, row.subspan(static_cast<std::size_t>(next - row.data())));
  }
  return found;
}

LabelledSlab::LabelledSlab(Slab of, const CellSpace& space, const DefectSettings& settings, std::size_t threads)
    : slab(std::move(of)),
      grid(*slab.atoms, space, threads),
      search(settings.by_cgal ? tree_search(grid) : cell_search(grid)),
      sites(grid, search, threads, slab, settings.labels) {
  label_structures(sites, settings.by_cgal);
  repaired = find_sites(sites);
  others = find_other_structures(sites, settings.bcc, settings.ico);
}

void FrameLook::look_at(const LabelledSlab& slab) {
  const Sites& sites = slab.sites;
  counts_.repaired += slab.repaired;
  counts_.bcc += slab.others.bcc;
  counts_.ico += slab.others.ico;
  count(sites);
  faults_.add(sites);
  for (LatticeSample& sample : lattices_) sample.add(sites);
  if (settings_.surface) surfaces_.add(sites);
  if (settings_.lines) lines_.add(sites);
  if (labels_) labels_->add(sites, labels(sites));
}

/// The slabs are labelled again each time that lines leave what was looked at.
void FrameLook::find_lines(const Slabs& slabs, FrameDefects& found) {
  std::array<BodyLattice, 2> lattices;
  for (std::size_t b = 0; b < 2; ++b) {
    lattices[b] = lattices_[b].lattice();
    if (lattices[b].share > 0) found.lattice[b] = lattices[b].turn;
    found.centre[b] = shape_.moments[b + 1].mean;
    found.volume[b] = shape_.moments[b + 1].weight * std::pow(space_.spacing, 3) / std::numbers::sqrt2;
  }
  while (lines_.wants_more(lattices, threads_))
    for (std::size_t k = 0; k < slabs.count(); ++k)
      lines_.add(whole_ ? whole_->sites : LabelledSlab(slabs.slab(k), space_, settings_, threads_).sites);
  found.lines = lines_.lines();
}

void FrameLook::count(const Sites& sites) {
  for (std::size_t p = 0; p < sites.structure.size(); ++p) {
    if (!sites.is_own(p)) continue;
    ++counts_.structure[static_cast<std::size_t>(sites.structure[p])];
    ++counts_.site[static_cast<std::size_t>(sites.site[p])];
    if (sites.structure[p] == Structure::hcp || sites.site[p] == Site::bulk_defect) defects_.add(sites.position(p));
  }
}

AtomLabels FrameLook::labels(const Sites& sites) {
  AtomLabels labels;
  labels.cluster = clusters_.add(sites);
  if (settings_.centro_symmetry) labels.centro_symmetry = centro_symmetry(sites);
  if (settings_.coordination) labels.coordination = coordination(sites);
  labels.structure = sites.structure;
  labels.site = sites.site;
  labels.margin = sites.margin;
  return labels;
}

double* FrameLook::put_counts(double* next) const {
  const auto put = [&](auto value) { *next++ = static_cast<double>(value); };
  const auto of = [&](Structure s) { return counts_.structure[static_cast<std::size_t>(s)]; };
  put(space_.spacing);
  put(of(Structure::fcc));
  put(of(Structure::hcp));
  put(counts_.bcc);
  put(counts_.ico);
  put(of(Structure::other));
  for (const Site site : {Site::surface, Site::contact, Site::bulk_defect})
    put(counts_.site[static_cast<std::size_t>(site)]);
  put(counts_.repaired);
  return next;
}

double* FrameLook::put_lattices(double* next) const {
  for (const LatticeSample& sample : lattices_) {
    const BodyLattice lattice = sample.lattice();
    for (const double value : {lattice.turn.w(), lattice.turn.x(), lattice.turn.y(), lattice.turn.z(), lattice.share})
      *next++ = value;
  }
  return next;
}

double* FrameLook::put_surfaces(const BodySurfaces& surfaces, double* next) const {
  for (std::size_t b = 0; b < 2; ++b) {
    const SurfaceMesh& mesh = surfaces.body[b];
    const auto radii = shape_.ball_radii(static_cast<BodyIndex>(b + 1), space_.spacing);
    for (const double value : {mesh.area(), mesh.area_error, mesh.volume(), mesh.volume_error,
                               mesh.radius(space_.spacing), mesh.radius_error(space_.spacing),
                               static_cast<double>(mesh.voids()), mesh.void_volume(), radii[0], radii[1]})
      *next++ = value;
  }
  *next++ = surfaces.patch.value;
  *next++ = surfaces.patch.error.value_or(0);
  return next;
}

}  // namespace mdana::defects
