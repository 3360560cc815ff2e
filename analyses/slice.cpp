// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/slice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "analyses/parcel.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using Eigen::Vector3d;

constexpr std::size_t samples = 64;  ///< atoms whose nearest neighbour is looked for
constexpr double near_z = 0.9;       ///< cosine of line of centres and z axis

Vector3d position(const FrameAtoms& atoms, std::size_t i) { return {atoms.x[i], atoms.y[i], atoms.z[i]}; }

/// Mean positions of bodies 1 and 2. Throws InputError.
std::array<Vector3d, 2> centres_of(const FrameStore& frame) {
  std::array<Vector3d, 2> sum{Vector3d::Zero(), Vector3d::Zero()};
  std::array<double, 2> count{};
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t) {
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      sum[atoms.body[i] - 1u] += position(atoms, i);
      ++count[atoms.body[i] - 1u];
    }
  });
  if (count[0] == 0 || count[1] == 0) throw InputError("a body has no atoms");
  return {sum[0] / count[0], sum[1] / count[1]};
}

std::vector<Vector3d> sampled(const FrameStore& frame) {
  const std::size_t stride = std::max<std::size_t>(1, frame.size() / samples);
  std::vector<Vector3d> points;
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t first) {
    for (std::size_t i = (stride - first % stride) % stride; i < atoms.size(); i += stride)
      points.push_back(position(atoms, i));
  });
  return points;
}

/// Median distance to the nearest atom at another place; 0 if there is none.
double nearest_neighbour(const FrameStore& frame) {
  const std::vector<Vector3d> points = sampled(frame);
  std::vector<double> least(points.size(), std::numeric_limits<double>::infinity());
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t) {
    for (std::size_t i = 0; i < atoms.size(); ++i)
      for (std::size_t k = 0; k < points.size(); ++k)
        if (const double d2 = (position(atoms, i) - points[k]).squaredNorm(); d2 > 0 && d2 < least[k]) least[k] = d2;
  });
  std::ranges::sort(least);
  const double median = least[least.size() / 2];
  return std::isfinite(median) ? std::sqrt(median) : 0;
}

Slice slice_of(const FrameStore& frame, std::optional<double> diameter) {
  const auto [one, two] = centres_of(frame);
  const Vector3d along = (two - one).stableNormalized(), middle = 0.5 * (one + two);
  if (!(along.squaredNorm() > 0.5)) throw InputError("the bodies' centres coincide");
  const Vector3d axis = std::abs(along.z()) < near_z ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d normal = (axis - axis.dot(along) * along).normalized(), across = along.cross(normal);
  Slice slice{diameter ? *diameter : nearest_neighbour(frame), {}};
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t) {
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const Vector3d from = position(atoms, i) - middle;
      const double height = from.dot(normal);
      if (-slice.diameter < 2 * height && 2 * height <= slice.diameter)
        slice.at[atoms.body[i] - 1u].emplace_back(from.dot(across), from.dot(along), height);
    }
  });
  return slice;
}

class SliceProduct final : public Product {
 public:
  SliceProduct(const std::function<void(Slice)>& use, Slice slice) : use_(use), slice_(std::move(slice)) {}
  void give() override { use_(std::move(slice_)); }
  void send(const std::function<void(const std::string&)>& to) override {
    Parcel parcel;
    parcel(slice_.diameter, slice_.at);
    to(parcel.take());
  }

 private:
  const std::function<void(Slice)>& use_;
  Slice slice_;
};

class SliceAnalysis final : public FrameAnalysis {
 public:
  SliceAnalysis(std::optional<double> diameter, std::function<void(Slice)> product)
      : diameter_(diameter), product_(std::move(product)) {}

  Needs needs() const override { return {{"x", "y", "z"}, false, /*whole_frame=*/true}; }
  std::vector<ColumnSpec> columns() const override { return {{"slice_atoms", dimension::none}}; }
  std::size_t bytes_an_atom() const override { return 48; }  // FrameAtoms and a slice of most of them

  std::unique_ptr<Product> look(const FrameHeader&, const FrameStore& atoms, std::size_t,
                                std::span<double> row) const override {
    Slice slice = slice_of(atoms, diameter_);
    row[0] = static_cast<double>(slice.size());
    return std::make_unique<SliceProduct>(product_, std::move(slice));
  }

  void give_sent(const std::function<std::string()>& from) const override {
    Parcel parcel(from());
    Slice slice;
    parcel(slice.diameter, slice.at);
    product_(std::move(slice));
  }

 private:
  std::optional<double> diameter_;
  std::function<void(Slice)> product_;
};

}  // namespace

std::unique_ptr<Analysis> make_slice(std::optional<double> diameter, std::function<void(Slice)> product) {
  return std::make_unique<SliceAnalysis>(diameter, std::move(product));
}

}  // namespace mdana
