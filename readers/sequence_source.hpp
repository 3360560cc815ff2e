// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "readers/file_set.hpp"
#include "readers/format.hpp"

namespace mdana {

/// Opens the pieces of one step.
using OpenPieces =
    std::function<std::unique_ptr<FrameSource>(const std::vector<std::filesystem::path>& pieces)>;

/// The frames of a set's steps one after another, numbered on; one step is open at a time.
std::unique_ptr<FrameSource> open_sequence(FileSet files, OpenPieces open);

}  // namespace mdana
