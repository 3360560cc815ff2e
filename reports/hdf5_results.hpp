// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fits/observed_collision.hpp"

namespace mdana {

/// What an HDF5 file of mdana (-o FILE.h5) holds. In a build without HDF5 no file holds results, and the
/// others throw InputError.
bool holds_results(const std::filesystem::path& path);

/// The JSON document. Throws InputError if the file holds no results.
std::string hdf5_document(const std::filesystem::path& path);

/// time, delta, v and F of the table; none if it has no time and delta.
std::vector<MotionSample> hdf5_motion(const std::filesystem::path& path);

}  // namespace mdana
