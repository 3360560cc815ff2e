// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fits/andrews_limits.hpp"
#include "fits/repeats.hpp"
#include "reports/collision_summary.hpp"
#include "reports/compression_study.hpp"
#include "reports/contact_fitted.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t pairs_told = 41;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Value value_of(const Estimate& estimate) {
  Value value{estimate.value, {}, dimension::pressure};
  if (std::isfinite(estimate.error)) value.error = estimate.error;
  return value;
}

void tell_lines(Document& document, const CompressionStudy& study) {
  Json all = Json::array();
  for (const RadiusLineAt& l : study.lines) {
    all.push_back({{"v", l.velocity}, {"runs", l.runs}, {"slope", to_json(l.line.slope)},
                   {"intercept", to_json(l.line.intercept)}, {"covariance", number(l.line.covariance)},
                   {"offset", to_json(l.line.offset)}});
    document.line(fmt::format("delta_max at v = {:.4g}", l.velocity),
                  fmt::format("({}) R_agg + ({}); offset {}", to_text(l.line.slope, document.units()),
                              to_text(l.line.intercept, document.units()), to_text(l.line.offset, document.units())));
  }
  document.json("radius_lines", std::move(all));
  document.number("offset", study.offset.value, {{"source", study.offset.source}});
  document.line("offset from", study.offset.source);
  if (study.lines.empty())
    document.left_out("delta_max against R_agg", "runs at one velocity with two radii and more are needed");
}

/// Mean, its error by the scatter of the runs, and that.
Json scatter_json(const Scatter& s) {
  return {{"value", number(s.mean)},
          {"error", number(s.deviation / std::sqrt(static_cast<double>(s.count)))},
          {"spread", number(s.deviation)}};
}

std::string scatter_text(const Scatter& s) {
  return s.count > 1 ? fmt::format("{:.5g} (spread {:.2g})", s.mean, s.deviation) : fmt::format("{:.5g}", s.mean);
}

/// The repeats of one radius and velocity.
class Condition {
 public:
  Condition(const CompressionStudy& study, const std::vector<std::size_t>& group) {
    for (const std::size_t k : group) {
      const std::size_t i = study.fitted[k];
      const Compressing& c = study.numbers[i];
      strain_.push_back(study.maximum(i).delta.value / c.effective_radius);
      if (!std::isnan(study.maximum(i).time.value)) time_.push_back(study.maximum(i).time.value);
      radius_.push_back(c.effective_radius);
      velocity_.push_back(c.impact.velocity);
      stuck_ += study.runs[i].curve.outcome == Outcome::stick;
      bounced_ += study.runs[i].curve.outcome == Outcome::bounce;
    }
  }

  void tell(Document& document, Json& all) const {
    const Scatter strain = scatter_of(strain_), time = scatter_of(time_);
    const double radius = scatter_of(radius_).mean, velocity = scatter_of(velocity_).mean;
    const BinomialShare p = wilson(stuck_, stuck_ + bounced_);
    all.push_back({{"R_eff", radius},
                   {"v", velocity},
                   {"runs", strain.count},
                   {"delta_max_over_R_eff", scatter_json(strain)},
                   {"t_max", scatter_json(time)},
                   {"stick", stuck_},
                   {"bounce", bounced_},
                   {"sticking_probability",
                    {{"value", number(p.value)}, {"low", number(p.low)}, {"high", number(p.high)}}}});
    document.line(fmt::format("R_eff {:.5g}, v {:.4g}", radius, velocity),
                  fmt::format("{} run{}: delta_max/R_eff {}, t_max {}; {} stick, {} bounce", strain.count,
                              strain.count == 1 ? "" : "s", scatter_text(strain), scatter_text(time), stuck_, bounced_));
  }

 private:
  std::vector<double> strain_, time_, radius_, velocity_;
  std::size_t stuck_ = 0, bounced_ = 0;
};

