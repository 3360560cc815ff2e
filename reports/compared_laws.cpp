// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/compared_laws.hpp"

#include <algorithm>
#include <cmath>

#include "readers/input_error.hpp"

namespace mdana {

std::vector<FreeParameter> free_by_default(const CollisionLaw& law, const Observations& observations,
                                           const ContactFitSettings& settings) {
  std::vector<FreeParameter> free = usual_free_parameters(law);
  std::erase_if(free, [&](const FreeParameter& f) {
    return observations.given(f.name) ||
           std::ranges::find(settings.constants, f.name, &NamedNumber::name) != settings.constants.end();
  });
  return free;
}

ComparedLaws compare_laws(const Observations& observations, ContactFitSettings settings) {
  ComparedLaws all;
  for (const CollisionLaw* law : collision_laws()) try {
      settings.free = free_by_default(*law, observations, settings);
      ContactFit fit = fit_contact(*law, observations.seen, settings);
      if (fit.points.empty())
        all.left_out.emplace_back(law->name, fit.reason);
      else
        all.laws.push_back({law, std::move(fit)});
    } catch (const InputError& error) {
      all.left_out.emplace_back(law->name, error.what());
    }
  std::ranges::stable_sort(all.laws, {}, [](const ComparedLaw& c) { return std::isfinite(c.fit.aic) ? c.fit.aic : 1e300; });
  return all;
}

}  // namespace mdana
