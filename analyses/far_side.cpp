// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/far_side.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "analyses/motion.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

constexpr std::size_t counted = 4;  ///< outermost atoms that are kept, of which the last one counts

/// The greatest values, descending.
class Greatest {
 public:
  void offer(double value) {
    if (!(value > values_.back())) return;
    const auto place = std::upper_bound(values_.begin(), values_.end(), value, std::greater<>());
    std::move_backward(place, values_.end() - 1, values_.end());
    *place = value;
  }
  void merge(const Greatest& other) {
    for (const double value : other.values_) offer(value);
  }
  void pass(Parcel& parcel) { parcel(values_); }
  /// The last of them that there is.
  double last() const {
    const auto none = std::find(values_.begin() + 1, values_.end(), lowest);
    return *(none - 1);
  }

 private:
  static constexpr double lowest = -std::numeric_limits<double>::infinity();
  std::array<double, counted> values_{lowest, lowest, lowest, lowest};
};

class FarSidePartial final : public Partial {
 public:
  explicit FarSidePartial(std::span<const BodyMotion> motion)
      : centre_{motion[0].position, motion[1].position},
        line_((centre_[1] - centre_[0]).stableNormalized()) {}

  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    for (std::size_t i = 0; i < x.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b != 1 && b != 2) continue;
      const double along = line_.dot(Eigen::Vector3d(x[i], y[i], z[i]) - centre_[b - 1]);
      reach_[b - 1].offer(b == 1 ? -along : along);
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const FarSidePartial&>(later);
    for (std::size_t b = 0; b < 2; ++b) reach_[b].merge(other.reach_[b]);
  }

  void pass(Parcel& parcel) override { parcel(reach_); }

  void close(std::span<double> row) const override {
    for (std::size_t b = 0; b < 2; ++b) row[b] = reach_[b].last();
  }

 private:
  std::array<Eigen::Vector3d, 2> centre_;
  Eigen::Vector3d line_;
  std::array<Greatest, 2> reach_;
};

class FarSide final : public Analysis {
 public:
  Needs needs() const override { return {{"x", "y", "z"}, /*after_motion=*/true}; }
  std::vector<ColumnSpec> columns() const override {
    return {{"far_side1", dimension::length}, {"far_side2", dimension::length}};
  }
  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<FarSidePartial>(frame.motion);
  }
};

}  // namespace

std::unique_ptr<Analysis> make_far_side() { return std::make_unique<FarSide>(); }

}  // namespace mdana
