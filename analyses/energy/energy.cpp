// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/energy.hpp"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "analyses/block_means.hpp"
#include "analyses/compensated.hpp"
#include "analyses/energy/mean_vector.hpp"
#include "analyses/parcel.hpp"
#include "analyses/rigid_rotation.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::size_t bodies = 2;

/// Sums over the atoms of one body about its own means: merged as Moments are (Chan, Golub &
/// LeVeque 1983), with the rounding of the means kept, so that a drift of 1e7 thermal speeds costs no
/// digit of what is thermal.
struct BodySums {
  std::uint64_t count = 0;
  double mass = 0;
  MeanVector x;                                      ///< position [length]
  MeanVector v;                                      ///< velocity [velocity]
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< sum of m dx dx^T
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();    ///< angular momentum, sum of m dx cross dv
  double heat = 0;                                   ///< sum of m |dv|^2
  CompensatedSum<1> potential;

  void pass(Parcel& parcel) { parcel(count, mass, x, v, spread, spin, heat, potential); }

  void add(double m, const Eigen::Vector3d& dx, const Eigen::Vector3d& dv) {
    const Eigen::Vector3d weighted = m * dx;
    spread += weighted * dx.transpose();
    spin += weighted.cross(dv);
    heat += m * dv.squaredNorm();
  }

  /// `dx` and `dv` are from `high` of the means.
  void add_atom(double m, const Eigen::Vector3d& dx, const Eigen::Vector3d& dv) {
    add(m, dx, dv);
    x.low += m / mass * dx;
    v.low += m / mass * dv;
  }

  void merge(const BodySums& other) {
    potential.merge(other.potential);
    if (other.count == 0) return;
    const double total = mass + other.mass, share = other.mass / total;
    spread += other.spread;
    spin += other.spin;
    heat += other.heat;
    const Eigen::Vector3d dx = other.x.minus(x), dv = other.v.minus(v);
    add(mass * share, dx, dv);  // nothing if this one is empty
    if (count == 0) {
      x = other.x;
      v = other.v;
    } else {
      x.move(share * dx);
      v.move(share * dv);
    }
    mass = total;
    count += other.count;
  }
};

class EnergyPartial final : public Partial {
 public:
  EnergyPartial(const std::string& potential, const std::string& place)
      : potential_(potential), place_(place) {}

  void add(const LabelledBlock& block) override {
    weigh(block);
    const VectorColumn x{block.atoms, {"x", "y", "z"}}, v{block.atoms, {"vx", "vy", "vz"}};
    const std::array<double, bodies> mass{body_[0].mass, body_[1].mass};
    const auto mean_x = block_means(x, block, mass), mean_v = block_means(v, block, mass);
    for (std::size_t b = 0; b < bodies; ++b) {
      body_[b].x.high = mean_x[b];
      body_[b].v.high = mean_v[b];
    }
    for (std::size_t i = 0; i < block.body.size(); ++i)
      if (BodySums* body = body_of(block, i))
        body->add_atom(block.mass[i], x[i] - body->x.high, v[i] - body->v.high);
    if (!potential_.empty()) add_potential(block);
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const EnergyPartial&>(later);
    for (std::size_t b = 0; b < bodies; ++b) body_[b].merge(other.body_[b]);
  }

  void pass(Parcel& parcel) override { parcel(body_); }

  void close(std::span<double> row) const override {
    std::size_t k = 0;
    for (const BodySums& body : body_) {
      const RigidRotation turning = rigid_rotation(body.spread, body.spin);
      row[k++] = 0.5 * body.heat;
      row[k++] = turning.energy;
      row[k++] = std::max(0.0, 3.0 * static_cast<double>(body.count) - 3.0 - turning.axes);
      if (!potential_.empty()) row[k++] = body.potential.value()[0];
    }
    for (const double value : row)
      if (!std::isfinite(value))
        throw InputError(fmt::format("{}: a position, velocity or potential energy of an atom in "
                                     "this frame is not finite", place_));
  }

 private:
  BodySums* body_of(const LabelledBlock& block, std::size_t atom) {
    const BodyIndex b = block.body[atom];
    return b >= 1 && b <= bodies ? &body_[b - 1] : nullptr;
  }

  void weigh(const LabelledBlock& block) {
    for (std::size_t i = 0; i < block.body.size(); ++i)
      if (BodySums* body = body_of(block, i)) {
        body->mass += block.mass[i];
        ++body->count;
      }
  }

  void add_potential(const LabelledBlock& block) {
    const auto w = block.atoms.real(potential_);
    for (std::size_t i = 0; i < w.size(); ++i)
      if (BodySums* body = body_of(block, i))
        body->potential.add(CompensatedSum<1>::Vector(w[i]));
  }

  const std::string& potential_;
  const std::string& place_;
  std::array<BodySums, bodies> body_;
};

class Energy final : public Analysis {
 public:
  explicit Energy(std::string potential) : potential_(std::move(potential)) {}

  Needs needs() const override {
    Needs needs{{"x", "y", "z", "vx", "vy", "vz"}};
    if (!potential_.empty()) needs.columns.add(potential_);
    return needs;
  }

  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> specs;
    for (const std::string b : {"1", "2"}) {
      specs.push_back({"K_t" + b, dimension::energy});
      specs.push_back({"rotation" + b, dimension::energy});
      specs.push_back({"degrees_of_freedom" + b, dimension::none});
      if (!potential_.empty()) specs.push_back({"W" + b, dimension::energy});
    }
    return specs;
  }

  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<EnergyPartial>(potential_, frame.header.place);
  }

 private:
  std::string potential_;
};

}  // namespace

std::unique_ptr<Analysis> make_energy(std::string potential) {
  return std::make_unique<Energy>(std::move(potential));
}

std::vector<std::string> potential_columns(const FrameHeader& frame) {
  std::vector<std::string> found;
  for (const char* name : {"c_pe", "c_peatom", "pe"})
    if (frame.has_column(name)) found.emplace_back(name);
  return found;
}

extern const AnalysisMember energy_analysis;
const AnalysisMember energy_analysis{
    "energy", "thermal, rotational and potential energy of each body",
    [](const AnalysisSetup& setup) {
      const auto columns = potential_columns(setup.first);
      return make_energy(columns.size() == 1 ? columns.front() : "");
    }};

}  // namespace mdana
