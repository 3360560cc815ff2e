// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "analyses/analysis.hpp"

namespace mdana {

/// Three columns of a block as one array of vectors.
struct VectorColumn {
  std::span<const double> x, y, z;
  VectorColumn(const AtomBlock& block, std::array<const char*, 3> names)
      : x(block.real(names[0])), y(block.real(names[1])), z(block.real(names[2])) {}
  Eigen::Vector3d operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Weighted means of a vector column for bodies 1 and 2 of these masses, zero for a body without
/// atoms: twice over the block, the second time about the first mean, which leaves no rounding that
/// grows with the number of atoms.
std::array<Eigen::Vector3d, 2> block_means(const VectorColumn& column, const LabelledBlock& block,
                                           const std::array<double, 2>& mass);

}  // namespace mdana
