// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scene_files(const fs::path& directory) {
  std::vector<fs::path> files;
  if (fs::is_regular_file(directory / "scene.toml")) files.push_back(directory / "scene.toml");
  for (const auto& entry : fs::directory_iterator(directory)) {
    const fs::path file = entry.path() / "scene.toml";
    const bool hidden = entry.path().filename().string().starts_with('.');
    if (!hidden && entry.is_directory() && fs::is_regular_file(file)) files.push_back(file);
  }
  std::sort(files.begin(), files.end());
  return files;
}

StudyRun open_run(const fs::path& scene_file) {
  StudyRun entry;
  entry.name = scene_file.parent_path().filename().string();
  try {
    const Scene scene = load_scene(scene_file);
    if (!scene.name.empty()) entry.name = scene.name;
    if (scene.dump.empty())
      throw InputError(fmt::format("{}: the scene names no dump", scene_file.string()));
    entry.dump = scene_file.parent_path() / scene.dump;
    RunOptions options;
    options.dump = entry.dump;
    options.scene = scene_file;
    entry.run = prepare_run(options);
    require_two_bodies(*entry.run);
  } catch (const InputError& error) {
    entry.failure = error.what();
    entry.run.reset();
  }
  return entry;
}

bool is_hertz(const StudyRun& entry) {
  return entry.run && entry.run->scene.interaction == Interaction::hertz;
}

/// A Hertz run of the study with a usable fit for bodies of the same scene radius and units.
const StudyRun* companion(const Study& study, const Run& run) {
  for (const StudyRun& other : study.runs) {
    if (!is_hertz(other) || !other.result || !other.result->hertz) continue;
    if (!other.result->hertz->fit.fit.usable || other.run->units != run.units) continue;
    const auto &a = other.run->scene.radii, &b = run.scene.radii;
    if (a.size() == 2 && b.size() == 2 && std::abs(a[0] - b[0]) <= 0.01 * b[0] &&
        std::abs(a[1] - b[1]) <= 0.01 * b[1])
      return &other;
  }
  return nullptr;
}

std::optional<Radii> companion_radii(const StudyRun* other) {
  if (!other) return std::nullopt;
  const Value& r = other->result->hertz->radius;
  return Radii{{r.value, r.value}, fmt::format("Hertz fit of run {}", other->name), 2 * *r.error};
}

/// Hertz over its own fit; JKR where E*, R and gamma are known.
void choose_overlay(StudyRun& entry, const StudyRun* other) {
  const HertzResult* hertz = entry.result->hertz ? &*entry.result->hertz
                             : other             ? &*other->result->hertz
                                                 : nullptr;
  const bool adhesive = entry.run->scene.interaction == Interaction::adhesive;
  const ForceLaw* law = find_force_law(adhesive ? "jkr" : "hertz");
  const auto gamma = entry.run->scene.surface_energy;
  if (!law || !hertz || !hertz->fit.fit.usable || (adhesive && !gamma)) {
    entry.left_out.push_back(
        {adhesive ? "JKR overlay" : "Hertz overlay",
         !law       ? "this build has no such law"
         : adhesive && !gamma ? "the scene states no surface energy"
                              : "no Hertz run with the same radius gives E* and R"});
    return;
  }
  entry.overlay = Overlay{law,
                          {hertz->radius.value / 2, hertz->modulus.value, gamma.value_or(0)},
                          fmt::format("E* and R from the Hertz fit of {}",
                                      other ? other->name : entry.name)};
  if (adhesive) entry.overlay->source += fmt::format(", gamma = {:g} from the scene", *gamma);
}

void list_left_out(StudyRun& entry) {
  const AnalysedRun& result = *entry.result;
  auto& out = entry.left_out;
  switch (entry.run->scene.interaction) {
    case Interaction::hertz:
      out.push_back({"adhesion (JKR, surface energy)", "the scene has no attraction between bodies"});
      break;
    case Interaction::adhesive:
      out.push_back({"Hertz fit", "the scene is adhesive: Hertz's law has no adhesion"});
      break;
    case Interaction::aggregate:  // not in a study
    case Interaction::unknown:
      out.push_back({"Hertz fit, overlays", "the scene does not state a hertz or adhesive interaction"});
  }
  if (!result.contact.touch())
    out.push_back({"contact radius", "the layer of one sigma never holds atoms of both bodies: under "
                                     "this load they keep farther apart"});
  if (result.curve.outcome != Outcome::bounce)
    out.push_back({"coefficient of restitution",
                   result.curve.outcome == Outcome::stick
                       ? "the bodies stick: there is no speed after"
                       : "the dump ends before the bodies separate"});
  for (const ForceSource other :
       {ForceSource::forces, ForceSource::velocities, ForceSource::positions})
    if (other > result.source)
      out.push_back({fmt::format("force from {}", name(other)),
                     fmt::format("the dump has {}, which are better", name(result.source))});
    else if (other < result.source)
      out.push_back({fmt::format("force from {}", name(other)), "not in the dump"});
}

void analyse(const Study& study, StudyRun& entry, const SweepOptions& options,
             const std::function<void(const std::string&)>& progress) {
  const Run& run = *entry.run;
  const StudyRun* other = is_hertz(entry) ? nullptr : companion(study, run);
  progress(entry.name + ": force, contact radius, fits");
  entry.result = analyse_run(run, companion_radii(other), options);
  choose_overlay(entry, other);
  list_left_out(entry);
  progress(entry.name + ": error against run time");
  entry.accuracy = accuracy_rows(run, *entry.result, options);
  progress(entry.name + ": numerical stability");
  entry.stability = stability_rows(run, *entry.result, options);
  entry.warnings = run.warnings;
  if (entry.result->contact.touch())
    for (const std::string& w : contact_disagreements(entry.result->contact, run.units))
      entry.warnings.push_back(w);
  if (!entry.result->measured.swept.damage.empty())
    entry.warnings.push_back("damaged input: " + entry.result->measured.swept.damage);
}

}  // namespace

Study find_study(const fs::path& directory) {
  if (!fs::is_directory(directory))
    throw InputError(fmt::format("{}: no such directory", directory.string()));
  Study study{directory, {}, {}, {}};
  for (const fs::path& file : scene_files(directory)) {
    StudyRun entry = open_run(file);
    if (entry.run && entry.run->scene.interaction == Interaction::aggregate)
      study.aggregates.push_back({entry.name, entry.dump, *entry.run, {}, {}});
    else
      study.runs.push_back(std::move(entry));
  }
  if (study.runs.empty() && study.aggregates.empty())
    throw InputError(fmt::format("{}: no scene.toml here or one level below; every run needs one "
                                 "(see sample-data/adhesive-tiny/scene.toml)", directory.string()));
  std::stable_partition(study.runs.begin(), study.runs.end(), is_hertz);
  return study;
}

void analyse_study(Study& study, const SweepOptions& options,
                   const std::function<void(const std::string&)>& progress) {
  for (StudyRun& entry : study.runs) {
    if (!entry.failure.empty()) continue;
    try {
      analyse(study, entry, options, progress);
    } catch (const InputError& error) {
      entry.failure = error.what();
      entry.result.reset();
    }
  }
  analyse_aggregates(study.aggregates, options, progress);
  study.together = aggregates_together(study.aggregates);
}

}  // namespace mdana
