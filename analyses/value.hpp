// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "readers/dimension.hpp"

namespace mdana {

/// A published number: what it is, how wrong it may be, what it measures.
struct Value {
  double value = 0;
  std::optional<double> error;  ///< standard error, same unit; nothing if not estimated
  Dimension dimension;
};

}  // namespace mdana
