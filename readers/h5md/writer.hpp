// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "readers/frame_writer.hpp"

namespace mdana::h5md {

/// A new H5MD file; an older one is replaced.
std::unique_ptr<FrameWriter> create(const std::filesystem::path& path);

}  // namespace mdana::h5md
