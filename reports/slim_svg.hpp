// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace mdana {

/// A picture of gnuplot's svg terminal without what it does not use (filters, symbols, empty groups,
/// default attributes), coordinates cut to 0.1 pixel. It looks the same and is a third as long.
std::string slim_svg(std::string_view svg);

}  // namespace mdana
