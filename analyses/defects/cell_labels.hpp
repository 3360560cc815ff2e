// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a kernel that is the same for all processors. Each includes it behind its own copy_row,
// find_near and structure, with MDANA_INLINE for its instructions.
#pragma once

#include <memory>

#include "analyses/defects.hpp"

namespace mdana::defects {
namespace {

/// The nine rows of three cells about a cell, as sorted atoms; moves on with the cells.
class Rows {
 public:
  MDANA_INLINE Rows(const CellGrid& grid, std::size_t cell) : grid_(grid) {
    for (int row = 0; row < 9; ++row)
      cursor_[row] = grid.at_or_after(key_beside(grid.key[cell], -1, row % 3 - 1, row / 3 - 1));
  }

  MDANA_INLINE void move_to(std::size_t cell) {
    const std::uint64_t* key = grid_.key.data();
    const std::size_t cells = grid_.cells();
    for (int row = 0; row < 9; ++row) {
      const std::uint64_t low = key_beside(key[cell], -1, row % 3 - 1, row / 3 - 1);
      std::size_t at = cursor_[row];
      while (at < cells && key[at] < low) ++at;
      cursor_[row] = at;
      std::size_t behind = at;
      while (behind < cells && key[behind] <= low + 2) ++behind;
      first[row] = grid_.start[at];
      end[row] = grid_.start[behind];
    }
  }

  std::uint32_t first[9], end[9];

 private:
  const CellGrid& grid_;
  std::size_t cursor_[9];  ///< first cell not before the row
};

constexpr int own_row = 4;

/// Fills the candidates; false if there are too many.
MDANA_INLINE bool gather(const CellGrid& grid, const Rows& rows, std::uint64_t key,
                         Candidates& candidates, std::size_t& own) {
  const auto middle = middle_of(key);
  candidates.count = 0;
  for (int row = 0; row < 9; ++row) {
    if (candidates.count + (rows.end[row] - rows.first[row]) > Candidates::capacity) return false;
    if (row == own_row) own = candidates.count;
    copy_row(grid, rows.first[row], rows.end[row], middle, candidates);
  }
  for (std::size_t i = 0; i < 16; ++i)
    candidates.x[candidates.count + i] = candidates.y[candidates.count + i] =
        candidates.z[candidates.count + i] = far_away;
  return true;
}

/// The label of one candidate.
MDANA_INLINE std::uint8_t label_of(const Candidates& candidates, std::size_t self, Near& near,
                                   float* margin) {
  constexpr float shell = static_cast<float>(between_shells * between_shells);
  constexpr float limit = static_cast<float>(reach * reach);
  find_near(candidates, self, shell, near);
  if (near.count != 12) {
    find_near(candidates, self, limit, near);
    if (near.count < 12) {
      if (margin) *margin = 0;
      return static_cast<std::uint8_t>(Structure::other);
    }
    keep_nearest(near);
  }
  return structure(near, margin);
}

MDANA_TARGET std::size_t label(const CellGrid& grid, std::size_t first, std::size_t end,
                               std::uint8_t* labels, float* margins) {
  const auto candidates = std::make_unique_for_overwrite<Candidates>();
  const auto near = std::make_unique_for_overwrite<Near>();
  Rows rows(grid, first);
  for (std::size_t cell = first; cell < end; ++cell) {
    rows.move_to(cell);
    std::size_t own = 0;
    if (!gather(grid, rows, grid.key[cell], *candidates, own)) return cell;
    for (std::uint32_t s = grid.start[cell]; s < grid.start[cell + 1]; ++s)
      labels[s] = label_of(*candidates, own + (s - rows.first[own_row]), *near,
                           margins ? margins + s : nullptr);
  }
  return end;
}

}  // namespace
}  // namespace mdana::defects
