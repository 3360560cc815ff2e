// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/states.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include "readers/file_set.hpp"
#include "readers/input_error.hpp"
#include "reports/study/plan.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

constexpr double same_radius = 0.01;  ///< relative

void add_files(const fs::path& name, FileHashes& hashes, std::vector<InputRecord>& files) {
  const auto set = find_file_set(name);
  if (!set) return files.push_back(hashes.record(name));
  for (const auto& pieces : *set)
    for (const fs::path& piece : pieces) files.push_back(hashes.record(piece));
}

void open(StudyRun& run, const StudySettings& settings) try {
  const PlannedRun& plan = *run.plan;
  run.scene = load_scene(plan.scene);
  if (run.scene.dump.empty()) throw InputError(fmt::format("{}: the scene names no dump", plan.scene.string()));
  run.task = {plan.name, plan.scene, plan.scene.parent_path() / run.scene.dump, plan.log, plan.frames,
              settings.accuracy, settings.stability, settings.defects, settings.draws("snapshots"), {}, {}};
} catch (const InputError& error) {
  run.state = RunState::failed;
  run.why = error.what();
}

void hash_files(StudyRun& run, FileHashes& hashes) try {
  if (run.hashed) return;
  run.task.files.push_back(hashes.record(run.task.scene));
  add_files(run.task.dump, hashes, run.task.files);
  if (!run.task.log.empty()) run.task.files.push_back(hashes.record(run.task.log));
  run.hashed = true;
} catch (const InputError& error) {
  run.state = RunState::failed;
  run.why = error.what();
}

bool same_radii(const Scene& a, const Scene& b) {
  if (a.radii.size() != 2 || b.radii.size() != 2) return false;
  return std::abs(a.radii[0] - b.radii[0]) <= same_radius * b.radii[0] &&
         std::abs(a.radii[1] - b.radii[1]) <= same_radius * b.radii[1];
}

std::vector<std::size_t> partners_of(const std::vector<StudyRun>& runs, std::size_t index) {
  std::vector<std::size_t> partners;
  const Scene& scene = runs[index].scene;
  if (scene.interaction == Interaction::hertz || scene.interaction == Interaction::aggregate) return partners;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (runs[k].state != RunState::failed && runs[k].scene.interaction == Interaction::hertz &&
        same_radii(runs[k].scene, scene) && (!scene.units || !runs[k].scene.units || *scene.units == *runs[k].scene.units))
      partners.push_back(k);
  return partners;
}

/// E* and R of a Hertz run, if its fit is usable.
std::optional<Companion> companion_of(const StudyRun& run, const RunCache& cache) {
  const RunRecord record = cache.load(run.file);
  const Value *modulus = record.number("E_star"), *radius = record.number("R");
  if (!modulus || !radius || !record.document.value("usable", false)) return std::nullopt;
  return Companion{run.plan->name, record.document.value("units", ""), *modulus, *radius};
}

bool wanted(const std::string& name, const std::string& only) {
  return only.empty() || ::fnmatch(only.c_str(), name.c_str(), 0) == 0;
}

/// Settles runs, those that others wait for first.
class Settling {
 public:
  Settling(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes)
      : runs_(runs), cache_(cache), hashes_(hashes) {}

  void settle(StudyRun& run) {
    if (run.state == RunState::failed || run.state == RunState::elsewhere || run.done()) return;
    hash_files(run, hashes_);
    if (run.state == RunState::failed || !choose_companion(run)) return;
    const auto key = key_of(run.task);
    cache_.adopt(run.file, key);
    const auto known = cache_.key(run.file);
    const std::string changed = known ? difference(*known, key) : "no result yet";
    if (changed.empty())
      run.state = RunState::cached;
    else if (run.state != RunState::left_out)
      run.state = RunState::to_run;
    run.why = run.state == RunState::left_out ? fmt::format("not asked for by --only ({})", changed) : changed;
  }

 private:
  /// False if it waits for one that is to be run.
  bool choose_companion(StudyRun& run) {
    run.task.companion.reset();
    for (const std::size_t k : run.partners) {
      StudyRun& partner = runs_[k];
      if (run.task.companion) return true;
      if (run.state != RunState::left_out) ask_for(partner);
      if (partner.done()) {
        run.task.companion = companion_of(partner, cache_);
      } else if (partner.state == RunState::to_run && run.state != RunState::left_out) {
        run.state = RunState::waiting;
        run.why = "after " + partner.plan->name + ", whose E* and R it takes";
        return false;
      }
    }
    return true;
  }

  /// Of a run that another needs.
  void ask_for(StudyRun& run) {
    if (run.state != RunState::left_out && run.state != RunState::elsewhere) return;
    run.state = RunState::to_run;
    settle(run);
  }

  std::vector<StudyRun>& runs_;
  RunCache& cache_;
  FileHashes& hashes_;
};

}  // namespace

std::vector<StudyRun> open_runs(const StudyPlan& plan, const std::string& only) {
  const std::vector<std::string> files = file_names(plan);
  std::vector<StudyRun> runs(plan.runs.size());
  std::vector<std::string> names;
  bool any = false;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].plan = &plan.runs[k];
    runs[k].file = files[k];
    names.push_back(plan.runs[k].name);
    any = any || wanted(plan.runs[k].name, only);
  }
  if (!any) throw InputError(fmt::format("--only {}: no run is called so; there are {}", only, fmt::join(names, ", ")));
  for (StudyRun& run : runs) open(run, plan.settings);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].partners = partners_of(runs, k);
    if (runs[k].state == RunState::to_run && !wanted(runs[k].plan->name, only)) runs[k].state = RunState::left_out;
  }
  return runs;
}

void settle(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes) {
  Settling settling(runs, cache, hashes);
  for (const bool alone : {true, false})  // partners before those that take their E* and R
    for (StudyRun& run : runs)
      if (run.partners.empty() == alone) settling.settle(run);
}

}  // namespace mdana
