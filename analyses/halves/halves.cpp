// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/halves.hpp"

#include "analyses/block_means.hpp"
#include "analyses/contact_plane.hpp"
#include "analyses/moments.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

/// Of one side: mean height above the plane and mean velocity along its normal, by mass.
using Side = Moments<2>;

class HalvesPartial final : public Partial {
 public:
  HalvesPartial(const FrameContext& frame, const std::array<double, 2>& radius, bool velocity)
      : plane_(frame.motion[0], frame.motion[1], radius, frame.header.place),
        drift_(frame.motion[0].velocity),
        velocity_(velocity) {}

  void add(const LabelledBlock& block) override {
    const VectorColumn x(block.atoms, {"x", "y", "z"});
    const auto v = velocity_ ? VectorColumn(block.atoms, {"vx", "vy", "vz"}) : x;
    for (std::size_t i = 0; i < block.body.size(); ++i) {
      if (block.body[i] != 1 && block.body[i] != 2) continue;
      const double height = plane_.normal.dot(x[i] - plane_.point);
      const double speed = velocity_ ? plane_.normal.dot(v[i] - drift_) : 0;
      side_[height > 0].merge({1, block.mass[i], {height, speed}, 0});
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const HalvesPartial&>(later);
    for (std::size_t k = 0; k < 2; ++k) side_[k].merge(other.side_[k]);
  }

  void pass(Parcel& parcel) override { parcel(side_); }

  void close(std::span<double> row) const override {
    const Eigen::Vector2d apart = side_[1].mean - side_[0].mean;
    std::size_t k = 0;
    row[k++] = apart[0];
    if (velocity_) row[k++] = -apart[1];
    for (const Side& side : side_) row[k++] = static_cast<double>(side.count);
  }

 private:
  ContactPlane plane_;
  Eigen::Vector3d drift_;
  bool velocity_;
  std::array<Side, 2> side_;
};

class Halves final : public Analysis {
 public:
  Halves(const std::array<double, 2>& radius, bool velocity) : radius_(radius), velocity_(velocity) {}

  Needs needs() const override {
    Needs needs{{"x", "y", "z"}, /*after_motion=*/true};
    if (velocity_) needs.columns.add({"vx", "vy", "vz"});
    return needs;
  }
  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> specs{{"half_distance", dimension::length}};
    if (velocity_) specs.push_back({"half_speed", dimension::velocity});
    specs.push_back({"half_atoms1", dimension::none});
    specs.push_back({"half_atoms2", dimension::none});
    return specs;
  }
  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<HalvesPartial>(frame, radius_, velocity_);
  }

 private:
  std::array<double, 2> radius_;
  bool velocity_;
};

}  // namespace

std::unique_ptr<Analysis> make_halves(const std::array<double, 2>& radius, bool velocity) {
  return std::make_unique<Halves>(radius, velocity);
}

extern const AnalysisMember halves_analysis;
const AnalysisMember halves_analysis{
    "halves", "distance and mutual velocity of the atoms on the two sides of the contact plane",
    [](const AnalysisSetup& setup) {
      const std::vector<double>& r = setup.scene.radii;
      return make_halves(r.size() == 2 ? std::array{r[0], r[1]} : std::array{1.0, 1.0},
                         setup.first.has_column("vx"));
    }};

}  // namespace mdana
