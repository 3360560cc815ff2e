// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of a hot fcc ball: seconds an atom of each kernel, of the cells, and of the whole analysis.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "analyses/defects.hpp"
#include "analyses/defects/cell_grid.hpp"
#include "analyses/defects/spacing.hpp"
#include "analyses/defects/structure_kernel.hpp"

namespace mdana::defects {
namespace {

/// About a million atoms, neighbours 1 apart.
std::shared_ptr<const FrameAtoms> ball(double noise) {
  const auto atoms = std::make_shared<FrameAtoms>();
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0, 1);
  constexpr int n = 55;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k) {
        if ((i + j + k) % 2 != 0 || i * i + j * j + k * k > n * n) continue;
        atoms->x.push_back(i / std::sqrt(2.0) + noise * normal(random));
        atoms->y.push_back(j / std::sqrt(2.0) + noise * normal(random));
        atoms->z.push_back(k / std::sqrt(2.0) + noise * normal(random));
        atoms->body.push_back(1);
      }
  return atoms;
}

void per_atom(benchmark::State& state, std::size_t atoms) {
  state.counters["atom"] = benchmark::Counter(
      static_cast<double>(atoms),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

double noise_of(const benchmark::State& state) { return 0.01 * static_cast<double>(state.range(0)); }

void kernel(benchmark::State& state, const StructureKernel& kernel) {
  const auto atoms = ball(noise_of(state));
  const CellGrid grid(*atoms, 1);
  std::vector<std::uint8_t> labels(atoms->size());
  for (auto _ : state) kernel.label(grid, 0, grid.cells(), labels.data(), nullptr);
  per_atom(state, atoms->size());
}

void cells(benchmark::State& state) {
  const auto atoms = ball(noise_of(state));
  for (auto _ : state)
    benchmark::DoNotOptimize(CellGrid(*atoms, nearest_neighbour_spacing(FrameStore(atoms), 1)).cells());
  per_atom(state, atoms->size());
}

void whole_analysis(benchmark::State& state) {
  const auto atoms = ball(noise_of(state));
  const auto analysis = make_defects();
  std::vector<double> row(analysis->columns().size());
  for (auto _ : state) dynamic_cast<const FrameAnalysis&>(*analysis).look({}, FrameStore(atoms), 1, row);
  per_atom(state, atoms->size());
}

}  // namespace
}  // namespace mdana::defects

int main(int argc, char** argv) {
  using namespace mdana::defects;
  benchmark::Initialize(&argc, argv);
  const auto add = [](const std::string& name, auto&&... work) {
    benchmark::RegisterBenchmark(name.c_str(), work...)->Arg(0)->Arg(5)->Unit(benchmark::kMillisecond);
  };
  for (const StructureKernel* k : structure_kernels())
    if (k->supported())
      add("kernel " + std::string(k->name), [k](benchmark::State& state) { kernel(state, *k); });
  add("spacing and cells", cells);
  add("whole analysis", whole_analysis);
  benchmark::RunSpecifiedBenchmarks();
}
