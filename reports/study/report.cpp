// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "reports/study/finish.hpp"
#include "reports/study/runner.hpp"
#include "reports/study/shards.hpp"
#include "reports/study/working_directory.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

/// All files that the report was made from.
std::vector<InputRecord> inputs_of(const StudyPlan& plan, const std::vector<StudyRun>& runs) {
  std::vector<InputRecord> inputs;
  if (!plan.file.empty()) inputs.push_back(input_record(plan.file.filename()));
  for (const StudyRun& run : runs)
    if (run.done())
      for (const InputRecord& file : run.task.files)
        if (std::ranges::find(inputs, file.path, &InputRecord::path) == inputs.end()) inputs.push_back(file);
  return inputs;
}

const char* in_words(RunState state) {
  switch (state) {
    case RunState::cached: return "cached";
    case RunState::to_run: return "to run";
    case RunState::waiting: return "to run if changed";
    case RunState::failed: return "fails";
    case RunState::left_out:
    case RunState::elsewhere: break;
  }
  return "left out";
}

RunOutlook outlook_of(const StudyRun& run) {
  RunOutlook outlook;
  outlook.name = run.plan->name;
  outlook.state = fmt::format("{}{}{}", in_words(run.state), run.why.empty() ? "" : ": ", run.why);
  outlook.cached = run.done();
  if (run.state == RunState::failed) return outlook;
  outlook.options.dump = fs::absolute(run.task.dump);
  outlook.options.scene = fs::absolute(run.task.scene);
  outlook.wishes = plan_wishes(run.task);
  outlook.wishes.modulus = !run.partners.empty();
  outlook.frames = run.task.frames;
  return outlook;
}

}  // namespace

std::vector<RunOutlook> study_outlook(const ReportOptions& options) {
  const bool results = !options.output.empty();
  const fs::path place = results ? without_slash(options.output) : fs::path();
  const StudyPlan plan = read_study(options.input);
  const WorkingDirectory in_study(plan.directory);
  std::vector<StudyRun> runs = open_runs(plan, options.only);
  if (results) {
    FileHashes hashes = known_hashes(place);
    RunCache cache(place / "cache", shards_in(place));
    settle(runs, cache, hashes);
  }
  std::vector<RunOutlook> all;
  for (const StudyRun& run : runs) all.push_back(outlook_of(run));
  return all;
}

std::string planned_report(const ReportOptions& options) {
  const std::vector<RunOutlook> runs = study_outlook(options);
  std::size_t width = 0;
  for (const RunOutlook& run : runs) width = std::max(width, run.name.size());
  std::string text;
  for (const RunOutlook& run : runs) text += fmt::format("{:<{}}  {}\n", run.name, width, run.state);
  return text;
}

ReportDone finish_report(const StudyPlan& plan, const std::vector<StudyRun>& runs, RunCache& cache, ReportDirectory& directory,
                         const ReportOptions& options) {
  WrittenReport written = write_report(plan, runs, cache, directory.fresh(), options);
  ReportDone done{std::move(written.json), {}, written.damaged};
  directory.commit({{"directory", plan.directory.string()}}, inputs_of(plan, runs));
  std::vector<std::string> names;
  for (const StudyRun& run : runs) {
    names.push_back(run.file);
    if (run.state == RunState::failed) done.failures.push_back(fmt::format("{}: {}", run.plan->name, run.why));
  }
  if (options.only.empty()) cache.keep_only(names);
  return done;
}

ReportDone make_report(const ReportOptions& options) {
  const fs::path place = without_slash(options.output);
  const StudyPlan plan = read_study(options.input);
  ReportDirectory directory(place);
  fs::current_path(plan.directory);
  FileHashes hashes = known_hashes(place);
  std::vector<StudyRun> runs = open_runs(plan, options.only);
  RunCache cache(directory.cache(), shards_in(place));
  analyse_runs(runs, cache, hashes, options);
  cache.gather();
  return finish_report(plan, runs, cache, directory, options);
}

}  // namespace mdana
