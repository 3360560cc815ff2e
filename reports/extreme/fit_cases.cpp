// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "fits/contact_fit.hpp"
#include "fits/force_fit.hpp"
#include "fits/hertz.hpp"
#include "reports/extreme/judged.hpp"
#include "reports/fitted.hpp"

namespace mdana {
namespace {

/// Digits that are left of 16 by the condition of a fit, one kept back.
double digits_left(double condition) { return std::clamp(15 - std::log10(std::max(condition, 1.0)), 0.0, 13.0); }

/// Points of Hertz's law, X evenly from the first touch to the deepest.
struct HertzPoints {
  double modulus = 65.5, radius = 147;
  double from = 0, to = 10;      ///< delta [length]
  std::size_t count = 100;
  double noise = 0;              ///< of the force, as a part of the greatest
  double spoilt = 0;             ///< added to one force

  HertzData data() const {
    HertzData d;
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0, noise);
    const double scale = 4.0 / 3 * modulus * std::sqrt(radius / 2);
    for (std::size_t i = 0; i < count; ++i) {
      const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 1;
      const double distance = 2 * radius - (from + (to - from) * share);
      const double error = noise > 0 ? normal(random) * scale * std::pow(to, 1.5) : 0;
      d.distance.push_back(distance);
      d.force.push_back(scale * std::pow(2 * radius - distance, 1.5) + error);
    }
    d.turn = count - 1;
    d.force[count / 2] += spoilt;
    return d;
  }
};

class FitCases {
 public:
  /// Exact points give both parameters back, to the digits that the condition leaves.
  void hertz(std::string what, const HertzPoints& points, HertzMethod method = HertzMethod::force) {
    add("fit-hertz", std::move(what), {}, [&] {
      const HertzFit fit = fit_hertz(points.data(), {.method = method});
      Judged judged;
      judged.condition(fit.fit.condition);
      judged.number("E*", fit.modulus.value, points.modulus, digits_left(fit.fit.condition));
      judged.number("R", fit.radius.value, points.radius, digits_left(fit.fit.condition));
      return judged;
    });
  }

  /// Points with noise give them within twice the errors that are published.
  void noisy(std::string what, const HertzPoints& points) {
    add("fit-hertz", std::move(what), {}, [&] {
      const HertzResult result = fit_hertz_with_spread(points.data(), {});
      Judged judged;
      judged.condition(result.fit.fit.condition);
      judged.within_error("E*", result.modulus, points.modulus);
      judged.within_error("R", result.radius, points.radius);
      return judged;
    });
  }

  /// A fit that must say that it is none, with these words.
  void refused(std::string what, const HertzPoints& points, const std::string& words) {
    add("fit-hertz", std::move(what), words, [&] {
      const HertzFit fit = fit_hertz(points.data());
      Judged judged(fit.fit.usable ? "" : fit.fit.reason);
      judged.must_be_refused(words, fit.modulus.value);
      return judged;
    });
  }

  /// Exact points of a law of forces, some of whose constants are free.
  void force(std::string_view name, std::string what, const ElasticContact& truth, double from, double to,
             const std::vector<std::string>& free, const std::string& words = {}) {
    const ForceLaw* law = find_force_law(name);
    if (!law) return;
    add("fit-force " + std::string(name), std::move(what), words, [&] {
      ForceData data;
      data.reduced_radius = truth.radius;
      data.radius_sum = 4 * truth.radius;
      constexpr int count = 100;
      for (int i = 0; i <= count; ++i) {
        data.distance.push_back(data.radius_sum - (from + (to - from) * i / count));
        data.force.push_back(law->force(data.radius_sum - data.distance.back(), truth));
      }
      data.turn = count;
      data.error.assign(data.force.size(), std::numeric_limits<double>::quiet_NaN());
      const ForceFit fit = fit_force(*law, data, {.free = free, .constants = truth});
      Judged judged(fit.fit.usable ? "" : fit.fit.reason);
      if (!words.empty()) {
        judged.must_be_refused(words, fit.parameters.back().value);
        return judged;
      }
      judged.condition(fit.fit.condition);
      for (const ForceEstimate& p : fit.parameters)
        judged.number(p.name, p.value, p.name == "gamma" ? truth.surface_energy : truth.modulus,
                      digits_left(fit.fit.condition));
      return judged;
    });
  }

  /// Collisions of a law at some speeds, with errors of 0.01; `words` if they determine nothing.
  void collisions(std::string_view name, std::string what, const std::vector<NamedNumber>& truth, const std::vector<double>& speeds,
                  const std::vector<std::string>& free, const std::string& words = {}) {
    const CollisionLaw* law = find_collision_law(name);
    if (!law) return;
    add("fit-contact " + std::string(name), std::move(what), words, [&] {
      ContactFitSettings settings;
      std::vector<ObservedCollision> seen;
      for (const double speed : speeds) seen.push_back(observed(*law, truth, speed));
      for (const NamedNumber& t : truth) {
        if (std::ranges::find(free, t.name) == free.end()) settings.constants.push_back(t);
        else settings.free.push_back({t.name});
      }
      settings.starts = 4;
      const ContactFit fit = fit_contact(*law, seen, settings);
      Judged judged(fit.usable ? "" : fit.reason);
      if (!words.empty() || fit.singular_values.empty()) {
        judged.must_be_refused(words, fit.parameters.empty() ? std::nan("") : fit.parameters[0].value);
        return judged;
      }
      judged.condition(fit.singular_values.front() / fit.singular_values.back());
      for (const Estimate& p : fit.parameters)
        judged.within_error(p.name, {p.value, p.error, {}}, std::ranges::find(truth, p.name, &NamedNumber::name)->value);
      return judged;
    });
  }