void tell_conditions(Document& document, const CompressionStudy& study) {
  Json all = Json::array();
  for (const auto& group : repeats_of(study.seen)) Condition(study, group).tell(document, all);
  document.json("conditions", std::move(all));
}

/// The pairs of the mean strain, if all runs have one velocity.
void tell_degeneracy(Document& document, const CompressionStudy& study) {
  std::vector<double> strain, velocity;
  for (const std::size_t i : study.fitted) {
    strain.push_back(study.maximum(i).delta.value / study.numbers[i].impact.radius);
    velocity.push_back(study.numbers[i].impact.velocity);
  }
  if (strain.empty() || std::ranges::max(velocity) > (1 + same_velocity_of_runs) * std::ranges::min(velocity)) return;
  const Scatter s = scatter_of(strain);
  Impact impact = study.numbers[study.fitted[0]].impact;
  impact.velocity = scatter_of(velocity).mean;
  Value delta{s.mean * impact.radius, {}, dimension::length};
  if (s.count > 1) delta.error = s.deviation / std::sqrt(static_cast<double>(s.count)) * impact.radius;
  add_degeneracy(document, impact, delta);
}

void tell_limit(Document& document, const std::string& limit, const std::string& parameter, const ContactFit& fit) {
  if (!fit.usable) return document.json(limit, {{parameter, nullptr}, {"chi2", nullptr}});
  document.number(limit + "." + parameter, value_of(fit.parameters[0]), {{"chi2", number(fit.chi2)}});
}

void tell_fit(Document& document, const CompressionStudy& study) {
  if (!study.fits) {
    document.warn("no E*, Y: " + study.no_fit);
    return document.left_out("E_star, Y", study.no_fit);
  }
  const auto& [both, counted, elastic, rigid_plastic] = *study.fits;
  for (const auto& [name, k] : {std::pair{"E_star", 0}, {"Y", 1}})
    if (both.usable)
      document.number(name, value_of(both.parameters[static_cast<std::size_t>(k)]));
    else
      document.json(name, nullptr);
  if (!both.usable) document.left_out("E_star, Y", both.reason);
  if (counted.usable) {
    document.number("with_counted_mass.E_star", value_of(counted.parameters[0]));
    document.number("with_counted_mass.Y", value_of(counted.parameters[1]));
  }
  tell_limit(document, "elastic_limit", "E_star", elastic);
  tell_limit(document, "rigid_plastic_limit", "Y", rigid_plastic);
  const CollisionLaw& law = *find_collision_law("andrews");
  ContactFitSettings settings;
  settings.free = usual_free_parameters(law);
  add_contact_fit(document, law, settings, study.seen, both);
}

/// A row a run of a study.
class RunTable {
 public:
  explicit RunTable(const CompressionStudy& study) : study_(study) {}

  /// `of` makes the value of the run with that index.
  template <class Of>
  void add(ColumnSpec spec, Of&& of) {
    std::vector<double> column;
    for (std::size_t i = 0; i < study_.runs.size(); ++i) column.push_back(of(i));
    table_.add_column(std::move(spec), std::move(column));
  }

  /// A value and its error.
  template <class Of>
  void add_value(const std::string& name, Dimension dimension, Of&& of) {
    add({name, dimension}, [&](std::size_t i) { return of(i).value; });
    add({name + "_error", dimension}, [&](std::size_t i) { return of(i).error.value_or(none); });
  }

  /// delta_max and t_max by a model of the impact.
  template <class Model>
  void add_model(const std::string& name, double modulus, Model&& model) {
    const auto by_model = [&](std::size_t i) {
      Impact impact = study_.numbers[i].impact;
      impact.modulus = modulus;
      return impact.velocity > 0 ? model(impact) : Compressed{none, none};
    };
    add({"delta_max_" + name, dimension::length}, [&](std::size_t i) { return by_model(i).delta_max; });
    add({"t_max_" + name, dimension::time}, [&](std::size_t i) { return by_model(i).t_max; });
  }

