// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "analyses/defects.hpp"
#include "analyses/defects/cell_grid.hpp"
#include "analyses/defects/neighbours.hpp"

namespace mdana::defects {

/// Atoms of a cell and the 26 about it, relative to its middle [spacings].
struct Candidates {
  static constexpr std::size_t capacity = 8192;
  alignas(64) float x[capacity + CellGrid::padding], y[capacity + CellGrid::padding],
      z[capacity + CellGrid::padding];
  std::size_t count;
};

/// Atoms within some distance of one, relative to it [spacings], in the order of the candidates.
struct Near {
  static constexpr std::size_t capacity = Candidates::capacity;
  alignas(64) float x[capacity + CellGrid::padding], y[capacity + CellGrid::padding],
      z[capacity + CellGrid::padding];
  std::size_t count;
};

inline constexpr float far_away = 1e6f;  ///< [spacings], of no atom

/// Keeps the 12 nearest (of equal ones the first) in their order; there must be as many.
void keep_nearest(Near& near);

/// Common neighbour analysis with the local cutoff of Stukowski (2012), written for one kind of
/// processor; all give the same bits.
struct StructureKernel {
  std::string_view name;
  bool (*supported)();  ///< by the processor that runs it

  /// Labels (Structure: other, fcc, hcp) of the sorted atoms of cells first to end - 1, and their
  /// margins unless that is null. Returns the first cell about which there are more atoms than
  /// Candidates can hold, or `end`.
  std::size_t (*label)(const CellGrid& grid, std::size_t first, std::size_t end,
                       std::uint8_t* labels, float* margins);
};

/// The same of one atom from all its neighbours within reach, at least 12, by place.
Structure structure_of(const Neighbours& all, float* margin);

/// All kernels of this build, fastest first; the last one runs everywhere.
std::span<const StructureKernel* const> structure_kernels();

/// The fastest one that this processor supports.
const StructureKernel& best_structure_kernel();

/// Of pairs as far apart as in a perfect crystal: |r^2 - c^2|/c^2 of the local cutoff c.
inline constexpr float perfect_gap = 0.3137085f;

}  // namespace mdana::defects
