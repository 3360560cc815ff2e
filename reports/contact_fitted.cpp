// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/contact_fitted.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/residual_pattern.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json interval_json(const Interval& interval) {
  if (!interval.known()) return nullptr;
  return Json::array({number(interval.low), number(interval.high)});
}

std::string interval_text(const Interval& interval) {
  const auto end = [](double x) { return std::isfinite(x) ? fmt::format("{:.6g}", x) : std::string("no limit"); };
  return fmt::format("{} to {}", end(interval.low), end(interval.high));
}

void add_parameters(Document& document, const ContactFit& fit) {
  Json all = Json::object();
  for (const Estimate& p : fit.parameters) {
    Json json{{"value", number(p.value)}, {"error", number(p.error)}};
    json["interval"] = interval_json(p.profile);
    if (p.bootstrap.known()) json["bootstrap_interval"] = interval_json(p.bootstrap);
    if (p.radius) json["R"] = *p.radius;
    all[p.full_name()] = std::move(json);
    std::string text = to_text(Value{p.value, std::isfinite(p.error) ? std::optional(p.error) : std::nullopt,
                                     dimension::none}, Units::lj);
    if (p.profile.known()) text += ", " + interval_text(p.profile);
    if (p.bootstrap.known()) text += fmt::format(" (bootstrap {})", interval_text(p.bootstrap));
    document.line(p.full_name(), text);
  }
  document.json("parameters", std::move(all));
}

void add_correlation(Document& document, const ContactFit& fit) {
  Json json = Json::object();
  for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i)
    for (Eigen::Index j = 0; j < fit.correlation.cols(); ++j)
      json[fit.parameters[static_cast<std::size_t>(i)].full_name()]
          [fit.parameters[static_cast<std::size_t>(j)].full_name()] = number(fit.correlation(i, j));
  document.json("correlation", std::move(json));
}

void add_minima(Document& document, const ContactFit& fit) {
  Json all = Json::array();
  for (const ContactMinimum& m : fit.minima) {
    Json json{{"cost", number(m.cost)}, {"starts", m.starts}};
    for (std::size_t k = 0; k < m.values.size(); ++k)
      json["parameters"][fit.parameters[k].full_name()] = number(m.values[k]);
    all.push_back(std::move(json));
  }
  document.json("minima", std::move(all));
  if (fit.minima.size() > 1)
    document.line("minima", fmt::format("{}, the next with cost {:.6g}", fit.minima.size(), fit.minima[1].cost));
}

/// Least and greatest of a parameter over the collisions.
Json range_of(std::span<const ObservedCollision> seen, std::string_view name) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ObservedCollision& s : seen)
    if (const auto x = s.find(name)) low = std::min(low, *x), high = std::max(high, *x);
  return low <= high ? Json::array({low, high}) : Json(nullptr);
}

void add_data(Document& document, const ContactFitSettings& settings, std::span<const ObservedCollision> seen) {
  const auto stuck = std::ranges::count_if(seen, &ObservedCollision::stuck);
  std::size_t samples = 0;
  for (const ObservedCollision& s : seen) samples += s.motion.size();
  document.json("observations", seen.size());
  document.json("samples", samples);
  document.json("sticking", stuck);
  document.line("observations", samples > 0 ? fmt::format("{} motion{} of {} moments", seen.size(), seen.size() == 1 ? "" : "s", samples)
                                            : fmt::format("{}, {} of them stick", seen.size(), stuck));
  Json constants = Json::object(), range = Json::object();
  for (const NamedNumber& n : settings.constants) constants[n.name] = n.value;
  for (const char* name : {"R", "R1", "R2", "m", "rho", "E", "v", "gamma", "nu", "spacing"})
    if (Json r = range_of(seen, name); !r.is_null()) range[name] = std::move(r);
  document.json("constants", std::move(constants));
  document.json("range", std::move(range));
}

void add_scores(Document& document, const ContactFit& fit) {
  document.json("chi2", number(fit.chi2));
  document.json("residuals", fit.points.size());
  document.json("known_errors", fit.known_errors);
  document.json("aic", number(fit.aic));
  document.json("bic", number(fit.bic));
  document.json("residual_memory", number(fit.residual_memory));
  document.json("singular_values", fit.singular_values);
  document.json("weak_direction", fit.weak_direction);
  document.json("digits", number(fit.digits));
  document.json("collisions", fit.collisions);
  document.json("fit_seconds", fit.seconds);
  document.line("chi2", fmt::format("{:.6g} of {} residuals and {} parameters", fit.chi2, fit.points.size(),
                                    fit.parameters.size()));
  document.line("AIC, BIC", fmt::format("{:.6g}, {:.6g}", fit.aic, fit.bic));
  if (!fit.weak_direction.empty()) document.line("weak direction", fit.weak_direction);
  document.line("digits of the optimum", fmt::format("{:.1f}", fit.digits));
  document.line("solved", fmt::format("{} collisions in {:.2f} s", fit.collisions, fit.seconds));
}

/// The columns of one quantity: seen, error, fitted, residual.
struct Columns {
  SeenQuantity quantity;
  const char *name, *error, *fitted, *residual;
  Measured ObservedCollision::* seen;
  Dimension dimension;
};

