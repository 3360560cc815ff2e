// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_radius.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "analyses/moments.hpp"
#include "analyses/motion.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// A plane with two axes in it.
struct Plane {
  Eigen::Vector3d point, normal, u, v;

  Plane(const BodyMotion& body1, const BodyMotion& body2, const std::array<double, 2>& radius,
        const std::string& place) {
    const Eigen::Vector3d line = body2.position - body1.position;
    const double x = line.norm();
    if (!(x > 0)) throw InputError(fmt::format("{}: the bodies' centres coincide", place));
    normal = line / x;
    const double from_body1 = 0.5 * (x + (radius[0] - radius[1]) * ((radius[0] + radius[1]) / x));
    point = body1.position + from_body1 * normal;
    u = normal.unitOrthogonal();
    v = normal.cross(u);
  }
};

class ContactRadiusPartial final : public Partial {
 public:
  ContactRadiusPartial(const Plane& plane, double half_layer)
      : plane_(plane), half_layer_(half_layer) {}

  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    for (std::size_t i = 0; i < x.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b != 1 && b != 2) continue;
      const Eigen::Vector3d r = Eigen::Vector3d(x[i], y[i], z[i]) - plane_.point;
      if (std::abs(r.dot(plane_.normal)) > half_layer_) continue;
      layer_.merge({1, 1.0, {r.dot(plane_.u), r.dot(plane_.v)}, 0});
      ++atoms_[b - 1];
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const ContactRadiusPartial&>(later);
    layer_.merge(other.layer_);
    for (std::size_t b = 0; b < 2; ++b) atoms_[b] += other.atoms_[b];
  }

  void close(std::span<double> row) const override {
    const bool touch = atoms_[0] > 0 && atoms_[1] > 0;
    row[0] = touch ? std::sqrt(2.0 * (layer_.spread / layer_.weight)) : 0.0;
    row[1] = static_cast<double>(atoms_[0]);
    row[2] = static_cast<double>(atoms_[1]);
  }

 private:
  Plane plane_;
  double half_layer_;
  Moments<2> layer_;
  std::array<std::uint64_t, 2> atoms_{};
};

class ContactRadius final : public Analysis {
 public:
  explicit ContactRadius(ContactRadiusSettings settings) : settings_(settings) {}

  Needs needs() const override {
    return {{"x", "y", "z"}, /*after_motion=*/true};
  }
  std::vector<ColumnSpec> columns() const override {
    return {{"contact_radius", dimension::length},
            {"layer_atoms1", dimension::none},
            {"layer_atoms2", dimension::none}};
  }
  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    const Plane plane(frame.motion[0], frame.motion[1], settings_.radius, frame.header.place);
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
