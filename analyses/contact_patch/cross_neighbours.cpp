// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_patch/cross_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mdana {
namespace {

/// Cells of the plane, as wide as the reach.
using Cell = std::pair<double, double>;

/// Atoms of one body, sorted by cell.
class BodyCells {
 public:
  BodyCells(const std::vector<ZoneAtom>& atoms, BodyIndex body, double reach)
      : atoms_(atoms), reach_(reach) {
    for (std::size_t i = 0; i < atoms.size(); ++i)
      if (atoms[i].body == body) sorted_.emplace_back(cell(atoms[i]), i);
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Distance from an atom to the nearest of these, or one that is at most `enough`.
  double nearest(const ZoneAtom& from, double enough) const {
    double least = std::numeric_limits<double>::infinity();
    const Cell c = cell(from);
    for (const double side : {-1, 0, 1}) {
      const double row = c.first + side;
      auto at = std::lower_bound(sorted_.begin(), sorted_.end(),
                                 std::pair(Cell(row, c.second - 1), std::size_t{0}));
      for (; at != sorted_.end() && at->first <= Cell(row, c.second + 1) && least > enough; ++at)
        least = std::min(least, distance(from, atoms_[at->second]));
    }
    return least <= reach_ ? least : std::numeric_limits<double>::infinity();
  }

 private:
  Cell cell(const ZoneAtom& atom) const {
    return {std::floor(atom.position.x() / reach_), std::floor(atom.position.y() / reach_)};
  }
  static double distance(const ZoneAtom& a, const ZoneAtom& b) {
    const double up = a.height - b.height;
    return std::sqrt((a.position - b.position).squaredNorm() + up * up);
  }

  const std::vector<ZoneAtom>& atoms_;
  double reach_;
  std::vector<std::pair<Cell, std::size_t>> sorted_;
};

}  // namespace

std::vector<double> distance_to_other_body(const std::vector<ZoneAtom>& atoms, double reach,
                                           double enough) {
  const BodyCells body1(atoms, 1, reach), body2(atoms, 2, reach);
  std::vector<double> distance;
  distance.reserve(atoms.size());
  for (const ZoneAtom& atom : atoms)
    distance.push_back((atom.body == 1 ? body2 : body1).nearest(atom, enough));
  return distance;
}

}  // namespace mdana
