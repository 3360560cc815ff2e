// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::defects {
namespace {

constexpr int bits = 21;
constexpr std::uint64_t most_cells = (1u << bits) - 2;  ///< along an axis

/// Smallest and greatest coordinate.
struct Extent {
  double lo, hi;
};

Extent extent(const std::vector<double>& values) {
  const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
  return {*lo, *hi};
}

[[noreturn]] void not_finite(const FrameAtoms& atoms) {
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (!std::isfinite(atoms.x[i]) || !std::isfinite(atoms.y[i]) || !std::isfinite(atoms.z[i]))
      throw InputError(atoms.id.empty()
                           ? fmt::format("the position of atom {} (by order) is not finite", i + 1)
                           : fmt::format("the position of atom id {} is not finite", atoms.id[i]));
  throw InputError("a position is not finite");
}

/// Cells along the three axes, and what puts an atom into one.
class Cells {
 public:
  Cells(const FrameAtoms& atoms, double spacing) : inverse_(1 / spacing) {
    double sum = 0;  // not finite if a position is not
    for (std::size_t i = 0; i < atoms.size(); ++i) sum += 0 * (atoms.x[i] + atoms.y[i] + atoms.z[i]);
    if (sum != 0) not_finite(atoms);
    const Extent extents[] = {extent(atoms.x), extent(atoms.y), extent(atoms.z)};
    for (std::size_t k = 0; k < 3; ++k) {
      origin_[k] = extents[k].lo;
      const double count = (extents[k].hi - origin_[k]) * inverse_ / reach + 1;
      if (!(count < static_cast<double>(most_cells)))
        throw InputError(fmt::format("atoms lie {:.3g} neighbour distances of {:.3g} apart: some are "
                                     "lost, or on top of each other; leave them out by --select, or "
                                     "state --spacing", count * reach, spacing));
      count_[k] = static_cast<std::uint64_t>(count);
    }
  }

  double scaled(const std::vector<double>& axis, std::size_t k, std::size_t i) const {
    return (axis[i] - origin_[k]) * inverse_;
  }
  std::uint64_t cell(const std::vector<double>& axis, std::size_t k, std::size_t i) const {
    return static_cast<std::uint64_t>(scaled(axis, k, i) / reach);
  }
  std::uint64_t key(const FrameAtoms& a, std::size_t i) const {
    return (cell(a.z, 2, i) + 1) << (2 * bits) | (cell(a.y, 1, i) + 1) << bits |
           (cell(a.x, 0, i) + 1);
  }
  std::uint64_t dense(const FrameAtoms& a, std::size_t i) const {
    return (cell(a.z, 2, i) * count_[1] + cell(a.y, 1, i)) * count_[0] + cell(a.x, 0, i);
  }
  /// All cells, empty ones too; a great number if it cannot be told.
  double all() const {
    return static_cast<double>(count_[0]) * static_cast<double>(count_[1]) *
           static_cast<double>(count_[2]);
  }

 private:
  double inverse_;
  std::array<double, 3> origin_;
  std::array<std::uint64_t, 3> count_;
};

/// Order of the atoms by cell where cells can be counted one by one.
std::vector<std::uint32_t> counted(const FrameAtoms& atoms, const Cells& cells) {
  std::vector<std::uint32_t> of_atom(atoms.size());
  std::vector<std::uint32_t> next(static_cast<std::size_t>(cells.all()) + 1);
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    of_atom[i] = static_cast<std::uint32_t>(cells.dense(atoms, i));
    ++next[of_atom[i] + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> order(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
    order[next[of_atom[i]]++] = static_cast<std::uint32_t>(i);
  return order;
}

/// The same where atoms are few among the cells.
std::vector<std::uint32_t> compared(const FrameAtoms& atoms, const Cells& cells) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
    keyed[i] = {cells.key(atoms, i), static_cast<std::uint32_t>(i)};
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order;
  order.reserve(keyed.size());
  for (const auto& [key, atom] : keyed) order.push_back(atom);
  return order;
}

std::int32_t whole(double scaled) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(
      static_cast<std::uint64_t>(scaled * units_a_spacing + 0.5)));
}

}  // namespace

CellGrid::CellGrid(const FrameAtoms& atoms, double of_spacing) : spacing(of_spacing) {
  const Cells cells(atoms, spacing);
  const std::size_t n = atoms.size();
  const bool dense = cells.all() <= 2 * static_cast<double>(n) + 4096;
  atom = dense ? counted(atoms, cells) : compared(atoms, cells);
  for (auto* axis : {&x, &y, &z}) axis->resize(n + padding);
  for (std::size_t s = 0; s < n; ++s) {
    const std::uint32_t i = atom[s];
    x[s] = whole(cells.scaled(atoms.x, 0, i));
    y[s] = whole(cells.scaled(atoms.y, 1, i));
    z[s] = whole(cells.scaled(atoms.z, 2, i));
    const std::uint64_t k = cells.key(atoms, i);
    if (!key.empty() && key.back() == k) continue;
    key.push_back(k);
    start.push_back(static_cast<std::uint32_t>(s));
  }
  start.push_back(static_cast<std::uint32_t>(n));
}

std::size_t CellGrid::cell_of(std::size_t sorted) const {
  return static_cast<std::size_t>(std::upper_bound(start.begin(), start.end(), sorted) -
                                  start.begin()) - 1;
}

std::size_t CellGrid::at_or_after(std::uint64_t wanted) const {
  return static_cast<std::size_t>(std::lower_bound(key.begin(), key.end(), wanted) - key.begin());
}

std::array<std::int32_t, 3> middle_of(std::uint64_t key) {
  const auto along = [key](int k) {
    const std::uint64_t cell = (key >> (k * bits) & ((1u << bits) - 1)) - 1;
    return whole((static_cast<double>(cell) + 0.5) * reach);
  };
  return {along(0), along(1), along(2)};
}

}  // namespace mdana::defects
