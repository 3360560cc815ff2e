// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_radius.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyses/contact_plane.hpp"
#include "analyses/moments.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

/// The atoms of a layer: their moments within the plane, and how many are of which body.
struct Layer {
  Moments<2> moments;
  std::array<std::uint64_t, 2> atoms{};

  void add(BodyIndex body, const Eigen::Vector2d& position) {
    moments.merge({1, 1.0, position, 0});
    ++atoms[body - 1];
  }
  void merge(const Layer& later) {
    moments.merge(later.moments);
    for (std::size_t b = 0; b < 2; ++b) atoms[b] += later.atoms[b];
  }
  void pass(Parcel& parcel) { parcel(moments, atoms); }
  bool touch() const { return atoms[0] > 0 && atoms[1] > 0; }
  double radius() const {
    return touch() ? std::sqrt(2.0 * (moments.spread / moments.weight)) : 0.0;
  }
};

constexpr std::array<double, 3> thickness{1, 0.5, 2};  ///< of the layers, in that of the first

/// Twice the standard error a/sqrt(12 n) of a from n atoms strewn over a disk, and half the jump of
/// a when one more ring of 2 sqrt(pi n) atoms enters at r = a: a/4 of the ring's share of the atoms.
double counting_error(double a, double n) {
  const double ring = 2 * std::sqrt(std::numbers::pi * n);
  return a * std::hypot(1 / std::sqrt(3 * n), 0.25 * ring / (n + ring));
}

class ContactRadiusPartial final : public Partial {
 public:
  ContactRadiusPartial(const ContactPlane& plane, double half_layer)
      : plane_(plane), half_layer_(half_layer) {}

  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    for (std::size_t i = 0; i < x.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b != 1 && b != 2) continue;
      const Eigen::Vector3d r = Eigen::Vector3d(x[i], y[i], z[i]) - plane_.point;
      const double height = std::abs(r.dot(plane_.normal));
      for (std::size_t k = 0; k < thickness.size(); ++k)
        if (height <= thickness[k] * half_layer_)
          layers_[k].add(b, {r.dot(plane_.u), r.dot(plane_.v)});
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const ContactRadiusPartial&>(later);
    for (std::size_t k = 0; k < layers_.size(); ++k) layers_[k].merge(other.layers_[k]);
  }

  void pass(Parcel& parcel) override { parcel(layers_); }

  void close(std::span<double> row) const override {
    const Layer& layer = layers_[0];
    row[0] = layer.radius();
    row[1] = layer.touch() ? error() : 0.0;
    for (std::size_t b = 0; b < 2; ++b) row[2 + b] = static_cast<double>(layer.atoms[b]);
  }

 private:
  /// Besides counting, half of what half or double the thickness changes.
  double error() const {
    const double a = layers_[0].radius();
    double change = 0;
    for (const Layer& other : layers_)
      if (other.touch()) change = std::max(change, std::abs(other.radius() - a));
    return std::hypot(counting_error(a, layers_[0].moments.weight), 0.5 * change);
  }

  ContactPlane plane_;
  double half_layer_;
  std::array<Layer, thickness.size()> layers_;
};

class ContactRadius final : public Analysis {
 public:
  explicit ContactRadius(ContactRadiusSettings settings) : settings_(settings) {}

  Needs needs() const override {
    return {{"x", "y", "z"}, /*after_motion=*/true};
  }
  std::vector<ColumnSpec> columns() const override {
    return {{"contact_radius", dimension::length},
            {"contact_radius_error", dimension::length},
            {"layer_atoms1", dimension::none},
            {"layer_atoms2", dimension::none}};
  }
  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    const ContactPlane plane(frame.motion[0], frame.motion[1], settings_.radius, frame.header.place);
    return std::make_unique<ContactRadiusPartial>(plane, settings_.half_layer);
  }

 private:
  ContactRadiusSettings settings_;
};

}  // namespace

std::unique_ptr<Analysis> make_contact_radius(ContactRadiusSettings settings) {
  return std::make_unique<ContactRadius>(settings);
}

extern const AnalysisMember contact_radius_analysis;
const AnalysisMember contact_radius_analysis{
    "contact_radius", "contact radius from the atoms in a layer about the contact plane",
    [](const AnalysisSetup& setup) {
      const bool known = setup.scene.radii.size() == 2;
      return make_contact_radius(
          {{known ? setup.scene.radii[0] : 1.0, known ? setup.scene.radii[1] : 1.0},
           0.5 * setup.scene.sigma.value_or(1.0)});
    }};

}  // namespace mdana
