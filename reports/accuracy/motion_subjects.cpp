// SPDX-License-Identifier: GPL-3.0-or-later
// Force, Hertz fit and energy of a dump, with their knobs.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analyses/energy.hpp"
#include "analyses/restitution.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy/dump_subject.hpp"
#include "reports/fitted.hpp"
#include "reports/measured_energy.hpp"

namespace mdana {
namespace {

constexpr std::array<HertzMethod, 2> methods{HertzMethod::force, HertzMethod::linear};
constexpr std::array<HertzPhase, 2> phases{HertzPhase::loading, HertzPhase::all};
constexpr std::array<double, 4> least_forces{0.05, 0.02, 0.1, 0.2};
constexpr std::array<double, 3> greatest_forces{1, 0.75, 0.5};
constexpr std::array<Loss, 3> losses{Loss::none, Loss::huber, Loss::cauchy};
constexpr std::array<HertzWeights, 2> weights{HertzWeights::equal, HertzWeights::errors};
constexpr std::array<std::string_view, 2> weight_names{"equal", "errors"};

std::vector<DumpKnob> hertz_knobs() {
  const auto number = [](const auto& list) { return [&list](std::size_t k) { return fmt::format("{:g}", list[k]); }; };
  return {choice_knob("method", "least squares in F (force) or in F^(2/3) (linear)", methods,
                      [](std::size_t k) { return name(methods[k]); },
                      [](Measuring& m, std::size_t k) { m.hertz.method = methods[k]; }),
          choice_knob("phase", "frames that are fitted", phases, [](std::size_t k) { return name(phases[k]); },
                      [](Measuring& m, std::size_t k) { m.hertz.phase = phases[k]; }),
          choice_knob("min-force-fraction", "least force that is fitted, over F_max", least_forces, number(least_forces),
                      [](Measuring& m, std::size_t k) { m.hertz.min_force_fraction = least_forces[k]; }),
          choice_knob("max-force-fraction", "greatest force that is fitted, over F_max", greatest_forces,
                      number(greatest_forces),
                      [](Measuring& m, std::size_t k) { m.hertz.max_force_fraction = greatest_forces[k]; }),
          choice_knob("loss", "how outliers are damped", losses, [](std::size_t k) { return name(losses[k]); },
                      [](Measuring& m, std::size_t k) { m.hertz.loss = losses[k]; }),
          choice_knob("weights", "of the points", weights, [](std::size_t k) { return weight_names[k]; },
                      [](Measuring& m, std::size_t k) { m.hertz.weights = weights[k]; })};
}

/// m* v^2/2 of the greatest speed; without speeds F_max delta_max.
double kinetic_energy(const RelativeMotion& motion, const ForceCurve& curve, Units units) {
  const std::vector<double> squares = squared_speed(motion);
  if (squares.empty()) return std::abs(curve.force_max.value * curve.delta_max.value);
  return 0.5 * motion.reduced_mass * force_per_mass_acceleration(units) * *std::ranges::max_element(squares);
}

std::vector<JudgedNumber> force_numbers(const DumpQuestion& q, const Measuring& m) {
  const MeasuredForce force = measure_force(q, m);
  const RelativeMotion& motion = force.measured.motion;
  return judged_force(motion, force.curve, restitution(motion, force.curve), q.run.units);
}

std::vector<JudgedNumber> hertz_numbers(const DumpQuestion& q, const Measuring& m) {
  const MeasuredForce force = measure_force(q, m);
  require_known_ratio(q.run, force.measured.swept.tables[0], force.radii);
  const HertzResult hertz =
      told_of(q.run, [&] { return fit_hertz_with_spread(hertz_data(force.curve, force.radii), m.hertz); });
  if (!hertz.fit.fit.usable) throw InputError(fmt::format("{}: the Hertz fit is not usable: {}", q.run.dump.string(), hertz.fit.fit.reason));
  return {{"E_star", hertz.modulus}, {"R", hertz.radius}};
}

std::vector<JudgedNumber> energy_numbers(const DumpQuestion& q, const Measuring& m) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_energy(choose_potential(q.run, q.potential).column));
  const MeasuredMotion measured = measure_motion(q.run, parts_for_energy(q.run), std::move(analyses), m.sweeping);
  const MeasuredEnergy energy = measure_energy(q.run, measured, measured.swept.tables[1], find_radii(q.run, q.options), q.potential);
  if (!energy.budget) throw InputError(q.run.dump.string() + ": " + energy.budget_obstacle);
  return judged_energy(*energy.budget);
}

}  // namespace

std::vector<JudgedNumber> judged_force(const RelativeMotion& motion, const ForceCurve& curve, const Restitution& restitution,
                                       Units units) {
  const double energy = kinetic_energy(motion, curve, units), force = std::abs(curve.force_max.value);
  std::vector<JudgedNumber> numbers{{"F_max", curve.force_max},
                                    {"F_min_loading", curve.force_min_loading, force},
                                    {"delta_max", curve.delta_max},
                                    {"hysteresis_area", curve.hysteresis_area, energy},
                                    {"kinetic_loss", curve.kinetic_loss, energy}};
  if (curve.outcome == Outcome::bounce && !std::isnan(restitution.e.value)) numbers.push_back({"e", restitution.e, 1});
  return numbers;
}

std::vector<JudgedNumber> judged_energy(const EnergyBudget& budget) {
  const double scale = std::abs(budget.K_p_initial.value);
  return {{"K_p_initial", budget.K_p_initial},
          {"delta_K_p", budget.delta_K_p, scale},
          {"delta_K_t", budget.delta_K_t, scale},
          {"delta_W", budget.delta_W, scale}};
}

AccuracySubject force_subject(const DumpQuestion& question) {
  return dump_subject("force", question, together(sweep_knobs(), derivative_knobs(question.run)), force_numbers);
}

AccuracySubject fit_hertz_subject(const DumpQuestion& question) {
  return dump_subject("fit-hertz", question,
                      together(together(sweep_knobs(), derivative_knobs(question.run)), hertz_knobs()), hertz_numbers);
}

AccuracySubject energy_subject(const DumpQuestion& question) {
  return dump_subject("energy", question, sweep_knobs(), energy_numbers);
}

}  // namespace mdana
