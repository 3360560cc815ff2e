// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/surface_energy.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "analyses/compensated.hpp"
#include "analyses/moments.hpp"
#include "analyses/parcel.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using Scalar = Eigen::Matrix<double, 1, 1>;

struct BodyEnergy {
  std::uint64_t count = 0;
  CompensatedSum<1> potential;
  Moments<3> velocity;
  void pass(Parcel& parcel) { parcel(count, potential, velocity); }
};

class EnergyPartial final : public Partial {
 public:
  EnergyPartial(const EnergyParts& parts, const std::string& place)
      : parts_(parts), place_(place) {}

  void add(const LabelledBlock& block) override {
    for (const BodyIndex b : block.body)
      if (b == 1 || b == 2) ++body_[b - 1].count;
    if (!parts_.potential.empty()) add_potential(block);
    if (parts_.thermal) add_thermal(block);
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const EnergyPartial&>(later);
    for (std::size_t b = 0; b < 2; ++b) {
      body_[b].count += other.body_[b].count;
      body_[b].potential.merge(other.body_[b].potential);
      body_[b].velocity.merge(other.body_[b].velocity);
    }
  }

  void pass(Parcel& parcel) override { parcel(body_); }

  void close(std::span<double> row) const override {
    std::size_t k = 0;
    for (const BodyEnergy& body : body_) {
      row[k++] = static_cast<double>(body.count);
      if (!parts_.potential.empty()) row[k++] = body.potential.value()[0];
      if (parts_.thermal) row[k++] = 0.5 * body.velocity.spread;
    }
    for (const double v : row)
      if (!std::isfinite(v))
        throw InputError(fmt::format("{}: an energy or a velocity of an atom in this frame is not "
                                     "finite", place_));
  }

 private:
  void add_potential(const LabelledBlock& block) {
    const auto energy = block.atoms.real(parts_.potential);
    for (std::size_t i = 0; i < energy.size(); ++i)
      if (block.body[i] == 1 || block.body[i] == 2)
        body_[block.body[i] - 1].potential.add(Scalar(energy[i]));
  }

  void add_thermal(const LabelledBlock& block) {
    const auto x = block.atoms.real("vx"), y = block.atoms.real("vy"), z = block.atoms.real("vz");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (block.body[i] == 1 || block.body[i] == 2)
        body_[block.body[i] - 1].velocity.merge({1, block.mass[i], {x[i], y[i], z[i]}, 0});
  }

  const EnergyParts& parts_;
  const std::string& place_;
  std::array<BodyEnergy, 2> body_;
};

class SurfaceEnergy final : public Analysis {
 public:
  explicit SurfaceEnergy(EnergyParts parts) : parts_(std::move(parts)) {}

  Needs needs() const override {
    Needs needs;
    if (!parts_.potential.empty()) needs.columns.add(parts_.potential);
    if (parts_.thermal) needs.columns.add({"vx", "vy", "vz"});
    return needs;
  }

  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> specs;
    for (const std::string b : {"1", "2"}) {
      specs.push_back({"count" + b, dimension::none});
      if (!parts_.potential.empty()) specs.push_back({"potential" + b, dimension::energy});
      if (parts_.thermal) specs.push_back({"thermal" + b, dimension::energy});
    }
    return specs;
  }

  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<EnergyPartial>(parts_, frame.header.place);
  }

 private:
  EnergyParts parts_;
};

}  // namespace

std::unique_ptr<Analysis> make_surface_energy(EnergyParts parts) {
  return std::make_unique<SurfaceEnergy>(std::move(parts));
}

Value surface_energy(const Value& excess, const Value& radius) {
  const double area = 4 * std::numbers::pi * radius.value * radius.value;
  const double gamma = excess.value / area;
  Value result{gamma, {}, dimension::surface_energy};
  if (excess.error && radius.error)
    result.error = std::hypot(*excess.error / area, 2 * gamma * *radius.error / radius.value);
  return result;
}

extern const AnalysisMember surface_energy_analysis;
const AnalysisMember surface_energy_analysis{
    "surface_energy", "potential and thermal energy of each body, for its surface energy",
    [](const AnalysisSetup& setup) {
      return make_surface_energy({setup.first.has_column("c_pe") ? "c_pe" : "",
                                  setup.first.has_column("vx")});
    }};

}  // namespace mdana
