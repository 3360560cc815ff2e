// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace mdana {

/// Bytes that this process can have now, caches of files included: what is free in the machine (1 GiB if it does not
/// tell), within the limits of its control groups and of its address space.
std::size_t free_memory();

}  // namespace mdana
