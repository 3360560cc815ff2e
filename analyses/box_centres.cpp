// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/box_centres.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <fmt/format.h>

#include "analyses/parcel.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::size_t columns_of_body = 10;
constexpr double uncertain_distance = 0.4;  // of an edge; at 0.5 both images are as near

// Of an edge: bodies farther apart are neighbours through the face. Two whole spheres in a box reach it
// only if the gap between them is wider than they are together.
constexpr double across = 2.0 / 3;

/// Sums over atoms of the cos and sin of their phases along the three edges, and of their scaled
/// coordinates.
struct PhaseSums {
  Eigen::Vector3d cosines = Eigen::Vector3d::Zero(), sines = Eigen::Vector3d::Zero();
  Eigen::Vector3d scaled = Eigen::Vector3d::Zero();
  double atoms = 0;
  void pass(Parcel& parcel) { parcel(cosines, sines, scaled, atoms); }
};

class CentresPartial final : public Partial {
 public:
  CentresPartial(const Box& box, std::size_t bodies)
      : origin_(box.origin), scaling_(box.edges.inverse()), sums_(bodies) {}

  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (block.body[i] == 0) continue;
      const Eigen::Vector3d scaled = scaling_ * (Eigen::Vector3d(x[i], y[i], z[i]) - origin_);
      const Eigen::Array3d phase = 2 * std::numbers::pi * scaled.array();
      PhaseSums& sums = sums_[block.body[i] - 1u];
      sums.cosines.array() += phase.cos();
      sums.sines.array() += phase.sin();
      sums.scaled += scaled;
      sums.atoms += 1;
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const CentresPartial&>(later);
    for (std::size_t b = 0; b < sums_.size(); ++b) {
      sums_[b].cosines += other.sums_[b].cosines;
      sums_[b].sines += other.sums_[b].sines;
      sums_[b].scaled += other.sums_[b].scaled;
      sums_[b].atoms += other.sums_[b].atoms;
    }
  }

  void pass(Parcel& parcel) override { parcel(sums_); }

  void close(std::span<double> row) const override {
    auto to = row.begin();
    for (const PhaseSums& sums : sums_) {
      to = std::ranges::copy(sums.cosines, to).out;
      to = std::ranges::copy(sums.sines, to).out;
      to = std::ranges::copy(sums.scaled, to).out;
      *to++ = sums.atoms;
    }
  }

 private:
  Eigen::Vector3d origin_;
  Eigen::Matrix3d scaling_;
  std::vector<PhaseSums> sums_;
};

class BoxCentres final : public Analysis {
 public:
  explicit BoxCentres(std::size_t bodies) : bodies_(bodies) {}

  Needs needs() const override { return {{"x", "y", "z"}}; }

  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> columns;
    for (std::size_t b = 1; b <= bodies_; ++b)
      for (const char* name : {"cos_a", "cos_b", "cos_c", "sin_a", "sin_b", "sin_c", "sum_a",
                               "sum_b", "sum_c", "atoms"})
        columns.push_back({fmt::format("{}{}", name, b), dimension::none});
    return columns;
  }

  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<CentresPartial>(frame.header.box, bodies_);
  }

 private:
  std::size_t bodies_;
};

/// A body in one frame, by its columns.
struct Found {
  Eigen::Vector3d centre;  ///< scaled, in [-1/2, 1/2]
  Eigen::Vector3d mean;    ///< of the scaled coordinates as they stand

  explicit Found(std::span<const double> body) {
    for (std::size_t k = 0; k < 3; ++k) {
      centre[static_cast<int>(k)] = std::atan2(body[3 + k], body[k]) / (2 * std::numbers::pi);
      mean[static_cast<int>(k)] = body[6 + k] / body[9];
    }
  }
};

}  // namespace

std::unique_ptr<Analysis> make_box_centres(std::size_t bodies) {
  return std::make_unique<BoxCentres>(bodies);
}

void Unwrapping::begin(const Box& box, std::span<const double> row) {
  box_ = box;
  scaling_ = box.edges.inverse();
  const bool first = centres_.empty();
  const std::size_t bodies = row.size() / columns_of_body;
  for (std::size_t b = 0; b < bodies; ++b) {
    const Found found(row.subspan(b * columns_of_body, columns_of_body));
    if (first)
      centres_.push_back(beside_first(nearest_image(found.centre, found.mean)));
    else
      centres_[b] = nearest_image(found.centre, centres_[b]);
  }
}

Eigen::Vector3d Unwrapping::beside_first(Eigen::Vector3d scaled) const {
  if (centres_.empty()) return scaled;
  const Eigen::Vector3d near = nearest_image(scaled, centres_[0]);
  for (int k = 0; k < 3; ++k)
    if (std::abs(scaled[k] - centres_[0][k]) > across) scaled[k] = near[k];
  return scaled;
}

Eigen::Vector3d Unwrapping::nearest_image(Eigen::Vector3d scaled, const Eigen::Vector3d& to) const {
  for (int k = 0; k < 3; ++k)
    if (box_.periodic[static_cast<std::size_t>(k)]) scaled[k] += std::round(to[k] - scaled[k]);
  return scaled;
}

std::size_t Unwrapping::apply(AtomBlock& block, std::span<const BodyIndex> body) const {
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  std::size_t uncertain = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (body[i] == 0) continue;
    const Eigen::Vector3d& to = centres_[body[i] - 1u];
    const Eigen::Vector3d scaled =
        scaling_ * (Eigen::Vector3d(x[i], y[i], z[i]) - box_.origin);
    const Eigen::Vector3d nearest = nearest_image(scaled, to);
    bool far = false;
    for (int k = 0; k < 3; ++k)
      far = far || (box_.periodic[static_cast<std::size_t>(k)] &&
                    std::abs(nearest[k] - to[k]) > uncertain_distance);
    uncertain += far;
    const Eigen::Vector3d images = (nearest - scaled).array().round();
    if (images.isZero(0)) continue;
    const Eigen::Vector3d move = box_.edges * images;
    x[i] += move.x();
    y[i] += move.y();
    z[i] += move.z();
  }
  return uncertain;
}

}  // namespace mdana
