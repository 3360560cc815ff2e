// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/analysed_run.hpp"

#include <chrono>

namespace mdana {
namespace {

/// A Hertz scene measures its own radius, so its delta counts from there.
void fit_and_take_radius(AnalysedRun& result, const Run& run) {
  require_known_ratio(run, result.measured.swept.tables[0], result.radii);
  result.hertz =
      told_of(run, [&] { return fit_hertz_with_spread(hertz_data(result.curve, result.radii), {}); });
  if (!result.hertz->fit.fit.usable) return;
  const double first = 2 * result.hertz->fit.radius.value * (result.radii.value[0] / result.radii.sum());
  const double second = 2 * result.hertz->fit.radius.value - first;
  result.radii = {{first, second}, "Hertz fit of this run", 2 * *result.hertz->radius.error};
  result.curve = touching_force_curve(run, result.measured.motion, result.source, result.radii);
}

}  // namespace

std::vector<PublishedValue> AnalysedRun::numbers() const {
  std::vector<PublishedValue> all{{"F_max", curve.force_max},
                                  {"F_min_loading", curve.force_min_loading},
                                  {"delta_max", curve.delta_max},
                                  {"hysteresis_area", curve.hysteresis_area}};
  if (contact.touch())
    for (const ContactRadiusNumbers& n : contact.definitions) {
      const std::string prefix = "contact_radius." + std::string(n.definition);
      all.push_back({prefix + ".max", n.max});
      all.push_back({prefix + ".at_delta_max", n.at_delta_max});
    }
  if (hertz) {
    all.push_back({"E_star", hertz->modulus});
    all.push_back({"R", hertz->radius});
  }
  return all;
}

AnalysedRun analyse_run(const Run& run, const std::optional<Radii>& radii,
                        const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  AnalysedRun result;
  result.source = best_force_source(run);
  result.radii = radii ? *radii : find_radii(run, {});
  result.contact_setup = contact_setup(run, {});
  result.measured = measure_motion(run, parts_for(result.source),
                                   contact_analyses(result.radii, result.contact_setup), options);
  result.curve = touching_force_curve(run, result.measured.motion, result.source, result.radii);
  if (!radii && run.scene.interaction == Interaction::hertz) fit_and_take_radius(result, run);
  result.contact = contact_numbers(result.measured, result.radii.sum());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace mdana
