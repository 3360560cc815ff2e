// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/analysed_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "analyses/defects.hpp"
#include "analyses/energy.hpp"
#include "analyses/far_side.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// A Hertz scene measures its own radius, so its delta counts from there.
void fit_hertz_of(AnalysedRun& result, const Run& run, const HertzSettings& settings, bool take_radius) {
  require_known_ratio(run, result.measured.swept.tables[0], result.radii);
  result.hertz =
      told_of(run, [&] { return fit_hertz_with_spread(hertz_data(result.curve, result.radii), settings); });
  if (!take_radius || !result.hertz->fit.fit.usable) return;
  const double first = 2 * result.hertz->fit.radius.value * (result.radii.value[0] / result.radii.sum());
  const double second = 2 * result.hertz->fit.radius.value - first;
  result.radii = {{first, second}, "Hertz fit of this run", 2 * *result.hertz->radius.error};
  result.curve = touching_force_curve(run, result.measured.motion, result.source, result.radii);
}

/// The pass over the dump.
class Pass {
 public:
  Pass(const Run& run, const RunWishes& wishes, AnalysedRun& result) : run_(run), wishes_(wishes), result_(result) {
    if (result.plan.has(Part::contact_radius)) set_contact();
    result_.contact_tables = analyses_.size();
    velocities_ = result.plan.has(Part::energies);
    if (result.plan.has(Part::plasticity)) analyses_.push_back(make_far_side());
    if (velocities_) analyses_.push_back(make_energy(choose_potential(run, wishes.potential).column));
    if (result.plan.has(Part::structure)) set_structure();
  }

  void measure(const SweepOptions& options) {
    const MotionParts parts = velocities_ ? parts_for_energy(run_) : parts_for(result_.source);
    result_.measured = measure_motion(run_, parts, std::move(analyses_), options);
    result_.curve = touching_force_curve(run_, result_.measured.motion, result_.source, result_.radii);
  }

  /// What needs the force curve with its final radii.
  void conclude() {
    result_.restitution = restitution(result_.measured.motion, result_.curve);
    if (result_.contact_setup) result_.contact = contact_numbers(result_.measured, result_.radii.sum());
    if (velocities_)
      result_.energy = measure_energy(run_, result_.measured, result_.measured.swept.tables[result_.contact_tables + 2],
                                      result_.radii, wishes_.potential);
    if (result_.defects) take_defects();
    settle();
  }

 private:
  void set_contact() try {
    result_.contact_setup = contact_setup(run_, wishes_.contact);
    analyses_ = contact_analyses(result_.radii, *result_.contact_setup);
  } catch (const InputError& error) {
    leave_out_contact(error.what());
  }

  void leave_out_contact(const std::string& reason) {
    result_.plan.leave_out(Part::contact_areas, reason);
    result_.plan.leave_out(Part::contact_radius, reason);
  }

  /// What only the motion itself tells.
  void settle() {
    result_.plan.settle(result_.restitution, result_.curve.outcome);
    if (result_.contact_setup && !result_.touch())
      leave_out_contact("the layer about the contact plane never holds atoms of both bodies");
  }

  void set_structure() {
#ifdef MDANA_WITH_DEFECTS
    result_.defects.emplace();
    DefectSettings settings;
    settings.ids = run_.first.has_column("id");
    settings.product = [this](const FrameHeader&, const FrameDefects& found) {
      result_.defects->planes.push_back(found.planes);
    };
    analyses_.push_back(make_defects(std::move(settings)));
#endif
  }

  void take_defects() {
    DefectHistory& history = *result_.defects;
    history.steps = result_.measured.swept.steps;
    history.times = result_.measured.motion.times;
    history.delta = result_.curve.delta;
    history.table = std::move(result_.measured.swept.tables.back());
    result_.measured.swept.tables.pop_back();
  }

  const Run& run_;
  const RunWishes& wishes_;
  AnalysedRun& result_;
  bool velocities_ = false;
  std::vector<std::unique_ptr<Analysis>> analyses_;
};

}  // namespace

std::vector<PublishedValue> AnalysedRun::numbers() const {
  std::vector<PublishedValue> all{{"F_max", curve.force_max},
                                  {"F_min_loading", curve.force_min_loading},
                                  {"delta_max", curve.delta_max},
                                  {"hysteresis_area", curve.hysteresis_area}};
  if (restitution.e.value > 0) all.push_back({"e", restitution.e});
  if (touch())
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

/// Parts that numbers() are of.
constexpr std::array published{Part::force, Part::restitution, Part::contact_radius, Part::contact_areas, Part::hertz_fit};

RunWishes same_numbers(const AnalysedRun& analysed) {
  RunWishes wishes;
  for (const PlannedPart& planned : analysed.plan.computed)
    if (std::ranges::find(published, planned.part) != published.end()) wishes.plan.computed.push_back(planned);
  if (!analysed.hertz) wishes.radii = analysed.radii;
  return wishes;
}

AnalysedRun analyse_run(const Run& run, const RunWishes& wishes, const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  AnalysedRun result;
  result.plan = wishes.plan;
  result.source = best_force_source(run);
  result.radii = wishes.radii ? *wishes.radii : find_radii(run, {});
  Pass pass(run, wishes, result);
  pass.measure(options);
  if (result.plan.has(Part::hertz_fit)) fit_hertz_of(result, run, wishes.hertz_settings, !wishes.radii);
  pass.conclude();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace mdana
