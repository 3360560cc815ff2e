// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/neighbours.hpp"

#include <algorithm>

#include "analyses/defects/structure_kernel.hpp"
#include "readers/input_error.hpp"

namespace mdana::defects {
namespace {

/// Remembers the rows of cells about the last atom.
class CellSearch final : public NeighbourSearch {
 public:
  explicit CellSearch(const CellGrid& grid) : grid_(grid), cell_(grid.cells()) {}

  void about(std::uint32_t place, Neighbours& found) override {
    move_to(grid_.cell_of(place));
    found.clear();
    constexpr float limit = static_cast<float>(reach * reach);
    std::size_t looked_at = 0;
    for (const Row& row : rows_) {
      looked_at += row.end - row.first;
      if (looked_at > Candidates::capacity) too_many_neighbours();
      for (std::uint32_t other = row.first; other < row.end; ++other) {
        const Eigen::Vector3f to = offset(grid_, place, other);
        const float d2 = squared_length(to);
        if (d2 < limit && other != place) found.push_back({other, to, d2});
      }
    }
  }

 private:
  struct Row {
    std::uint32_t first, end;
  };

  void move_to(std::size_t cell) {
    if (cell == cell_) return;
    cell_ = cell;
    for (int k = 0; k < 9; ++k) {
      const std::uint64_t low = key_beside(grid_.key[cell], -1, k % 3 - 1, k / 3 - 1);
      const std::size_t first = grid_.at_or_after(low);
      std::size_t end = first;
      while (end < grid_.cells() && grid_.key[end] <= low + 2) ++end;
      rows_[static_cast<std::size_t>(k)] = {grid_.start[first], grid_.start[end]};
    }
  }

  const CellGrid& grid_;
  std::size_t cell_;
  std::array<Row, 9> rows_;
};

}  // namespace

SearchMaker cell_search(const CellGrid& grid) {
  return [&grid] { return std::make_unique<CellSearch>(grid); };
}

Eigen::Vector3f offset(const CellGrid& grid, std::uint32_t from, std::uint32_t to) {
  constexpr float unit = static_cast<float>(1 / units_a_spacing);
  const auto along = [&](const std::vector<std::int32_t>& axis) {
    return unit * static_cast<float>(static_cast<std::int32_t>(
                      static_cast<std::uint32_t>(axis[to]) - static_cast<std::uint32_t>(axis[from])));
  };
  return {along(grid.x), along(grid.y), along(grid.z)};
}

void too_many_neighbours() {
  throw InputError("thousands of atoms within 1.45 neighbour distances of one: some lie on top of "
                   "each other; state the distance by --spacing if it is not that of the first shell");
}

}  // namespace mdana::defects