  Table take() { return std::move(table_); }

 private:
  const CompressionStudy& study_;
  Table table_;
};

void add_models(RunTable& table, const AndrewsFits& fits) {
  const double modulus = fits.both.parameters[0].value, strength = fits.both.parameters[1].value;
  table.add_model("fit", modulus, [&](const Impact& impact) {
    const Collision c = collide(*find_collision_law("andrews"), {impact, {strength}});
    return Compressed{c.delta_max, c.t_max};
  });
  table.add_model("elastic", modulus, elastic_limit);
  table.add_model("rigid_plastic", modulus, [&](const Impact& impact) { return rigid_plastic_limit(impact, strength); });
}

}  // namespace

void add_degeneracy(Document& document, const Impact& impact, const Value& delta_max) {
  if (!(delta_max.value > 0 && impact.velocity > 0)) return;
  const auto pairs = degenerate_pairs(impact, delta_max.value, pairs_told);
  Json modulus = Json::array(), strength = Json::array(), share = Json::array();
  for (const DegeneratePair& p : pairs) {
    modulus.push_back(number(p.modulus));
    strength.push_back(p.yield_strength);
    share.push_back(p.yield_share);
  }
  document.json("degeneracy", {{"v", impact.velocity}, {"delta_max_over_R_star", delta_max.value / impact.radius},
                               {"E_star", modulus}, {"Y", strength}, {"delta_Y_over_delta_max", share}});
  const double relative = delta_max.error ? *delta_max.error / delta_max.value : none;
  const auto add = [&](const char* name, double value, double power) {
    Value v{value, {}, dimension::pressure};
    if (delta_max.error) v.error = power * relative * value;
    document.number(name, v);
  };
  add("E_star_if_elastic", pairs.front().modulus, 2.5);
  add("Y_if_rigid_plastic", pairs.back().yield_strength, 2);
}

void add_compression_study(Document& document, const CompressionStudy& study) {
  document.set_units(study.runs.front().units);
  document.text("split", std::string(split_names[static_cast<std::size_t>(study.split)]));
  tell_lines(document, study);
  tell_conditions(document, study);
  document.json("errors_from", study.known_errors ? "the scatter of repeated runs, with the sampling of each"
                                              : "no repeated runs: not known");
  tell_degeneracy(document, study);
  tell_fit(document, study);
}

Table compression_study_table(const CompressionStudy& study) {
  std::vector<std::string> dumps;
  for (const CompressedRun& run : study.runs) dumps.push_back(run.dump);
  const auto& runs = study.runs;
  const auto& numbers = study.numbers;
  RunTable table(study);
  table.add({"dump", dimension::none, dumps}, [](std::size_t i) { return static_cast<double>(i); });
  table.add({"outcome", dimension::none, {"bounce", "stick", "unresolved"}},
            [&](std::size_t i) { return static_cast<double>(runs[i].curve.outcome); });
  table.add({"R_agg", dimension::length}, [&](std::size_t i) { return runs[i].radius(); });
  table.add({"R_eff", dimension::length}, [&](std::size_t i) { return numbers[i].effective_radius; });
  table.add({"v", dimension::velocity}, [&](std::size_t i) { return numbers[i].impact.velocity; });
  table.add({"delta_max", dimension::length},
            [&](std::size_t i) { return study.maximum(i).delta.value + 2 * study.offset.value.value; });
  table.add_value("delta_max_eff", dimension::length, [&](std::size_t i) { return study.maximum(i).delta; });
  table.add_value("t_max", dimension::time, [&](std::size_t i) { return study.maximum(i).time; });
  table.add({"e", dimension::none}, [&](std::size_t i) { return runs[i].restitution.e.value; });
  if (study.fits && study.fits->both.usable) add_models(table, *study.fits);
  return table.take();
}

}  // namespace mdana
