// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/compression_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/andrews_limits.hpp"
#include "fits/repeats.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double same_density = 0.03;  ///< relative: aggregates of one filling factor
constexpr double significant = 2;      ///< standard errors by which an offset must differ from zero
constexpr double rounding = 1e-12;     ///< relative: least error of an offset, of points exactly on a line

Measured measured(const Value& value) {
  Measured m{value.value};
  if (value.error && *value.error > 0) m.error = *value.error;
  return m;
}

/// A run as fits see it. Two equal spheres with the R* and m* of the pair.
ObservedCollision observed(const CompressedRun& run, const Compressing& c, const Value& delta_max, const Value& t_max) {
  ObservedCollision seen;
  seen.given = {{"R", 2 * c.impact.radius}, {"m", 2 * c.impact.mass}, {"v", c.impact.velocity}};
  seen.delta_max = measured(delta_max);
  seen.t_max = measured(t_max);
  seen.place = run.dump;
  return seen;
}

/// Runs of one velocity, whatever the radius.
std::vector<std::vector<std::size_t>> by_velocity(std::span<const ObservedCollision> seen) {
  std::vector<ObservedCollision> alike(seen.begin(), seen.end());
  for (ObservedCollision& s : alike) s.given = {{"R", 1}, {"v", *s.find("v")}};
  return repeats_of(alike);
}

std::optional<RadiusLineAt> line_of(std::span<const ObservedCollision> seen, const std::vector<std::size_t>& group) {
  std::vector<double> radius, delta, errors;
  double velocity = 0;
  for (const std::size_t i : group) {
    radius.push_back(*seen[i].find("R"));
    delta.push_back(seen[i].delta_max.value);
    if (seen[i].delta_max.error > 0) errors.push_back(seen[i].delta_max.error);
    velocity += *seen[i].find("v") / static_cast<double>(group.size());
  }
  const auto [least, greatest] = std::ranges::minmax(radius);
  if (greatest - least <= same_radius_of_runs * greatest) return std::nullopt;
  if (errors.size() < radius.size()) errors.clear();
  return RadiusLineAt{velocity, group.size(), fit_radius_line(radius, delta, errors)};
}

/// delta_max from 2 R_agg against R_agg at each velocity.
std::vector<RadiusLineAt> lines_of(const CompressionStudy& study) {
  std::vector<ObservedCollision> seen;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const Value& delta = study.maximum(i).delta;
    if (std::isnan(delta.value) || !(study.numbers[i].impact.velocity > 0)) continue;
    seen.push_back(observed(study.runs[i], study.numbers[i], delta, {}));
    seen.back().given[0].value = study.runs[i].radius();
  }
  set_errors_by_repeats(seen);
  std::vector<RadiusLineAt> lines;
  for (const auto& group : by_velocity(seen))
    if (const auto line = line_of(seen, group)) lines.push_back(*line);
  return lines;
}

/// Mean of the offsets, weighted by their errors; none that is not told from zero.
SurfaceOffset offset_of(const std::vector<RadiusLineAt>& lines) {
  double sum = 0, weights = 0;
  for (const RadiusLineAt& l : lines) {
    const Value& offset = l.line.offset;
    if (!offset.error) continue;
    const double error = std::max(*offset.error, rounding * std::abs(offset.value));
    sum += offset.value / (error * error);
    weights += 1 / (error * error);
  }
  SurfaceOffset none;
  if (!(weights > 0)) return none;
  const Value mean{sum / weights, 1 / std::sqrt(weights), dimension::length};
  if (std::abs(mean.value) > significant * *mean.error) return {mean, "delta_max against R_agg of these runs"};
  none.source = fmt::format("none: t_max counts from X = 2 R_agg, since delta_max against R_agg does not tell the offset "
                            "({:.3g} with a standard error of {:.3g})", mean.value, *mean.error);
  return none;
}

