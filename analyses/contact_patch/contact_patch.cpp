// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyses/contact_patch/cross_neighbours.hpp"
#include "analyses/contact_patch/neighbour_offset.hpp"
#include "analyses/contact_plane.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

constexpr double cutoff_change = 0.1;  ///< of the neighbours' cutoff, for the error

/// An equivalent radius; what the choice of thickness or cutoff does to it is part of the error.
struct Radius {
  double value = 0, error = 0;

  Radius() = default;
  explicit Radius(const PatchArea& patch) : value(patch.radius()), error(patch.radius_error()) {}

  /// Half of what another choice changes.
  void widen(double change) { error = std::hypot(error, 0.5 * change); }
};

/// Positions in the plane of the atoms that are chosen; none unless there are some of both bodies.
template <class Chosen>
std::vector<Eigen::Vector2d> touching(const std::vector<ZoneAtom>& atoms, Chosen&& chosen) {
  std::vector<Eigen::Vector2d> points;
  std::array<bool, 2> there{};
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (!chosen(i)) continue;
    points.push_back(atoms[i].position);
    there[atoms[i].body - 1] = true;
  }
  if (!there[0] || !there[1]) points.clear();
  return points;
}

class ContactPatchPartial final : public Partial {
 public:
  ContactPatchPartial(const ContactPlane& plane, const ContactPatchSettings& settings)
      : plane_(plane), settings_(settings) {}

  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    const double zone = std::max(2 * settings_.half_layer, reach());
    for (std::size_t i = 0; i < x.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b != 1 && b != 2) continue;
      const Eigen::Vector3d r = Eigen::Vector3d(x[i], y[i], z[i]) - plane_.point;
      const double height = r.dot(plane_.normal);
      if (std::abs(height) <= zone)
        atoms_.push_back({{r.dot(plane_.u), r.dot(plane_.v)}, height, b});
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const ContactPatchPartial&>(later);
    atoms_.insert(atoms_.end(), other.atoms_.begin(), other.atoms_.end());
  }

  void pass(Parcel& parcel) override { parcel(atoms_); }

  void close(std::span<double> row) const override {
    const Radius alpha = alpha_radius();
    const std::vector<double> distance =
        distance_to_other_body(atoms_, reach(), (1 - cutoff_change) * settings_.cutoff);
    const Radius neighbours = neighbours_radius(distance);
    row[0] = alpha.value;
    row[1] = alpha.error;
    row[2] = neighbours.value;
    row[3] = neighbours.error;
    row[4] = row[5] = 0;
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      if (distance[i] <= settings_.cutoff) ++row[3 + atoms_[i].body];
  }

 private:
  double reach() const { return (1 + cutoff_change) * settings_.cutoff; }

  PatchArea layer(double half) const {
    return patch_area(
        touching(atoms_, [&](std::size_t i) { return std::abs(atoms_[i].height) <= half; }),
        settings_.spacing);
  }

  /// The error has the greater change by half and by double the thickness, as far as they touch.
  Radius alpha_radius() const {
    Radius radius(layer(settings_.half_layer));
    double change = 0;
    for (const double factor : {0.5, 2.0}) {
      const double other = layer(factor * settings_.half_layer).radius();
      if (other > 0) change = std::max(change, std::abs(other - radius.value));
    }
    if (radius.value > 0) radius.widen(change);
    return radius;
  }

  PatchArea neighbours(const std::vector<double>& distance, double cutoff) const {
    return patch_area(touching(atoms_, [&](std::size_t i) { return distance[i] <= cutoff; }),
                      settings_.spacing);
  }

  /// Gap of the surfaces up to which atoms are neighbours: from planes whose nearest atoms are d apart,
  /// which are in contact, to those where they are as far as the cutoff; 5/36 d^2 is the mean square by
  /// which the nearest atom is not opposite.
  double gap() const {
    const double d = settings_.spacing, c = settings_.cutoff, aside = 5.0 / 36 * d * d;
    return std::sqrt(std::max(0.0, c * c - aside)) - std::sqrt(d * d - aside);
  }

  double reduced_radius() const {
    const auto [a, b] = settings_.radius;
    return a * (b / (a + b));
  }

  /// The error has the change by a cutoff that is a tenth less and more, and what the definition reaches
  /// beyond a contact of spheres.
  Radius neighbours_radius(const std::vector<double>& distance) const {
    Radius radius(neighbours(distance, settings_.cutoff));
    const double least = neighbours(distance, (1 - cutoff_change) * settings_.cutoff).radius();
    radius.widen(neighbours(distance, reach()).radius() - least);
    radius.error =
        std::hypot(radius.error, neighbour_offset(radius.value, reduced_radius(), gap()));
    return radius;
  }

  ContactPlane plane_;
  ContactPatchSettings settings_;
  std::vector<ZoneAtom> atoms_;  ///< in the order of the file
};

class ContactPatch final : public Analysis {
 public:
  explicit ContactPatch(ContactPatchSettings settings) : settings_(settings) {}

  Needs needs() const override {
    return {{"x", "y", "z"}, /*after_motion=*/true};
  }
  std::vector<ColumnSpec> columns() const override {
    return {{"contact_radius_alpha", dimension::length},
            {"contact_radius_alpha_error", dimension::length},
            {"contact_radius_neighbours", dimension::length},
            {"contact_radius_neighbours_error", dimension::length},
            {"neighbour_atoms1", dimension::none},
            {"neighbour_atoms2", dimension::none}};
  }
  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    const ContactPlane plane(frame.motion[0], frame.motion[1], settings_.radius,
                             frame.header.place);
    return std::make_unique<ContactPatchPartial>(plane, settings_);
  }

 private:
  ContactPatchSettings settings_;
};

}  // namespace

std::unique_ptr<Analysis> make_contact_patch(ContactPatchSettings settings) {
  return std::make_unique<ContactPatch>(settings);
}

extern const AnalysisMember contact_patch_analysis;
const AnalysisMember contact_patch_analysis{
    "contact_patch", "contact radius from the area of the atoms at the contact plane",
    [](const AnalysisSetup& setup) {
      const bool known = setup.scene.radii.size() == 2;
      const double sigma = setup.scene.sigma.value_or(1.0);
      const double spacing = std::pow(2, 1.0 / 6) * sigma;  // of a pair at rest
      return make_contact_patch({{known ? setup.scene.radii[0] : 1.0,
                                  known ? setup.scene.radii[1] : 1.0},
                                 0.5 * sigma, spacing, default_neighbour_cutoff * spacing});
    }};

}  // namespace mdana
