// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analyses/analysis.hpp"

namespace mdana {

/// Atoms of bodies 1 and 2 near a plane through both centres, seen along its normal, which is as near to the z axis
/// as it can be (to the x axis if the line of centres is near z).
struct Slice {
  double diameter = 0;  ///< of an atom; the slice is as thick [length]
  /// Of body 1, 2 [length]: across the line of centres, along it, and above the plane, from the middle between the centres.
  std::array<std::vector<Eigen::Vector3d>, 2> at;

  std::size_t size() const { return at[0].size() + at[1].size(); }
};

/// Gives the slice of each frame to `product`, in order. Without a diameter it is the median distance of nearest
/// neighbours. Column: slice_atoms. Throws InputError if a body has no atoms, or the centres coincide.
std::unique_ptr<Analysis> make_slice(std::optional<double> diameter, std::function<void(Slice)> product);

}  // namespace mdana
