// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/known_answer.hpp"

#include <algorithm>
#include <cmath>

namespace mdana {

double correct_digits(const KnownAnswer& answer) {
  const double error = answer.exact == 0 ? std::abs(answer.computed)
                                         : std::abs(answer.computed / answer.exact - 1);
  if (std::isnan(error)) return 0;
  return error == 0 ? 16.0 : std::clamp(-std::log10(error), 0.0, 16.0);
}

}  // namespace mdana
