// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace mdana {

/// Bytes that the machine can give to programs now, caches of files included; 1 GiB if it does not tell.
std::size_t free_memory();

}  // namespace mdana
