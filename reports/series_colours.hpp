// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace mdana {

/// Okabe & Ito's colours, told apart by every kind of colour vision; of the series of a figure in order.
inline constexpr std::array<std::string_view, 7> series_colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                                "#E69F00", "#56B4E9", "#000000"};

}  // namespace mdana
