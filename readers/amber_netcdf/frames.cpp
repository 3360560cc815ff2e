// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/amber_netcdf/frames.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::amber_netcdf {
namespace {

/// Beyond it doubles do not tell whole numbers apart.
constexpr double largest_whole = 0x1p53;

double radians(double degrees) { return degrees / 180 * std::numbers::pi; }

/// Exact for the angle of orthogonal boxes.
double cosine(double degrees) { return degrees == 90 ? 0 : std::cos(radians(degrees)); }

class FrameReader {
 public:
  FrameReader(const Content& content, const NetcdfFile& file, const std::string& path,
              std::uint64_t index)
      : content_(content), file_(file) {
    frame_.index = index;
    frame_.place = fmt::format("{} (frame {})", path, index);
  }

  FrameHeader read() {
    frame_.atoms = content_.atoms;
    frame_.units = content_.units;
    for (const AtomColumn& column : content_.columns) frame_.columns.push_back(column.name);
    step_and_time();
    box();
    return std::move(frame_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", frame_.place, what));
  }

  /// Unscaled; nothing if they were never written.
  std::optional<std::vector<double>> numbers(const FrameVariable& v) const {
    std::array<std::size_t, 2> start{frame_.index, 0}, count{1, v.numbers};
    const std::size_t skip = v.in_frames ? 0 : 1, used = v.in_frames + (v.numbers > 1);
    const std::span<const std::size_t> from(start.data() + skip, used),
        to(count.data() + skip, used);
    std::vector<double> values = file_.numbers(v.id, from, to);
    std::vector<char> raw(values.size() * sizeof(double));
    file_.read(v.id, from, to, raw.data());
    for (std::size_t k = 0; k < values.size() && !v.fill.empty(); ++k)
      if (std::memcmp(raw.data() + k * v.fill.size(), v.fill.data(), v.fill.size()) == 0)
        return std::nullopt;
    return values;
  }

  double finite(double value, std::string_view what) const {
    if (!std::isfinite(value)) fail(fmt::format("{} is {}", what, value));
    return value;
  }

  std::int64_t whole(double value, std::string_view what) const {
    if (!(std::abs(value) <= largest_whole) || std::trunc(value) != value)
      fail(fmt::format("{} is {}, not a whole number in range", what, value));
    return static_cast<std::int64_t>(value);
  }

  void step_and_time() {
    const auto time = content_.time ? numbers(*content_.time) : std::nullopt;
    const auto step = content_.step ? numbers(*content_.step) : std::nullopt;
    if (time) frame_.time = finite(time->front() * content_.time->scale, "the time");
    if (step)
      frame_.step = whole(step->front(), "the step");
    else if (time && content_.time_counts_steps)
      frame_.step = whole(time->front(), "the time, which LAMMPS counts in steps,");
    else
      frame_.step = static_cast<std::int64_t>(frame_.index);
  }

  Eigen::Vector3d vector(const std::optional<FrameVariable>& v, std::string_view what) const {
    if (!v) return Eigen::Vector3d::Zero();
    const auto raw = numbers(*v);
    if (!raw) fail(fmt::format("{} was never written", what));
    Eigen::Vector3d result;
    for (int k = 0; k < 3; ++k)
      result[k] = finite((*raw)[static_cast<std::size_t>(k)] * v->scale, what);
    return result;
  }

  void box() {
    try {
      frame_.box = box_from_lengths(vector(content_.lengths, "cell_lengths"),
                                    vector(content_.angles, "cell_angles"),
                                    vector(content_.origin, "cell_origin"));
    } catch (const std::domain_error& error) {
      fail(error.what());
    }
  }

  const Content& content_;
  const NetcdfFile& file_;
  FrameHeader frame_;
};

}  // namespace

FrameHeader read_frame(const Content& content, const NetcdfFile& file, const std::string& path,
                       std::uint64_t index) {
  return FrameReader(content, file, path, index).read();
}

Box box_from_lengths(const Eigen::Vector3d& lengths, const Eigen::Vector3d& angles,
                     const Eigen::Vector3d& origin) {
  Box box;
  box.origin = origin;
  box.edges.setZero();
  if (lengths.isZero(0)) return box;
  const double cos_alpha = cosine(angles[0]), cos_beta = cosine(angles[1]),
               cos_gamma = cosine(angles[2]);
  const double sin_gamma = std::sin(radians(angles[2]));
  const double y = (cos_alpha - cos_beta * cos_gamma) / sin_gamma;
  const double rest = 1 - cos_beta * cos_beta - y * y;  // square of the height of a unit vector c
  const bool lengths_are_right = (lengths.array() >= 0).all();
  if (!lengths_are_right || (angles.array() <= 0).any() || (angles.array() >= 180).any() ||
      !(rest > 0))
    throw std::domain_error(fmt::format("cell_lengths {} {} {} and cell_angles {} {} {} are no box",
                                        lengths[0], lengths[1], lengths[2], angles[0], angles[1],
                                        angles[2]));
  box.edges.col(0) = lengths[0] * Eigen::Vector3d::UnitX();
  box.edges.col(1) = lengths[1] * Eigen::Vector3d(cos_gamma, sin_gamma, 0);
  box.edges.col(2) = lengths[2] * Eigen::Vector3d(cos_beta, y, std::sqrt(rest));
  for (int k = 0; k < 3; ++k) box.periodic[static_cast<std::size_t>(k)] = lengths[k] > 0;
  return box;
}

}  // namespace mdana::amber_netcdf
