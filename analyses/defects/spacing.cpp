// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/spacing.hpp"

#include <algorithm>
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

/// The atoms nearest to a place, of those that are shown.
class NearestAtoms {
 public:
  explicit NearestAtoms(const Eigen::Vector3d& place) : x_(place.x()), y_(place.y()), z_(place.z()) {}

  /// Looks at those whose index is a multiple of the stride, and keeps `most`.
  void look(const FrameAtoms& atoms, std::size_t first, std::size_t stride, std::size_t most) {
    for (std::size_t i = (stride - first % stride) % stride; i < atoms.size(); i += stride) {
      const double dx = atoms.x[i] - x_;
      if (dx * dx > limit_) continue;
      const double dy = atoms.y[i] - y_, dz = atoms.z[i] - z_;
      const double d2 = dx * dx + dy * dy + dz * dz;
      if (d2 <= limit_) keep({d2, first + i, position(atoms, i)}, most);
    }
  }
  /// Forgets the atoms, but not how far the farthest was.
  void clear() { heap_.clear(); }

  Points sorted() {
    std::sort(heap_.begin(), heap_.end());
    Points points;
    for (const Near& near : heap_) points.push_back(near.at);
    return points;
  }

 private:
  struct Near {
    double d2;
    std::size_t index;
    Eigen::Vector3d at;
    bool operator<(const Near& other) const { return d2 < other.d2 || (d2 == other.d2 && index < other.index); }
  };

  void keep(const Near& near, std::size_t most) {
    heap_.push_back(near);
    std::push_heap(heap_.begin(), heap_.end());
    if (heap_.size() < most) return;
    if (heap_.size() > most) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    limit_ = heap_.front().d2;
  }

  double x_, y_, z_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<Near> heap_;
};

/// Positions of the atoms that are looked about.
Points centres(const FrameStore& frame) {
  Points points;
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t first) {
    while (points.size() < places) {
      const std::size_t index = (2 * points.size() + 1) * frame.size() / (2 * places);
      if (index >= first + atoms.size()) return;
      points.push_back(position(atoms, index - first));
    }
  });
  return points;
}

/// The atoms nearest to each, itself included. As many of every 16th one tell first how far to look.
std::vector<NearestAtoms> atoms_about(const FrameStore& frame, std::size_t threads) {
  std::vector<NearestAtoms> nearest;
  for (const Eigen::Vector3d& centre : centres(frame)) nearest.emplace_back(centre);
  const auto look = [&](std::size_t stride, std::size_t most) {
    frame.for_blocks([&](const FrameAtoms& atoms, std::size_t first) {
      for_ranges(places, 1, threads, [&](std::size_t k, std::size_t) { nearest[k].look(atoms, first, stride, most); });
    });
  };
  if (frame.size() > 64 * about) look(16, about / 4);
  for (NearestAtoms& atoms : nearest) atoms.clear();
  look(1, about);
  return nearest;
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

double spacing_of(const Points& points) {
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

double nearest_neighbour_spacing(const FrameStore& frame, std::size_t threads) {
  std::vector<double> known;
  for (NearestAtoms& nearest : atoms_about(frame, threads))
    if (const double d = spacing_of(nearest.sorted()); d > 0) known.push_back(d);
  if (known.empty())
    throw InputError("fewer than two atoms at different places, or most on top of each other: no "
                     "distance of neighbours can be found");
  std::sort(known.begin(), known.end());
  return known[known.size() / 2];
}

}  // namespace mdana::defects
