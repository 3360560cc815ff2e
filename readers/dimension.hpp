// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mdana {

/// Powers of mass, length and time of a quantity: if masses, lengths and times are multiplied by
/// m, l, t, a value of this dimension is multiplied by m^mass l^length t^time.
struct Dimension {
  int mass = 0;
  int length = 0;
  int time = 0;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension mass{1, 0, 0};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension area{0, 2, 0};
inline constexpr Dimension volume{0, 3, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension velocity{0, 1, -1};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension energy{1, 2, -2};
inline constexpr Dimension pressure{1, -1, -2};
inline constexpr Dimension surface_energy{1, 0, -2};
}  // namespace dimension

}  // namespace mdana
