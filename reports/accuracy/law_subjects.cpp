// SPDX-License-Identifier: GPL-3.0-or-later
// Predicted collisions and fits of collision laws, with their knobs.
#include <array>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"

namespace mdana {
namespace {

constexpr std::array<double, 6> tolerances{1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2};
constexpr std::array<int, 5> starts{16, 8, 4, 2, 1};
constexpr std::array<Loss, 3> losses{Loss::none, Loss::huber, Loss::cauchy};
constexpr std::array<std::size_t, 4> bootstrap_draws{320, 80, 40, 20};
constexpr int seeds = 8;
const FixedChoice collision_tolerance{"collision-tolerance", "1e-9 of e", "what is looser is hardly cheaper, and dearer in stiff laws"};

std::vector<JudgedNumber> predicted_numbers(const Collision& c) {
  if (c.outcome == CollisionOutcome::unresolved) throw InputError("unresolved: " + c.reason);
  const bool bounce = c.outcome == CollisionOutcome::bounce;
  std::vector<JudgedNumber> numbers{{bounce ? "e" : "e_squared",
                                     {bounce ? c.e : c.e_squared, bounce ? c.e_error : c.e_squared_error, dimension::none}, 1}};
  const std::optional<double> stated = c.energy_residual == c.energy_residual ? std::optional(std::max(c.energy_residual, c.e_error))
                                                                             : std::nullopt;
  for (const auto& [name, value, dim] : {std::tuple{"delta_max", c.delta_max, dimension::length}, {"t_max", c.t_max, dimension::time},
                                         {"a_max", c.a_max, dimension::length}})
    if (value == value) numbers.push_back({name, {value, stated ? std::optional(*stated * value) : std::nullopt, dim}});
  return numbers;
}

/// A knob with a value for each element.
template <class Elements, class Text>
Knob knob_of(std::string name, std::string meaning, Reference reference, double order, const Elements& elements, Text&& text) {
  Knob knob{std::move(name), std::move(meaning), reference, order, {}};
  for (const auto& element : elements) knob.values.push_back(text(element));
  return knob;
}

Knob bootstrap_knob() {
  Knob knob = knob_of("bootstrap", "fits to collisions drawn from those seen", Reference::finest, 1, bootstrap_draws, [](std::size_t n) {
    return KnobValue{fmt::format("{} draws", n), 1 / std::sqrt(static_cast<double>(n))};
  });
  knob.draws = seeds;
  return knob;
}

/// Of a fit: its parameters, or with a bootstrap the widths of its intervals.
std::vector<JudgedNumber> fitted_numbers(const ContactFit& fit, bool bootstrap) {
  if (!fit.usable) throw InputError("the fit is not usable: " + fit.reason);
  std::vector<JudgedNumber> numbers;
  for (const Estimate& e : fit.parameters)
    if (bootstrap)
      numbers.push_back({e.full_name() + ".bootstrap_interval", {0.5 * (e.bootstrap.high - e.bootstrap.low), {}, dimension::none}});
    else
      numbers.push_back({e.full_name(), {e.value, e.error, dimension::none}});
  return numbers;
}

/// chi2 of each law; errors are parts of it, where standard errors are known at least of what the residuals are expected to sum
/// up to, one each.
std::vector<JudgedNumber> compared_numbers(const ComparedLaws& compared) {
  if (compared.laws.empty()) throw InputError("no law can be computed from the data");
  std::vector<JudgedNumber> numbers;
  for (const ComparedLaw& c : compared.laws) {
    const double expected = c.fit.known_errors ? static_cast<double>(c.fit.points.size()) : 0;
    if (!std::isfinite(c.fit.chi2)) continue;
    const double error = c.fit.parameters.empty() ? 0 : c.fit.chi2 * std::pow(10, -c.fit.digits);
    numbers.push_back({fmt::format("{}.chi2", c.law->name), {c.fit.chi2, error, dimension::none}, std::max(expected, c.fit.chi2)});
  }
  return numbers;
}

/// Knobs of every fit of collision laws.
std::vector<Knob> search_knobs() {
  return {knob_of("starts", "where searches begin", Reference::finest, 0, starts,
                  [](int n) { return KnobValue{fmt::format("{}", n), 1.0 / n}; }),
          knob_of("loss", "how outliers are damped", Reference::standard, 0, losses,
                  [](Loss loss) { return KnobValue{std::string(name(loss))}; })};
}

void set_search(const KnobChoice& choice, ContactFitSettings& settings) {
  if (choice.values.contains("starts")) settings.starts = starts[choice.of("starts")];
  if (choice.values.contains("loss")) settings.loss = losses[choice.of("loss")];
}

}  // namespace

AccuracySubject predict_subject(const CollisionLaw& law, const CollisionInput& input, const CollisionSettings& settings) {
  AccuracySubject subject{fmt::format("predict {}", law.name), {}, {}};
  subject.knobs.push_back(knob_of("tolerance", "wanted error of e", Reference::finest, 1, tolerances,
                                  [](double t) { return KnobValue{fmt::format("{:.0e}", t), t}; }));
  subject.fixed.push_back({"method", "Radau IIA, order 9", "for stiff laws and others; laws in closed form need none"});
  subject.measure = [&law, input, settings](const KnobChoice& choice) {
    CollisionSettings s = settings;
    s.tolerance = tolerances[choice.of("tolerance")];
    return predicted_numbers(collide(law, input, s));
  };
  return subject;
}

AccuracySubject fit_contact_subject(const CollisionLaw& law, std::vector<ObservedCollision> seen,
                                    const ContactFitSettings& settings) {
  AccuracySubject subject{fmt::format("fit-contact {}", law.name), search_knobs(), {}};
  subject.knobs.push_back(bootstrap_knob());
  subject.fixed.push_back(collision_tolerance);
  subject.measure = [&law, seen = std::move(seen), settings](const KnobChoice& choice) {
    ContactFitSettings s = settings;
    const bool bootstrap = choice.values.contains("bootstrap");
    s.intervals = {};
    set_search(choice, s);
    if (bootstrap) s.intervals.draws = bootstrap_draws[choice.of("bootstrap")];
    s.intervals.seed = choice.draw;
    return fitted_numbers(fit_contact(law, seen, s), bootstrap);
  };
  return subject;
}

AccuracySubject compare_laws_subject(const Observations& observations, const ContactFitSettings& settings) {
  AccuracySubject subject{"compare-laws", search_knobs(), {}};
  subject.fixed.push_back(collision_tolerance);
  subject.measure = [observations, settings](const KnobChoice& choice) {
    ContactFitSettings s = settings;
    s.cross_validation = false;
    set_search(choice, s);
    return compared_numbers(compare_laws(observations, s));
  };
  return subject;
}

}  // namespace mdana
