// SPDX-License-Identifier: GPL-3.0-or-later
// Collisions by law and tolerance, with the check of the error, on one core.
// tests/bench/collisions.py sets errors and times beside those of SciPy's integrators.
#include <cmath>

#include <benchmark/benchmark.h>

#include "fits/collision_law.hpp"

namespace mdana {
namespace {

struct Example {
  const char* law;
  std::vector<NamedValue> parameters;
};

/// P1's best fits for R = 147.
const std::vector<Example>& examples() {
  static const std::vector<Example> all{
      {"jkr", {{"gamma", "3.17"}}},
      {"viscous-hertz", {{"nu", "0.25"}, {"T_vis", "0.075"}}},
      {"power", {{"gamma", "3.17"}, {"D", "118"}, {"alpha", "3"}, {"beta", "1.5"}}},
      {"krijt", {{"gamma", "3.17"}, {"nu", "0.25"}, {"T_vis", "0.075"}}},
      {"stress",
       {{"gamma", "3.17"}, {"nu", "0.25"}, {"C", "2.1e-4"}, {"B", "6.2"}, {"zeta", "4"}}}};
  return all;
}

void collision(benchmark::State& state, const Example& example, bool sensitivities) {
  const CollisionLaw* law = find_collision_law(example.law);
  if (!law) return state.SkipWithError("not in this build");
  std::vector<NamedValue> given = example.parameters;
  for (const auto& [name, value] :
       {std::pair{"R", "147"}, {"m", "14434147"}, {"E", "65.5"}, {"v", "0.1"}})
    given.push_back({name, value});
  const CollisionInput input = collision_input(*law, given);
  CollisionSettings settings;
  settings.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  settings.sensitivities = sensitivities;
  Collision c;
  for (auto _ : state) benchmark::DoNotOptimize(c = collide(*law, input, settings));
  state.counters["evaluations"] = static_cast<double>(c.evaluations);
  state.counters["stated_error"] = c.e_error;
}

const bool registered = [] {
  for (const Example& example : examples())
    for (const bool sensitivities : {false, true})
      benchmark::RegisterBenchmark(
          (std::string(example.law) + (sensitivities ? "_sensitivities" : "")).c_str(),
          [&example, sensitivities](benchmark::State& state) {
            collision(state, example, sensitivities);
          })
          ->DenseRange(4, 12, 2);
  return true;
}();

}  // namespace
}  // namespace mdana

BENCHMARK_MAIN();
