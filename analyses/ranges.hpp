// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace mdana {

/// Calls use(first, end) for the ranges 0..size-1, size..2 size-1, ... of `count` things, in up to
/// `threads` threads (oneTBB); which thread takes which range tells nothing. What a call throws is
/// thrown here, that of the lowest range.
void for_ranges(std::size_t count, std::size_t size, std::size_t threads,
                const std::function<void(std::size_t first, std::size_t end)>& use);

}  // namespace mdana