const Columns quantities[] = {
    {SeenQuantity::e_squared, "e", "sigma", "e_fit", "residual", &ObservedCollision::e, dimension::none},
    {SeenQuantity::delta_max, "delta_max", "delta_max_error", "delta_max_fit", "delta_max_residual",
     &ObservedCollision::delta_max, dimension::length},
    {SeenQuantity::t_max, "t_max", "t_max_error", "t_max_fit", "t_max_residual", &ObservedCollision::t_max,
     dimension::time}};

void add_columns(Table& table, const Columns& c, std::span<const ObservedCollision> seen, const ContactFit& fit) {
  const std::vector<double> unknown(seen.size(), std::numeric_limits<double>::quiet_NaN());
  auto value = unknown, error = unknown, fitted = unknown, residual = unknown;
  for (std::size_t i = 0; i < seen.size(); ++i) value[i] = (seen[i].*c.seen).value, error[i] = (seen[i].*c.seen).error;
  for (const FittedPoint& p : fit.points) {
    if (p.quantity != c.quantity) continue;
    fitted[p.seen] = c.quantity == SeenQuantity::e_squared ? std::sqrt(std::max(0.0, p.predicted)) : p.predicted;
    residual[p.seen] = p.residual;
  }
  table.add_column({c.name, c.dimension}, value);
  table.add_column({c.error, c.dimension}, error);
  table.add_column({c.fitted, c.dimension}, fitted);
  table.add_column({c.residual, dimension::none}, residual);
}

/// A row a sample: run (its index), time, and what was seen and fitted of delta, v and F.
Table motion_fit_table(std::span<const ObservedCollision> seen, const ContactFit& fit) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<double>> columns(8);
  std::vector<std::size_t> first;  // row of each run
  for (std::size_t run = 0; run < seen.size(); ++run) {
    first.push_back(columns[0].size());
    for (const MotionSample& m : seen[run].motion) {
      const double row[] = {static_cast<double>(run), m.time, m.delta.value, unknown,
                            m.velocity.value, unknown, m.force.value, unknown};
      for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
    }
  }
  for (const FittedPoint& p : fit.points)
    if (p.quantity >= SeenQuantity::delta)
      columns[3 + 2 * (static_cast<std::size_t>(p.quantity) - static_cast<std::size_t>(SeenQuantity::delta))]
             [first[p.seen] + p.sample] = p.predicted;
  const ColumnSpec specs[] = {{"run", dimension::none}, {"time", dimension::time}, {"delta", dimension::length},
                              {"delta_fit", dimension::length}, {"v", dimension::velocity},
                              {"v_fit", dimension::velocity}, {"F", dimension::force}, {"F_fit", dimension::force}};
  Table table;
  for (std::size_t k = 0; k < columns.size(); ++k) table.add_column(specs[k], columns[k]);
  return table;
}

}  // namespace

void add_contact_fit(Document& document, const CollisionLaw& law, const ContactFitSettings& settings,
                     std::span<const ObservedCollision> seen, const ContactFit& fit) {
  document.text("law", std::string(law.name));
  add_data(document, settings, seen);
  add_parameters(document, fit);
  add_correlation(document, fit);
  add_minima(document, fit);
  if (!fit.points.empty()) add_scores(document, fit);
  const std::vector<std::string> pattern = describe_residuals(seen, fit.points);
  document.json("residual_pattern", pattern);
  for (const std::string& line : pattern) document.line("residuals", line);
  if (fit.draws > 0) document.json("draws", fit.draws);
  document.json("usable", fit.usable);
  document.json("reason", fit.reason);
  for (const std::string& note : fit.notes) document.warn(note);
  if (fit.residual_memory > 1.5)
    document.warn(fmt::format("residuals of neighbouring moments, and of delta, v and F, are alike, as those of {:.2g} times "
                              "fewer independent ones: errors and AIC count with that; where the law is wrong they say "
                              "nothing of it", fit.residual_memory));
  if (!fit.known_errors)
    document.warn("no standard errors are given: those of the parameters, AIC and BIC take the scatter about "
                  "the fit for the error");
  if (!fit.usable) document.warn("the fit is not usable: " + fit.reason);
}

Table contact_fit_table(std::span<const ObservedCollision> seen, const ContactFit& fit) {
  if (std::ranges::any_of(seen, [](const ObservedCollision& s) { return !s.motion.empty(); }))
    return motion_fit_table(seen, fit);
  Table table;
  for (const auto& [name, dimension] : {std::pair{"R", dimension::length}, {"v", dimension::velocity}}) {
    std::vector<double> column;
    for (const ObservedCollision& s : seen)
      column.push_back(s.find(name).value_or(std::numeric_limits<double>::quiet_NaN()));
    table.add_column({name, dimension}, column);
  }
  for (const Columns& c : quantities)
    if (c.quantity == SeenQuantity::e_squared ||
        std::ranges::any_of(seen, [&](const ObservedCollision& s) { return (s.*c.seen).known(); }))
      add_columns(table, c, seen, fit);
  return table;
}

}  // namespace mdana
