// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "readers/amber_netcdf/convention.hpp"
#include "readers/frame.hpp"

namespace mdana::amber_netcdf {

/// What a frame says of itself: step, time, box. Throws InputError if that is wrong.
FrameHeader read_frame(const Content& content, const NetcdfFile& file, const std::string& path,
                       std::uint64_t index);

/// Box of edges with these lengths and angles [degrees] alpha (b, c), beta (a, c), gamma (a, b): a
/// along x, b in the plane xy. Edges without length are not periodic.
/// Throws InputError if they make no box.
Box box_from_lengths(const Eigen::Vector3d& lengths, const Eigen::Vector3d& angles,
                     const Eigen::Vector3d& origin);

}  // namespace mdana::amber_netcdf
