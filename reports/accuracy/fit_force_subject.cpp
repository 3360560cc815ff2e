// SPDX-License-Identifier: GPL-3.0-or-later
// Fit of a law of forces to F(delta), with its knobs.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/accuracy/dump_subject.hpp"
#include "reports/fitted.hpp"

namespace mdana {
namespace {

constexpr std::array<ForcePart, 2> parts{ForcePart::loading, ForcePart::loop};
constexpr std::array<Loss, 3> losses{Loss::none, Loss::huber, Loss::cauchy};
constexpr std::array<double, 4> least_deltas{0, 0.05, 0.1, 0.2};

/// The law that is asked for, then the others.
std::vector<const ForceLaw*> laws_from(const ForceLaw& first) {
  std::vector<const ForceLaw*> laws{&first};
  for (const ForceLaw* law : force_laws())
    if (law != &first) laws.push_back(law);
  return laws;
}

/// What is free and the law has.
std::vector<std::string> free_of(const ForceLaw& law, std::vector<std::string> free) {
  std::erase_if(free, [&](const std::string& name) {
    return name != "R" && name != "offset" && std::ranges::find(law.parameters, name, &ContactParameter::name) == law.parameters.end();
  });
  return free;
}

ForceFit fit_of(const DumpQuestion& q, const Measuring& m, const ForceCurve& curve, const Radii& radii) {
  ForceFitSettings settings = m.force_fit;
  settings.free = free_of(*m.law, settings.free);
  ForceFit fit = told_of(q.run, [&] { return fit_force(*m.law, force_data(curve, radii), settings); });
  if (!fit.fit.usable) throw InputError(fmt::format("{}: the fit is not usable: {}", q.run.dump.string(), fit.fit.reason));
  return fit;
}

/// The standard error, and the greatest difference to the same from every second frame; not known if these are too few.
std::optional<double> error_of(const ForceFit& fit, std::span<const ForceFit> halves, std::size_t k) {
  if (halves.size() < 2 || !std::isfinite(fit.parameters[k].error)) return std::nullopt;
  double greatest = 0;
  for (const ForceFit& half : halves) greatest = std::max(greatest, std::abs(half.parameters[k].value - fit.parameters[k].value));
  return std::hypot(fit.parameters[k].error, greatest);
}

std::vector<JudgedNumber> fitted_numbers(const DumpQuestion& q, const Measuring& m) {
  const MeasuredForce measured = measure_force(q, m);
  const ForceFit fit = fit_of(q, m, measured.curve, measured.radii);
  std::vector<ForceFit> halves;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) try {
      const RelativeMotion half = measured.measured.motion.subset(first, 2);
      const ForceCurve curve = touching_force_curve(q.run, half, measured.source, measured.radii, m.derivative);
      halves.push_back(fit_of(q, m, curve, measured.radii));
    } catch (const InputError&) {  // the error is then not known
    }
  std::vector<JudgedNumber> numbers;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k)
    numbers.push_back({fit.parameters[k].name, {fit.parameters[k].value, error_of(fit, halves, k), fit.parameters[k].dimension}});
  return numbers;
}

std::vector<DumpKnob> fit_knobs(const ForceLaw& law) {
  const std::vector<const ForceLaw*> laws = laws_from(law);
  return {choice_knob("law", "of the force", laws, [laws](std::size_t k) { return laws[k]->name; },
                      [laws](Measuring& m, std::size_t k) { m.law = laws[k]; }),
          choice_knob("part", "frames that are fitted", parts, [](std::size_t k) { return name(parts[k]); },
                      [](Measuring& m, std::size_t k) { m.force_fit.part = parts[k]; }),
          choice_knob("min-delta-fraction", "least delta that is fitted, over delta_max", least_deltas,
                      [](std::size_t k) { return fmt::format("{:g}", least_deltas[k]); },
                      [](Measuring& m, std::size_t k) { m.force_fit.min_delta_fraction = least_deltas[k]; }),
          choice_knob("loss", "how outliers are damped", losses, [](std::size_t k) { return name(losses[k]); },
                      [](Measuring& m, std::size_t k) { m.force_fit.loss = losses[k]; })};
}

}  // namespace

AccuracySubject fit_force_subject(const DumpQuestion& question) {
  return dump_subject("fit-force", question,
                      together(together(sweep_knobs(), derivative_knobs(question.run)), fit_knobs(*question.law)), fitted_numbers);
}

}  // namespace mdana
