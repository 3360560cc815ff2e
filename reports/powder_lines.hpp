// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "fits/observed_collision.hpp"

namespace mdana {

enum class PowderCode { lammps, liggghts, yade };

/// A fit's contact parameters as input lines of a code for powders, with intervals and the range that
/// they were fitted in as comments. `fit` is a document of `mdana fit-contact`; `given` comes before
/// what the document has. Throws InputError with the place if a number is missing or has several values.
std::string powder_lines(PowderCode code, const nlohmann::ordered_json& fit, std::span<const NamedNumber> given,
                         const std::string& place);

}  // namespace mdana
