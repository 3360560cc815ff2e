// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/gyration.hpp"

#include <cmath>

#include "analyses/moments.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

class GyrationPartial final : public Partial {
 public:
  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (block.body[i] == 1 || block.body[i] == 2)
        body_[block.body[i] - 1].merge({1, block.mass[i], {x[i], y[i], z[i]}, 0});
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const GyrationPartial&>(later);
    for (std::size_t b = 0; b < 2; ++b) body_[b].merge(other.body_[b]);
  }

  void pass(Parcel& parcel) override { parcel(body_); }

  void close(std::span<double> row) const override {
    for (std::size_t b = 0; b < 2; ++b)
      row[b] = std::sqrt(5.0 / 3.0 * (body_[b].spread / body_[b].weight));
  }

 private:
  std::array<Moments<3>, 2> body_;
};

class Gyration final : public Analysis {
 public:
  Needs needs() const override { return {{"x", "y", "z"}}; }
  std::vector<ColumnSpec> columns() const override {
    return {{"radius1", dimension::length}, {"radius2", dimension::length}};
  }
  std::unique_ptr<Partial> begin(const FrameContext&) const override {
    return std::make_unique<GyrationPartial>();
  }
};

}  // namespace

std::unique_ptr<Analysis> make_gyration() { return std::make_unique<Gyration>(); }

extern const AnalysisMember gyration_analysis;
const AnalysisMember gyration_analysis{
    "gyration", "radius of each body in the first frame from its radius of gyration",
    [](const AnalysisSetup&) { return make_gyration(); }};

}  // namespace mdana