void require_one_system(const std::vector<CompressedRun>& runs) {
  for (const CompressedRun& run : runs)
    if (run.units != runs.front().units)
      throw InputError(fmt::format("{} has units {}, {} has {}: give runs of one system of units", run.dump, name(run.units),
                                   runs.front().dump, name(runs.front().units)));
}

void set_numbers(CompressionStudy& study) {
  study.numbers.clear();
  for (const CompressedRun& run : study.runs) study.numbers.push_back(compressing(run, study.offset));
}

void collect(CompressionStudy& study) {
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const MaximumCompression& m = study.maximum(i);
    if (std::isnan(m.delta.value) || !(study.numbers[i].impact.velocity > 0)) continue;
    study.fitted.push_back(i);
    study.seen.push_back(observed(study.runs[i], study.numbers[i], m.delta, m.time));
  }
  if (!study.seen.empty()) study.known_errors = set_errors_by_repeats(study.seen);
}

/// Why E* and Y are not even looked for; empty if they are.
std::string obstacle(const CompressionStudy& study) {
  if (study.seen.size() < 2)
    return "fewer than two runs tell delta_max and v; runs at several velocities across v_Y are needed";
  std::vector<double> density;
  for (const std::size_t i : study.fitted) density.push_back(study.numbers[i].density);
  const auto [least, greatest] = std::ranges::minmax(density);
  if (greatest > (1 + same_density) * least)
    return fmt::format("the aggregates' densities go from {:g} to {:g}: E* and Y depend on the filling factor; give "
                       "runs of one at a time", least, greatest);
  return find_collision_law("andrews") ? "" : "this build has no law andrews";
}

ContactFit fit_of(const std::vector<ObservedCollision>& seen, std::vector<FreeParameter> free,
                  std::vector<NamedNumber> constants = {}) {
  ContactFitSettings settings;
  settings.free = std::move(free);
  settings.constants = std::move(constants);
  return fit_contact(*find_collision_law("andrews"), seen, settings);
}

/// The pairs of the first run: elastic, and rigid plastic.
std::array<DegeneratePair, 2> limits_of(const CompressionStudy& study) {
  const std::size_t i = study.fitted.front();
  const auto pairs = degenerate_pairs(study.numbers[i].impact, study.maximum(i).delta.value, 3);
  return {pairs.front(), pairs.back()};
}

void fit(CompressionStudy& study) {
  constexpr double infinite = 1e8;  ///< in moduli of an elastic run, which differ from run to run
  study.no_fit = obstacle(study);
  if (!study.no_fit.empty()) return;
  std::vector<ObservedCollision> counted = study.seen;
  for (std::size_t k = 0; k < counted.size(); ++k)
    counted[k].given[1].value = 2 * study.numbers[study.fitted[k]].counted_mass;
  const auto both = usual_free_parameters(*find_collision_law("andrews"));
  const auto [elastic, plastic] = limits_of(study);
  const double stiff = infinite * elastic.modulus;
  study.fits = {fit_of(study.seen, both), fit_of(counted, both),
                fit_of(study.seen, {{"E", elastic.modulus}}, {{"Y", stiff}}),
                fit_of(study.seen, {{"Y", plastic.yield_strength}}, {{"E", stiff}})};
}

}  // namespace

bool CompressionStudy::fit_failed() const {
  return fits && !fits->both.usable && by_velocity(seen).size() > 1;
}

CompressionStudy study_compression(std::vector<CompressedRun> runs, Split split,
                                   const std::optional<SurfaceOffset>& offset) {
  CompressionStudy study;
  study.split = split;
  study.runs = std::move(runs);
  require_one_system(study.runs);
  set_numbers(study);
  study.lines = lines_of(study);
  if (offset)
    study.offset = *offset;
  else
    study.offset = offset_of(study.lines);
  set_numbers(study);
  collect(study);
  fit(study);
  return study;
}

}  // namespace mdana
