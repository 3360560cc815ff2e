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

struct Interval {
  double lo, hi;
};

/// The bounds that box_from_bounds makes a corner and a size of, after it has taken `below` and
/// `above` off them.
Interval interval(double corner, double size, double below, double above) {
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

/// The bounds that the dump stated are only of use if the box is still the one that they make.
bool still_stated(const Box& box) {
  if (!box.stated) return false;
  const Box again = box_from_bounds(box.stated->lo, box.stated->hi, box.edges(0, 1),
                                    box.edges(0, 2), box.edges(1, 2));
  return again.origin == box.origin && again.edges == box.edges;
}

Box::Bounds bounds(const Box& box) {
  if (still_stated(box)) return *box.stated;
  const double xy = box.edges(0, 1), xz = box.edges(0, 2), yz = box.edges(1, 2);
  const Interval x = interval(box.origin.x(), box.edges(0, 0), std::min({0.0, xy, xz, xy + xz}),
                              std::max({0.0, xy, xz, xy + xz}));
  const Interval y =
      interval(box.origin.y(), box.edges(1, 1), std::min(0.0, yz), std::max(0.0, yz));
  const Interval z = interval(box.origin.z(), box.edges(2, 2), 0, 0);
  return {{x.lo, y.lo, z.lo}, {x.hi, y.hi, z.hi}};
}

std::string orthogonal(const Box& box) {
  const auto [lo, hi] = bounds(box);
  std::string text = "ITEM: BOX BOUNDS" + flags(box);
  for (int k = 0; k < 3; ++k) text += fmt::format("{} {}\n", lo[k], hi[k]);
  return text;
}

std::string tilted(const Box& box) {
  const auto [lo, hi] = bounds(box);
  const double tilts[] = {box.edges(0, 1), box.edges(0, 2), box.edges(1, 2)};
  std::string text = "ITEM: BOX BOUNDS xy xz yz" + flags(box);
  for (int k = 0; k < 3; ++k) text += fmt::format("{} {} {}\n", lo[k], hi[k], tilts[k]);
  return text;
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
