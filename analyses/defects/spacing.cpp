// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/spacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "analyses/defects/cell_grid.hpp"
#include "analyses/ranges.hpp"
#include "readers/input_error.hpp"

namespace mdana::defects {
namespace {

constexpr std::size_t places = 7;   ///< odd
constexpr std::size_t about = 80;   ///< atoms about each; a ball of two to three shells

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d position(const FrameAtoms& atoms, std::size_t i) {
  return {atoms.x[i], atoms.y[i], atoms.z[i]};
}

/// Squared distances and numbers of the atoms of a heap, farthest first.
class NearestAtoms {
 public:
  NearestAtoms(const FrameAtoms& atoms, std::size_t centre)
      : atoms_(atoms), x_(atoms.x[centre]), y_(atoms.y[centre]), z_(atoms.z[centre]) {}

  /// Looks at every `stride`-th atom and keeps `most`.
  void look(std::size_t stride, std::size_t most) {
    for (std::size_t i = 0; i < atoms_.size(); i += stride) {
      const double dx = atoms_.x[i] - x_;
      if (dx * dx > limit_) continue;
      const double dy = atoms_.y[i] - y_, dz = atoms_.z[i] - z_;
      const double d2 = dx * dx + dy * dy + dz * dz;
      if (d2 <= limit_) keep(d2, i, most);
    }
  }
  /// Forgets the atoms, but not how far the farthest was.
  void clear() { heap_.clear(); }

  Points sorted() {
    std::sort(heap_.begin(), heap_.end());
    Points points;
    for (const auto& [d2, i] : heap_) points.push_back(position(atoms_, i));
    return points;
  }

 private:
  void keep(double d2, std::size_t i, std::size_t most) {
    heap_.emplace_back(d2, i);
    std::push_heap(heap_.begin(), heap_.end());
    if (heap_.size() < most) return;
    if (heap_.size() > most) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    limit_ = heap_.front().first;
  }

  const FrameAtoms& atoms_;
  double x_, y_, z_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, std::size_t>> heap_;
};

/// The atoms nearest to one, itself included. As many of every 16th one tell first how far to look.
Points atoms_about(const FrameAtoms& atoms, std::size_t centre) {
  NearestAtoms nearest(atoms, centre);
  if (atoms.size() > 64 * about) nearest.look(16, about / 4);
  nearest.clear();
  nearest.look(1, about);
  return nearest.sorted();
}

/// Median distance to the nearest point at another place; 0 if there is none.
double median_nearest(const Points& points) {
  std::vector<double> nearest;
  for (const auto& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& q : points)
      if (const double d = (q - p).norm(); d > 0) least = std::min(least, d);
    if (std::isfinite(least)) nearest.push_back(least);
  }
  if (nearest.empty()) return 0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

double spacing_about(const FrameAtoms& atoms, std::size_t centre) {
  const Points points = atoms_about(atoms, centre);
  const double least = median_nearest(points);
  std::vector<double> pairs;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double d = (points[i] - points[j]).norm(); d > 0 && d < 2 * least)
        pairs.push_back(d);
  std::sort(pairs.begin(), pairs.end());
  double spacing = least;
  for (int step = 0; step < 30; ++step) {
    double sum = 0, count = 0;
    for (const double d : pairs) {
      if (d >= between_shells * spacing) break;
      sum += d;
      ++count;
    }
    const double next = count > 0 ? std::max(least, sum / count) : least;
    if (next == spacing) break;
    spacing = next;
  }
  return spacing;
}

}  // namespace

double nearest_neighbour_spacing(const FrameAtoms& atoms, std::size_t threads) {
  std::array<double, places> found{};
  for_ranges(places, 1, threads, [&](std::size_t k, std::size_t) {
    found[k] = spacing_about(atoms, (2 * k + 1) * atoms.size() / (2 * places));
  });
  std::vector<double> known;
  std::copy_if(found.begin(), found.end(), std::back_inserter(known), [](double d) { return d > 0; });
  if (known.empty())
    throw InputError("fewer than two atoms at different places, or most on top of each other: no "
                     "distance of neighbours can be found");
  std::sort(known.begin(), known.end());
  return known[known.size() / 2];
}

}  // namespace mdana::defects