  std::vector<ExtremeCase> cases;

 private:
  static ObservedCollision observed(const CollisionLaw& law, const std::vector<NamedNumber>& truth, double speed) {
    ObservedCollision o;
    o.given = {{"R", 147}, {"m", 14434147}, {"v", speed}};
    o.place = "case";
    const Collision c = collide(law, input_of(law, o, truth), {.tolerance = 1e-10});
    o.stuck = c.outcome == CollisionOutcome::stick;
    o.e = {o.stuck ? 0 : c.e, 0.01};
    return o;
  }

  template <class Work>
  void add(std::string member, std::string what, const std::string& words, Work&& work) {
    cases.push_back(judge(std::move(member), std::move(what), words, work));
  }
};

void add_hertz_ranges(FitCases& cases) {
  for (const HertzMethod method : {HertzMethod::force, HertzMethod::linear})
    cases.hertz(fmt::format("the whole loading, method {}", name(method)), {}, method);
  for (const double part : {0.5, 0.1, 0.01, 0.001})
    cases.hertz(fmt::format("only the last {:g} of delta", part), {.from = 10 * (1 - part)});
  for (const std::size_t count : {5, 8, 10000}) cases.hertz(fmt::format("{} points", count), {.count = count});
  for (const double delta : {1e-2, 1e-4, 1e-6})
    cases.hertz(fmt::format("delta to {:g} R", delta), {.to = 147 * delta});
}

void add_hertz_scales(FitCases& cases) {
  for (const double scale : {1e-30, 1e-9, 1e9, 1e30}) {
    cases.hertz(fmt::format("lengths times {:g}", scale), {.radius = 147 * scale, .to = 10 * scale});
    cases.hertz(fmt::format("forces times {:g}", scale), {.modulus = 65.5 * scale});
  }
}

void add_hertz_noise(FitCases& cases) {
  for (const double noise : {1e-6, 1e-3, 1e-2, 0.1}) {
    cases.noisy(fmt::format("noise of {:g} of the greatest force", noise), {.noise = noise});
    cases.noisy(fmt::format("noise of {:g}, only the last tenth of delta", noise), {.from = 9, .noise = noise});
  }
}

void add_hertz_refusals(FitCases& cases) {
  cases.refused("two points", {.count = 2}, "frames");
  cases.refused("all points at one distance", {.from = 10}, "same distance");
  cases.refused("no force", {.modulus = 0}, "at least 3 are needed");
  cases.refused("a force nan", {.spoilt = std::nan("")}, "finite");
  cases.refused("a force inf", {.spoilt = std::numeric_limits<double>::infinity()}, "finite");
  cases.refused("forces that attract", {.modulus = -65.5}, "at least 3 are needed");
}

/// gamma shows near the equilibrium delta0 = 2.2 here, hardly at a thousand times that.
void add_adhesion(FitCases& cases) {
  const ElasticContact truth{.radius = 73.5, .modulus = 65.5, .surface_energy = 3.17};
  for (const double to : {0.5, 5.0, 50.0})
    cases.force("jkr", fmt::format("E* and gamma, delta to {:g}", to), truth, -0.2, to, {"E*", "gamma"});
  cases.force("jkr", "E* and gamma, only delta of 49 to 50", truth, 49, 50, {"E*", "gamma"});
  for (const char* law : {"jkr", "dmt"}) {
    ElasticContact weak = truth;
    weak.surface_energy = 1e-3;
    cases.force(law, "E* and gamma = 0.001", weak, 0, 5, {"E*", "gamma"});
    weak.surface_energy = 1e-6;
    cases.force(law, "E* and gamma = 1e-06", weak, 0, 5, {"E*", "gamma"}, "ran out of its range");
  }
}

void add_collisions(FitCases& cases) {
  const std::vector<NamedNumber> jkr{{"E", 65.5}, {"gamma", 3.17}};
  cases.collisions("jkr", "gamma from speeds about the limit of sticking", jkr, {0.02, 0.05, 0.1, 0.2}, {"gamma"});
  const std::vector<NamedNumber> krijt{{"E", 65.5}, {"gamma", 3.17}, {"nu", 0.25}, {"T_vis", 0.075}, {"spacing", 1.091}};
  cases.collisions("krijt", "T_vis from one speed", krijt, {0.3}, {"T_vis"});
  cases.collisions("krijt", "T_vis from speeds that all stick", krijt, {0.001, 0.002, 0.003}, {"T_vis"}, "bounds the parameters");
  const std::vector<NamedNumber> stress{{"E", 65.5}, {"gamma", 3.17}, {"nu", 0.25}, {"spacing", 1.091},
                                        {"C", 2.1e-4}, {"B", 6.2}, {"zeta", 4}};
  cases.collisions("stress", "C, B and zeta from two speeds", stress, {0.2, 0.4}, {"C", "B", "zeta"}, "do not determine");
  const std::vector<NamedNumber> andrews{{"E", 65.5}, {"Y", 5}};
  cases.collisions("andrews", "E* and Y from e alone", andrews, {0.1, 0.2, 0.3}, {"E", "Y"}, "do not determine");
}

}  // namespace

std::vector<ExtremeCase> extreme_fits() {
  FitCases cases;
  add_hertz_ranges(cases);
  add_hertz_scales(cases);
  add_hertz_noise(cases);
  add_hertz_refusals(cases);
  add_adhesion(cases);
  add_collisions(cases);
  return std::move(cases.cases);
}

}  // namespace mdana
