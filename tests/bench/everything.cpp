// SPDX-License-Identifier: GPL-3.0-or-later
// Reads every column of a dump and makes every analysis of this build of it, whether the scene calls for it or not: what
// tests/bench/left_out.py compares plans with.
#include <algorithm>
#include <cstdio>
#include <thread>

#include "analyses/defects.hpp"
#include "analyses/far_side.hpp"
#include "analyses/motion.hpp"
#include "readers/input_error.hpp"
#include "reports/run.hpp"

namespace mdana {
namespace {

class Nothing final : public Partial {
 public:
  void add(const LabelledBlock&) override {}
  void merge(const Partial&) override {}
  void pass(Parcel&) override {}
  void close(std::span<double>) const override {}
};

/// Asks for all columns of the dump, and does nothing with them.
class AllColumns final : public Analysis {
 public:
  explicit AllColumns(const FrameHeader& first) {
    for (const std::string& name : first.columns) needs_.columns.add(name);
  }
  Needs needs() const override { return needs_; }
  std::vector<ColumnSpec> columns() const override { return {}; }
  std::unique_ptr<Partial> begin(const FrameContext&) const override { return std::make_unique<Nothing>(); }

 private:
  Needs needs_;
};

/// Whether the dump has what it needs.
bool possible(const Analysis& analysis, const FrameHeader& first) {
  return std::ranges::all_of(analysis.needs().columns.names(), [&](const std::string& name) {
    return name == "x" || name == "y" || name == "z" || first.has_column(name);
  });
}

std::vector<std::unique_ptr<Analysis>> everything(const Run& run) {
  std::vector<std::unique_ptr<Analysis>> all;
  all.push_back(make_motion({run.first.has_column("vx"), run.first.has_column("fx")}));
  all.push_back(std::make_unique<AllColumns>(run.first));
  all.push_back(make_far_side());
  for (const AnalysisMember* member : analysis_members()) {
    if (member->name == "motion" || member->name == "defects") continue;
    try {
      auto analysis = member->make({run.scene, run.first});
      if (possible(*analysis, run.first)) all.push_back(std::move(analysis));
    } catch (const InputError&) {  // it cannot be made of this dump at all
    }
  }
  DefectSettings lattice;
  lattice.ids = run.first.has_column("id");
  lattice.surface = lattice.lines = true;
  all.push_back(make_defects(std::move(lattice)));
  return all;
}

int run_all(const char* dump, const char* scene) {
  RunOptions options;
  options.dump = dump;
  options.scene = scene;
  const Run run = prepare_run(options);
  SweepOptions sweeping;
  sweeping.threads = std::max(1u, std::thread::hardware_concurrency());
  const auto analyses = everything(run);
  const SweepResult swept = sweep(run.dump, run.bodies, run.masses, analyses, sweeping);
  std::printf("{\"frames\": %zu, \"columns\": %zu, \"analyses\": %zu, \"seconds\": %g}\n", swept.steps.size(),
              run.first.columns.size(), analyses.size() - 1, swept.seconds);
  return 0;
}

}  // namespace
}  // namespace mdana

int main(int argc, char** argv) {
  if (argc == 3) return mdana::run_all(argv[1], argv[2]);
  std::fprintf(stderr, "usage: everything DUMP SCENE\n");
  return 2;
}
