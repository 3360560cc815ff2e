// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_text/box_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::lammps_text {
namespace {

/// The number of the fewest digits near `centre` that `fits`; `centre` itself if none does.
template <class Fits>
double shortest_near(double centre, Fits&& fits) {
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", centre, digits);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    if (fits(value)) return value;
  }
  constexpr double far = std::numeric_limits<double>::infinity();
  for (const double value : {std::nextafter(centre, -far), std::nextafter(centre, far)})
    if (fits(value)) return value;
  return centre;
}

struct Bounds {
  double lo, hi;
};

/// The bounds that box_from_bounds makes a corner and a size of, after it has taken `below` and
/// `above` off them.
Bounds bounds(double corner, double size, double below, double above) {
  const double lo = shortest_near(corner + below, [&](double b) { return b - below == corner; });
  const double hi = shortest_near(
      corner + size + above, [&](double b) { return (b - above) - (lo - below) == size; });
  return {lo, hi};
}

bool is_restricted(const Eigen::Matrix3d& edges) {
  return edges(1, 0) == 0 && edges(2, 0) == 0 && edges(2, 1) == 0 &&
         edges.diagonal().minCoeff() > 0;
}

std::string flags(const Box& box) {
  std::string text;
  for (const bool periodic : box.periodic) text += periodic ? " pp" : " ff";
  return text + "\n";
}

std::string orthogonal(const Box& box) {
  std::string text = "ITEM: BOX BOUNDS" + flags(box);
  for (int k = 0; k < 3; ++k) {
    const auto [lo, hi] = bounds(box.origin[k], box.edges(k, k), 0, 0);
    text += fmt::format("{} {}\n", lo, hi);
  }
  return text;
}

std::string tilted(const Box& box) {
  const double xy = box.edges(0, 1), xz = box.edges(0, 2), yz = box.edges(1, 2);
  const Bounds x = bounds(box.origin.x(), box.edges(0, 0), std::min({0.0, xy, xz, xy + xz}),
                          std::max({0.0, xy, xz, xy + xz}));
  const Bounds y =
      bounds(box.origin.y(), box.edges(1, 1), std::min(0.0, yz), std::max(0.0, yz));
  const Bounds z = bounds(box.origin.z(), box.edges(2, 2), 0, 0);
  return fmt::format("ITEM: BOX BOUNDS xy xz yz{}{} {} {}\n{} {} {}\n{} {} {}\n", flags(box), x.lo,
                     x.hi, xy, y.lo, y.hi, xz, z.lo, z.hi, yz);
}

std::string general(const Box& box) {
  std::string text = "ITEM: BOX BOUNDS abc origin" + flags(box);
  for (int k = 0; k < 3; ++k)
    text += fmt::format("{} {} {} {}\n", box.edges(0, k), box.edges(1, k), box.edges(2, k),
                        box.origin[k]);
  return text;
}

}  // namespace

std::string box_lines(const Box& box) {
  if (!box.edges.allFinite() || !box.origin.allFinite() || box.edges.determinant() == 0)
    throw InputError("the box is not finite or has no volume; it cannot be written");
  if (!is_restricted(box.edges)) return general(box);
  return box.edges.isDiagonal(0) ? orthogonal(box) : tilted(box);
}

}  // namespace mdana::lammps_text
