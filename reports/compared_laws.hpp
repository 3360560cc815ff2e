// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fits/contact_fit.hpp"
#include "reports/observations.hpp"

namespace mdana {

/// The parameters that are usually fitted and neither the data nor the constants give.
std::vector<FreeParameter> free_by_default(const CollisionLaw& law, const Observations& observations,
                                           const ContactFitSettings& settings);

/// A law with its fit to the data.
struct ComparedLaw {
  const CollisionLaw* law;
  ContactFit fit;
};

/// All laws that the data allow, the one of least AIC first; why the others are left out, by their names.
struct ComparedLaws {
  std::vector<ComparedLaw> laws;
  std::vector<std::pair<std::string, std::string>> left_out;
};

/// Fits with what is free by default.
ComparedLaws compare_laws(const Observations& observations, ContactFitSettings settings);

}  // namespace mdana
