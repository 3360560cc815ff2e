// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/thermo_log.hpp"
#include "reports/document.hpp"

namespace mdana {

/// What `mdana info` tells of a log of LAMMPS.
Document thermo_summary(const ThermoLog& log);

}  // namespace mdana
