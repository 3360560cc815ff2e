// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/collision_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

namespace mdana {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double z_95 = 1.959963984540054;  // two-sided 95 % of the normal distribution

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sample standard deviation about the mean; NaN of less than two.
double deviation(std::span<const double> values) {
  if (values.size() < 2) return none;
  const double middle = mean(values);
  double squares = 0;
  for (const double v : values) squares += (v - middle) * (v - middle);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

std::size_t count(std::span<const SeriesOutcome> outcomes, Outcome which) {
  return static_cast<std::size_t>(
      std::ranges::count_if(outcomes, [&](const SeriesOutcome& o) { return o.outcome == which; }));
}

std::size_t failed(std::span<const SeriesOutcome> outcomes) {
  return static_cast<std::size_t>(
      std::ranges::count_if(outcomes, [](const SeriesOutcome& o) { return !o.failure.empty(); }));
}

/// e of the runs where it is determined; of those that bounce, or of those that stick too.
std::vector<double> restitutions(std::span<const SeriesOutcome> outcomes, bool sticking) {
  std::vector<double> all;
  for (const SeriesOutcome& o : outcomes) {
    const bool counts = o.outcome == Outcome::bounce || (sticking && o.outcome == Outcome::stick);
    if (counts && !std::isnan(o.e.value)) all.push_back(o.e.value);
  }
  return all;
}

void add_restitution_of(Document& document, const std::string& name,
                        const std::vector<double>& values) {
  const RootMeanSquare e = root_mean_square(values);
  document.number("summary." + name, e.value, {{"spread", e.spread}, {"runs", e.count}});
}

}  // namespace

BinomialShare wilson(std::size_t successes, std::size_t trials) {
  if (trials == 0) return {none, none, none};
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n, z2 = z_95 * z_95 / n;
  const double centre = (p + z2 / 2) / (1 + z2);
  const double half = std::sqrt(z2 * (p * (1 - p) + z2 / 4)) / (1 + z2);
  return {p, successes == 0 ? 0 : centre - half, successes == trials ? 1 : centre + half};
}

RootMeanSquare root_mean_square(std::span<const double> values) {
  RootMeanSquare result{{none, {}, dimension::none}, deviation(values), values.size()};
  if (values.empty()) return result;
  std::vector<double> squares;
  for (const double v : values) squares.push_back(v * v);
  result.value.value = std::sqrt(mean(squares));
  if (values.size() > 1 && result.value.value > 0)
    result.value.error = deviation(squares) / std::sqrt(static_cast<double>(values.size())) /
                         (2 * result.value.value);
  return result;
}

void add_summary(Document& document, std::span<const SeriesOutcome> outcomes) {
  const std::size_t bounced = count(outcomes, Outcome::bounce);
  const std::size_t stuck = count(outcomes, Outcome::stick);
  const std::size_t unresolved = count(outcomes, Outcome::unresolved), broken = failed(outcomes);
  document.json("summary.runs", outcomes.size());
  document.json("summary.bounce", bounced);
  document.json("summary.stick", stuck);
  document.json("summary.unresolved", unresolved);
  document.json("summary.failed", broken);
  document.line("runs", fmt::format("{}: {} bounce, {} stick, {} unresolved, {} failed",
                                    outcomes.size(), bounced, stuck, unresolved, broken));
  const BinomialShare p = wilson(stuck, stuck + bounced);
  document.json("summary.sticking_probability", {{"value", p.value},
                                                 {"error", 0.5 * (p.high - p.low) / z_95},
                                                 {"low", p.low},
                                                 {"high", p.high},
                                                 {"interval", "Wilson, 95 %"}});
  document.line("sticking probability",
                stuck + bounced == 0 ? "not determined"
                                     : fmt::format("{:.3g} ({:.3g} to {:.3g} at 95 %, Wilson)", p.value, p.low, p.high));
  add_restitution_of(document, "e_rms", restitutions(outcomes, true));
  add_restitution_of(document, "e_rms_bouncing", restitutions(outcomes, false));
}

Table outcome_table(std::span<const SeriesOutcome> outcomes) {
  Table table;
  std::vector<std::string> dumps;
  std::vector<double> index, outcome, e, error, total, speed;
  for (const SeriesOutcome& o : outcomes) {
    index.push_back(static_cast<double>(dumps.size()));
    dumps.push_back(o.dump);
    outcome.push_back(o.outcome ? static_cast<double>(*o.outcome) : 3);
    e.push_back(o.e.value);
    error.push_back(o.e.error.value_or(none));
    total.push_back(o.e_total.value);
    speed.push_back(o.speed_before.value);
  }
  table.add_column({"dump", dimension::none, std::move(dumps)}, std::move(index));
  table.add_column({"outcome", dimension::none, {"bounce", "stick", "unresolved", "failed"}},
                   std::move(outcome));
  table.add_column({"e", dimension::none}, std::move(e));
  table.add_column({"e_error", dimension::none}, std::move(error));
  table.add_column({"e_total", dimension::none}, std::move(total));
  table.add_column({"speed_before", dimension::velocity}, std::move(speed));
  return table;
}

}  // namespace mdana
