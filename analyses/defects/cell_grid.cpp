// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/cell_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analyses/ranges.hpp"
#include "readers/input_error.hpp"

namespace mdana::defects {
namespace {

constexpr std::size_t atoms_at_once = 65536;
constexpr int bits = 21;
constexpr std::uint64_t most_cells = (1u << bits) - 2;  ///< along an axis

[[noreturn]] void not_finite(const FrameAtoms& atoms, std::size_t first) {
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (!std::isfinite(atoms.x[i]) || !std::isfinite(atoms.y[i]) || !std::isfinite(atoms.z[i]))
      throw InputError(atoms.id.empty()
                           ? fmt::format("the position of atom {} (by order) is not finite", first + i + 1)
                           : fmt::format("the position of atom id {} is not finite", atoms.id[i]));
  throw InputError("a position is not finite");
}

/// Whole position modulo 2^32.
std::int32_t whole(double scaled) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(
      static_cast<std::uint64_t>(scaled * units_a_spacing + 0.5)));
}

std::uint64_t key_of(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return (z + 1) << (2 * bits) | (y + 1) << bits | (x + 1);
}

/// The part of the cells that some atoms are in, empty ones included.
class Cells {
 public:
  Cells(const FrameAtoms& atoms, const CellSpace& space) : space_(space) {
    const std::vector<double>* along[] = {&atoms.x, &atoms.y, &atoms.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [lo, hi] = std::minmax_element(along[k]->begin(), along[k]->end());
      first_[k] = space.cell(*lo, k);
      count_[k] = space.cell(*hi, k) + 1 - first_[k];
    }
  }

  std::uint64_t key(const FrameAtoms& a, std::size_t i) const {
    return key_of(space_.cell(a.x[i], 0), space_.cell(a.y[i], 1), space_.cell(a.z[i], 2));
  }
  std::uint64_t number(const FrameAtoms& a, std::size_t i) const {
    const std::uint64_t x = space_.cell(a.x[i], 0) - first_[0], y = space_.cell(a.y[i], 1) - first_[1],
                        z = space_.cell(a.z[i], 2) - first_[2];
    return (z * count_[1] + y) * count_[0] + x;
  }
  std::uint64_t key_of_number(std::uint64_t number) const {
    const std::uint64_t rows = number / count_[0];
    return key_of(first_[0] + number % count_[0], first_[1] + rows % count_[1], first_[2] + rows / count_[1]);
  }
  /// A great number if it cannot be told.
  double all() const {
    return static_cast<double>(count_[0]) * static_cast<double>(count_[1]) *
           static_cast<double>(count_[2]);
  }

 private:
  const CellSpace& space_;
  std::array<std::uint64_t, 3> first_, count_;
};

/// Atoms by cell where cells can be counted one by one.
void sort_by_counting(const FrameAtoms& atoms, const Cells& cells, std::size_t threads, CellGrid& grid) {
  std::vector<std::uint32_t> of_atom(atoms.size());
  for_ranges(atoms.size(), atoms_at_once, threads, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) of_atom[i] = static_cast<std::uint32_t>(cells.number(atoms, i));
  });
  std::vector<std::uint32_t> next(static_cast<std::size_t>(cells.all()) + 1);
  for (const std::uint32_t cell : of_atom) ++next[cell + 1];
  for (std::size_t number = 0; number + 1 < next.size(); ++number) {
    const std::uint32_t first = next[number];
    next[number + 1] += first;
    if (next[number + 1] == first) continue;
    grid.key.push_back(cells.key_of_number(number));
    grid.start.push_back(first);
  }
  grid.atom.resize(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
    grid.atom[next[of_atom[i]]++] = static_cast<std::uint32_t>(i);
}

/// The same where atoms are few among the cells.
void sort_by_comparing(const FrameAtoms& atoms, const Cells& cells, CellGrid& grid) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
    keyed[i] = {cells.key(atoms, i), static_cast<std::uint32_t>(i)};
  std::sort(keyed.begin(), keyed.end());
  for (const auto& [key, atom] : keyed) {
    if (grid.key.empty() || grid.key.back() != key) {
      grid.key.push_back(key);
      grid.start.push_back(static_cast<std::uint32_t>(grid.atom.size()));
    }
    grid.atom.push_back(atom);
  }
}

}  // namespace

CellSpace::CellSpace(const Eigen::AlignedBox3d& box, double of_spacing)
    : spacing(of_spacing), origin(box.min()), scale_(1 / spacing), cells_(1 / (reach * spacing)) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double cells = (box.max()[axis] - origin[axis]) * cells_ + 1;
    if (!(cells < static_cast<double>(most_cells)))
      throw InputError(fmt::format("atoms lie {:.3g} neighbour distances of {:.3g} apart: some are "
                                   "lost, or on top of each other; leave them out by --select, or "
                                   "state --spacing", cells * reach, spacing));
    count[k] = static_cast<std::uint64_t>(cells);
  }
}

std::uint64_t CellSpace::cell(double at, std::size_t axis) const {
  return static_cast<std::uint64_t>((at - origin[static_cast<Eigen::Index>(axis)]) * cells_);
}

std::int32_t CellSpace::position(double at, std::size_t axis) const {
  return whole((at - origin[static_cast<Eigen::Index>(axis)]) * scale_);
}

CellGrid::CellGrid(const FrameAtoms& atoms, double of_spacing)
    : CellGrid(atoms, CellSpace(box_of(atoms), of_spacing)) {}

CellGrid::CellGrid(const FrameAtoms& atoms, const CellSpace& space, std::size_t threads) : spacing(space.spacing) {
  const Cells cells(atoms, space);
  const std::size_t n = atoms.size();
  const bool countable = cells.all() <= 2 * static_cast<double>(n) + 4096;
  countable ? sort_by_counting(atoms, cells, threads, *this) : sort_by_comparing(atoms, cells, *this);
  start.push_back(static_cast<std::uint32_t>(n));
  for (auto* axis : {&x, &y, &z}) axis->resize(n + padding);
  for_ranges(n, atoms_at_once, threads, [&](std::size_t first, std::size_t end) {
    for (std::size_t s = first; s < end; ++s) {
      const std::uint32_t i = atom[s];
      x[s] = space.position(atoms.x[i], 0);
      y[s] = space.position(atoms.y[i], 1);
      z[s] = space.position(atoms.z[i], 2);
    }
  });
}

std::size_t CellGrid::cell_of(std::size_t sorted) const {
  return static_cast<std::size_t>(std::upper_bound(start.begin(), start.end(), sorted) -
                                  start.begin()) - 1;
}

std::size_t CellGrid::at_or_after(std::uint64_t wanted) const {
  return static_cast<std::size_t>(std::lower_bound(key.begin(), key.end(), wanted) - key.begin());
}

std::uint64_t cell_along(std::uint64_t key, std::size_t axis) {
  return (key >> (axis * bits) & ((1u << bits) - 1)) - 1;
}

Eigen::AlignedBox3d box_of(const FrameAtoms& atoms, std::size_t first) {
  double sum = 0;  // not finite if a position is not
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const Eigen::Vector3d at(atoms.x[i], atoms.y[i], atoms.z[i]);
    sum += 0 * at.sum();
    box.extend(at);
  }
  if (sum != 0) not_finite(atoms, first);
  return box;
}

std::array<std::int32_t, 3> middle_of(std::uint64_t key) {
  const auto along = [key](std::size_t axis) {
    return whole((static_cast<double>(cell_along(key, axis)) + 0.5) * reach);
  };
  return {along(0), along(1), along(2)};
}

}  // namespace mdana::defects
