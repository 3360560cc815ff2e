// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/fitted.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyses/motion.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double equal_bodies = 0.01;

bool differ(double a, double b) { return std::abs(a - b) > equal_bodies * std::max(a, b); }

Value with_spread(const Value& value, const Spread& spread) {
  return {value.value, std::max(*value.error, spread.deviation), value.dimension};
}

nlohmann::ordered_json details(const Value& fitted, const Spread& spread, std::size_t variants) {
  nlohmann::ordered_json json;
  json["standard_error"] = *fitted.error;
  json["spread"] = {{"min", spread.least},
                    {"max", spread.greatest},
                    {"deviation", spread.deviation},
                    {"variants", variants}};
  return json;
}

std::size_t first_turn(const ForceCurve& curve) {
  return curve.cycles.empty() ? curve.force.size() - 1 : curve.cycles.front().turn;
}

}  // namespace

HertzData hertz_data(const ForceCurve& curve, const Radii& radii) {
  return {curve.distance, curve.force, first_turn(curve), curve.force_error, radii.value[0] / radii.value[1]};
}

ForceData force_data(const ForceCurve& curve, const Radii& radii) {
  return {curve.distance, curve.force, curve.force_error, first_turn(curve), radii.sum(), radii.reduced()};
}

HertzResult fit_hertz_with_spread(const HertzData& data, const HertzSettings& settings) {
  HertzResult result{fit_hertz(data, settings), {}, {}, {}};
  result.spread = hertz_spread(data, result.fit);
  result.modulus = with_spread(result.fit.modulus, result.spread.modulus);
  result.radius = with_spread(result.fit.radius, result.spread.radius);
  return result;
}

void require_known_ratio(const Run& run, const Table& motion, const Radii& radii) {
  const auto [a, b] = body_motion(motion, 0);
  if (radii.given) return;
  if (differ(a.mass, b.mass) || differ(radii.value[0], radii.value[1]))
    throw InputError(fmt::format("{}: the bodies differ (masses {:.6g} and {:.6g}, radii {:.6g} and "
                                 "{:.6g}); F(X) does not tell R1/R2: give --radius R1,R2",
                                 run.dump.string(), a.mass, b.mass, radii.value[0],
                                 radii.value[1]));
}

void add_hertz(Document& document, const Run& run, const HertzResult& hertz) {
  const HertzSettings& s = hertz.fit.settings;
  const std::size_t variants = hertz.spread.variants.size();
  document.number("E_star", hertz.modulus,
                  details(hertz.fit.modulus, hertz.spread.modulus, variants));
  document.number("R", hertz.radius, details(hertz.fit.radius, hertz.spread.radius, variants));
  document.line("errors", fmt::format("spread over {} choices of method, range and phase; E_star "
                                      "{:.4g} to {:.4g}, R {:.6g} to {:.6g}", variants,
                                      hertz.spread.modulus.least, hertz.spread.modulus.greatest,
                                      hertz.spread.radius.least, hertz.spread.radius.greatest));
  document.line("standard errors",
                fmt::format("{:.2g} and {:.2g}, correlation {:.3f}", *hertz.fit.modulus.error,
                            *hertz.fit.radius.error, hertz.fit.correlation));
  document.json("E_star_sqrt_R_star", {{"value", hertz.fit.strength}, {"error", hertz.fit.strength_error}});
  document.json("weights", s.weights == HertzWeights::errors ? "errors" : "equal");
  document.json("correlation", hertz.fit.correlation);
  document.text("method", std::string(name(s.method)));
  document.json("min_force_fraction", s.min_force_fraction);
  document.json("max_force_fraction", s.max_force_fraction);
  document.text("phase", std::string(name(s.phase)));
  document.json("loss", name(s.loss));
  document.json("points", hertz.fit.points.size());
  document.line("points", fmt::format("{} with {} <= F/F_max <= {}", hertz.fit.points.size(),
                                      s.min_force_fraction, s.max_force_fraction));
  document.json("rms_residual", hertz.fit.rms_residual);
  document.line("rms residual", fmt::format("{:.3g} of F_max", hertz.fit.rms_residual));
  document.json("digits", hertz.fit.fit.digits);
  document.line("digits of the optimum", fmt::format("{:.1f}", hertz.fit.fit.digits));
  document.json("condition", hertz.fit.fit.condition);
  document.json("fit_seconds", hertz.fit.fit.seconds);
  document.json("usable", hertz.fit.fit.usable);
  document.json("reason", hertz.fit.fit.reason);
  if (!hertz.fit.fit.usable) document.warn("the fit is not usable: " + hertz.fit.fit.reason);
  if (run.scene.interaction == Interaction::adhesive)
    document.warn("the scene is adhesive: Hertz's law has no adhesion, E_star and R describe the "
                  "repulsive part of the force only roughly");
}

double fitted_force(const HertzFit& fit, double distance) {
  const double overlap = std::max(0.0, 2 * fit.radius.value - distance);
  return 4.0 / 3.0 * fit.modulus.value * std::sqrt(0.5 * fit.radius.value) * overlap *
         std::sqrt(overlap);
}

Table hertz_table(const HertzResult& hertz, const ForceCurve& curve) {
  Table table({{"frame", dimension::none},
               {"X", dimension::length},
               {"F", dimension::force},
               {"F_fit", dimension::force},
               {"residual", dimension::force}});
  for (const std::size_t i : hertz.fit.points) {
    const double model = fitted_force(hertz.fit, curve.distance[i]);
    table.add_row(std::array{static_cast<double>(i), curve.distance[i], curve.force[i], model,
                             curve.force[i] - model});
  }
  return table;
}

}  // namespace mdana
