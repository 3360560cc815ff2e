// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "analyses/defects/lattice.hpp"
#include "analyses/defects/zone.hpp"
#include "analyses/dislocation_lines.hpp"

namespace mdana::defects {

/// Finds the dislocation lines of a labelled frame; see lines.md. Only atoms near defects are looked at, more of them
/// where lines leave these: the slabs of the frame are added again as long as the finder wants more.
class LineFinder {
 public:
  /// `origin` of the frame's zones [length]; `everywhere`: all atoms are looked at.
  LineFinder(const Eigen::Vector3d& origin, double spacing, bool everywhere);
  ~LineFinder();

  void add(const Sites& sites);  ///< of the next slab
  /// After all slabs: true if they are to be added once more. `lattices` of bodies 1 and 2.
  bool wants_more(std::span<const BodyLattice, 2> lattices, std::size_t threads);
  DislocationLines lines();  ///< once

 private:
  struct Found;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mdana::defects
