// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace mdana {

/// Text of a file as messages show it: its first bytes, with ? for what a terminal would obey.
std::string shown(std::string_view text, std::size_t longest = 60);

}  // namespace mdana
