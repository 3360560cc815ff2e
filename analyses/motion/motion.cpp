// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/motion.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analyses/block_means.hpp"
#include "analyses/compensated.hpp"
#include "analyses/moments.hpp"
#include "analyses/parcel.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::size_t bodies = 2;

struct BodyPartial {
  Moments<3> position;
  Moments<3> velocity;
  CompensatedSum<3> force;
  void pass(Parcel& parcel) { parcel(position, velocity, force); }
};

class MotionPartial final : public Partial {
 public:
  MotionPartial(MotionParts parts, const std::string& place) : parts_(parts), place_(place) {}

  void add(const LabelledBlock& block) override {
    weigh(block);
    const std::array<double, bodies> mass{body_[0].position.weight, body_[1].position.weight};
    const auto x = block_means({block.atoms, {"x", "y", "z"}}, block, mass);
    for (std::size_t b = 0; b < bodies; ++b) body_[b].position.mean = x[b];
    if (parts_.velocity) {
      const auto v = block_means({block.atoms, {"vx", "vy", "vz"}}, block, mass);
      for (std::size_t b = 0; b < bodies; ++b) {
        body_[b].velocity = body_[b].position;
        body_[b].velocity.mean = v[b];
      }
    }
    if (parts_.force) add_forces({block.atoms, {"fx", "fy", "fz"}}, block.body);
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const MotionPartial&>(later);
    for (std::size_t b = 0; b < bodies; ++b) {
      body_[b].position.merge(other.body_[b].position);
      body_[b].velocity.merge(other.body_[b].velocity);
      body_[b].force.merge(other.body_[b].force);
    }
    others_ += other.others_;
  }

  void pass(Parcel& parcel) override { parcel(body_, others_); }

  void close(std::span<double> row) const override {
    std::size_t k = 0;
    row[k++] = static_cast<double>(others_);
    for (std::size_t b = 0; b < bodies; ++b) {
      const BodyPartial& body = body_[b];
      if (body.position.count == 0)
        throw InputError(fmt::format("{}: body {} has no atoms in this frame", place_, b + 1));
      row[k++] = static_cast<double>(body.position.count);
      row[k++] = body.position.weight;
      for (int j = 0; j < 3; ++j) row[k++] = body.position.mean[j];
      for (int j = 0; parts_.velocity && j < 3; ++j) row[k++] = body.velocity.mean[j];
      for (int j = 0; parts_.force && j < 3; ++j) row[k++] = body.force.value()[j];
    }
    for (const double v : row)
      if (!std::isfinite(v))
        throw InputError(fmt::format("{}: a position, velocity or force of an atom in this frame "
                                     "is not finite", place_));
  }

 private:
  void weigh(const LabelledBlock& block) {
    for (std::size_t i = 0; i < block.body.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b == 0 || b > bodies) {
        ++others_;
        continue;
      }
      body_[b - 1].position.weight += block.mass[i];
      ++body_[b - 1].position.count;
    }
  }

  void add_forces(const VectorColumn& column, std::span<const BodyIndex> body) {
    for (std::size_t i = 0; i < body.size(); ++i)
      if (body[i] >= 1 && body[i] <= bodies) body_[body[i] - 1].force.add(column[i]);
  }

  MotionParts parts_;
  const std::string& place_;
  std::array<BodyPartial, bodies> body_;
  std::uint64_t others_ = 0;
};

class Motion final : public Analysis {
 public:
  explicit Motion(MotionParts parts) : parts_(parts) {}

  Needs needs() const override {
    Needs needs{{"x", "y", "z"}};
    if (parts_.velocity) needs.columns.add({"vx", "vy", "vz"});
    if (parts_.force) needs.columns.add({"fx", "fy", "fz"});
    return needs;
  }

  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> specs{{"atoms_none", dimension::none}};
    for (const char* b : {"1", "2"}) {
      const auto add_vector = [&](const std::string& prefix, Dimension d) {
        for (const char* axis : {"x", "y", "z"}) specs.push_back({prefix + axis + b, d});
      };
      specs.push_back({std::string("atoms") + b, dimension::none});
      specs.push_back({std::string("mass") + b, dimension::mass});
      add_vector("", dimension::length);
      if (parts_.velocity) add_vector("v", dimension::velocity);
      if (parts_.force) add_vector("f", dimension::force);
    }
    return specs;
  }

  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<MotionPartial>(parts_, frame.header.place);
  }

 private:
  MotionParts parts_;
};

Eigen::Vector3d vector(const Table& table, std::size_t row, const std::string& prefix,
                       const std::string& body) {
  return {table.column(prefix + "x" + body)[row], table.column(prefix + "y" + body)[row],
          table.column(prefix + "z" + body)[row]};
}

}  // namespace

std::unique_ptr<Analysis> make_motion(MotionParts parts) { return std::make_unique<Motion>(parts); }

std::array<BodyMotion, 2> body_motion(const Table& motion, std::size_t row) {
  std::array<BodyMotion, 2> result;
  for (std::size_t b = 0; b < bodies; ++b) {
    const std::string name = std::to_string(b + 1);
    result[b].atoms = motion.column("atoms" + name)[row];
    result[b].mass = motion.column("mass" + name)[row];
    result[b].position = vector(motion, row, "", name);
    if (motion.has("vx" + name)) result[b].velocity = vector(motion, row, "v", name);
    if (motion.has("fx" + name)) result[b].force = vector(motion, row, "f", name);
  }
  return result;
}

extern const AnalysisMember motion_analysis;
const AnalysisMember motion_analysis{
    "motion", "centre of mass of each body, its velocity, and the summed force on it",
    [](const AnalysisSetup& setup) {
      return make_motion({setup.first.has_column("vx"), setup.first.has_column("fx")});
    }};

}  // namespace mdana
