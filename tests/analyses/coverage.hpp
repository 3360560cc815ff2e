// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <map>
#include <optional>

#include "analyses/restitution.hpp"
#include "tests/analyses/known_motions.hpp"

namespace mdana::test {

/// How often twice a stated error holds the truth.
struct Coverage {
  long seen = 0, held = 0, unstated = 0;

  void add(const Value& value, double truth, double scale) {
    if (std::isnan(value.value)) return;
    if (!value.error) return void(++unstated);
    ++seen;
    held += std::abs(value.value - truth) <= 2 * *value.error + 1e-9 * scale;
  }
  double share() const { return seen == 0 ? 1 : static_cast<double>(held) / static_cast<double>(seen); }
};

/// By number, and by the motion or the sampling that it was seen in.
using CoverageTable = std::map<std::string, std::map<std::string, Coverage>>;

inline std::string text_of(const Sampling& s) {
  char text[80];
  std::snprintf(text, sizeof text, "%s, %g frames, noise %g%s", std::string(name(s.source)).c_str(), s.frames, s.noise,
                s.told ? "" : " not told");
  return text;
}

/// One dump of one motion; each number counts in the row of the motion and in that of the sampling.
inline void judge(const KnownMotion& known, const Sampling& sampling, std::mt19937_64& random, CoverageTable& table) {
  const RelativeMotion motion = dumped(known, sampling, random);
  const ForceCurve curve = force_curve(motion, sampling.source, Units::lj, 20);
  if (!curve.contact) return;
  const auto add = [&](const char* what, const Value& value, double truth, double scale) {
    for (const std::string& row : {std::string("all"), known.name, text_of(sampling)}) table[what][row].add(value, truth, scale);
  };
  const double force = known.greatest_force(known.path.size() - 1), energy = 0.5 * known.mass * known.path[0].speed * known.path[0].speed;
  add("F_max", curve.force_max, force, force);
  add("F_min_loading", curve.force_min_loading, known.least_force(known.turn()), force);
  add("delta_max", curve.delta_max, known.delta_max(), known.delta_max());
  for (std::size_t i = 0; i < curve.force.size(); ++i)
    if (std::abs(curve.force[i]) > 0.05 * force && !std::isnan(curve.force_error[i])) {
      const double truth = known.force(static_cast<std::size_t>(std::lround(motion.times[i] / known.dt)));
      add("F", {curve.force[i], curve.force_error[i], dimension::force}, truth, force);
    }
  if (curve.loops.empty()) return;
  const double low = curve.loops[0].low;
  if (low < std::max(known.path.front().delta, known.path.back().delta) || low > 0.9 * known.delta_max()) return;
  add("hysteresis_area", curve.hysteresis_area, known.loss(low), energy);
  add("kinetic_loss", curve.kinetic_loss, known.loss(low), energy);
  const Restitution r = restitution(motion, curve);
  if (curve.outcome == Outcome::bounce)
    add("e", r.e, -known.path.back().speed / known.path.front().speed, 1);
}

inline CoverageTable coverage(int draws, std::uint64_t seed) {
  CoverageTable table;
  std::mt19937_64 random(seed);
  const std::vector<KnownMotion> motions = known_motions();
  for (const KnownMotion& known : motions)
    for (const ForceSource source : {ForceSource::forces, ForceSource::velocities, ForceSource::positions})
      for (const double frames : {16.0, 32.0, 64.0, 128.0})
        for (const double noise : {0.0, 1e-6, 1e-4, 1e-3})
          for (const bool told : {true, false})
            for (int k = 0; k < draws; ++k) judge(known, {source, frames, noise, told}, random, table);
  return table;
}

inline void print(const CoverageTable& table) {
  for (const auto& [what, rows] : table)
    for (const auto& [row, c] : rows)
      std::printf("%-16s %-50s %6ld %6.1f %% held, %ld without an error\n", what.c_str(), row.c_str(), c.seen, 100 * c.share(), c.unstated);
}

}  // namespace mdana::test
