// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are found in a directory, and the study file that is written of them.
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/collision_law.hpp"
#include "readers/input_error.hpp"
#include "reports/study/found.hpp"
#include "reports/figure_kinds.hpp"
#include "reports/study/plan.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 6;  ///< directories below that of the study

bool is_dump(const fs::path& file) {
  std::string name = file.filename().string();
  for (const char* packed : {".gz", ".zst"})
    if (name.ends_with(packed)) name.resize(name.size() - std::string_view(packed).size());
  return std::ranges::any_of(std::array{".lammpstrj", ".dump", ".h5md"}, [&](const char* e) { return name.ends_with(e); });
}

struct Found {
  std::vector<fs::path> scenes, dumps;  ///< relative to the directory
};

Found look(const fs::path& directory) {
  Found found;
  auto it = fs::recursive_directory_iterator(directory, fs::directory_options::skip_permission_denied);
  for (; it != fs::end(it); ++it) {
    const fs::path& path = it->path();
    const bool hidden = path.filename().string().starts_with('.');
    if (it->is_directory() && (hidden || it.depth() >= deepest || fs::exists(path / report_marker)))
      it.disable_recursion_pending();
    else if (hidden || !it->is_regular_file())
      continue;
    else if (path.filename() == "scene.toml")
      found.scenes.push_back(fs::relative(path, directory));
    else if (is_dump(path))
      found.dumps.push_back(fs::relative(path, directory));
  }
  std::ranges::sort(found.scenes);
  std::ranges::sort(found.dumps);
  return found;
}

/// The scene; one without anything if it cannot be read, which the run itself tells of.
Scene scene_of(const fs::path& file) try {
  return load_scene(file);
} catch (const InputError&) {
  return {};
}

std::string folder_name(const StudyPlan& plan, const fs::path& scene) {
  const fs::path folder = scene.parent_path();
  return folder.empty() ? plan.directory.filename().string() : folder.generic_string();
}

/// Runs whose scenes have the same name are told apart by their folders.
void make_names_differ(StudyPlan& plan) {
  std::map<std::string, int> count;
  for (const PlannedRun& run : plan.runs) ++count[run.name];
  for (PlannedRun& run : plan.runs)
    if (count[run.name] > 1) run.name = folder_name(plan, run.scene);
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + "\"";
}

/// Dumps that no scene of the study names, as comments.
std::string other_dumps(const StudyPlan& plan) {
  std::set<fs::path> named;
  for (const PlannedRun& run : plan.runs)
    named.insert(run.scene.parent_path() / scene_of(plan.directory / run.scene).dump);
  std::string text;
  for (const fs::path& dump : look(plan.directory).dumps) {
    const bool contacts = dump.filename().string().find("contacts") != std::string::npos;
    if (!named.contains(dump) && !contacts) text += fmt::format("#   {}\n", dump.generic_string());
  }
  return text.empty() ? text : "\n# Dumps that no scene.toml names; a run needs one beside its dump:\n" + text;
}

std::string law_names() {
  std::vector<std::string_view> names;
  for (const CollisionLaw* law : collision_laws()) names.push_back(law->name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string list_of(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) all.push_back(quoted(text));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

std::string run_toml(const PlannedRun& run) {
  std::string text = fmt::format("\n[[run]]\nname = {}\nscene = {}\ngroup = {}\n", quoted(run.name),
                                 quoted(run.scene.generic_string()), quoted(run.group));
  if (!run.frames.empty()) text += fmt::format("frames = {}\n", quoted(run.frames));
  if (!run.log.empty()) text += fmt::format("log = {}\n", quoted(run.log.generic_string()));
  return text;
}

}  // namespace

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
    if (kept || !name.ends_with('_')) name += kept ? c : '_';
  }
  return name.empty() ? "run" : name;
}

std::vector<std::string> file_names(const StudyPlan& plan) {
  std::set<std::string> taken;
  std::vector<std::string> names;
  for (const PlannedRun& run : plan.runs) {
    std::string name = file_name(run.name);
    for (int k = 2; !taken.insert(name).second; ++k) name = fmt::format("{}-{}", file_name(run.name), k);
    names.push_back(name);
  }
  return names;
}

std::string group_of(const Scene& scene) {
  std::string group(name(scene.interaction));
  if (scene.interaction == Interaction::aggregate && scene.filling_factor)
    group += fmt::format(", phi = {:g}", *scene.filling_factor);
  if (scene.interaction == Interaction::adhesive && !scene.surface_energy) group += ", gamma not known";
  if (scene.radii.size() == 2)
    group += scene.radii[0] == scene.radii[1] ? fmt::format(", R = {:g}", scene.radii[0])
                                              : fmt::format(", R = {:g} and {:g}", scene.radii[0], scene.radii[1]);
  return group;
}

StudyPlan find_runs(const fs::path& directory) {
  StudyPlan plan;
  plan.directory = fs::weakly_canonical(directory);
  plan.title = "Contact mechanics";
  for (const fs::path& file : look(plan.directory).scenes) {
    const Scene scene = scene_of(plan.directory / file);
    if (scene.interaction == Interaction::adhesive && find_collision_law("jkr")) plan.settings.laws = {"jkr"};
    plan.runs.push_back({scene.name.empty() ? folder_name(plan, file) : scene.name, group_of(scene), file, {}, {}});
  }
  if (plan.runs.empty())
    throw InputError(fmt::format("{}: no scene.toml here or below; every run needs one (see "
                                 "sample-data/adhesive-tiny/scene.toml)", directory.string()));
  make_names_differ(plan);
  return plan;
}

std::string study_toml(const StudyPlan& plan) {
  const StudySettings& s = plan.settings;
  std::string text = fmt::format(
      "# A study: runs that are told of on one page. Written by mdana study init, to be edited.\n"
      "# mdana report study.toml -o report   analyses what is new or changed, and writes the page\n"
      "# Paths count from the directory of this file.\n"
      "schema = 1\ntitle = {}\n\n"
      "[checks]  # each run is read again for them, many times; false where that takes too long\n"
      "accuracy = {}   # error of each number against run time: about twenty passes\n"
      "stability = {}  # digits that the printed digits of the dump fix: four passes\n\n"
      "[analyses]\n"
      "defects = {}  # crystal structure and its faults, of spheres\n\n"
      "[fits]\n"
      "sizes = {}       # E* against R of the Hertz runs\n"
      "aggregates = {}  # E* and Y of aggregates, by delta_max and t_max\n"
      "# laws of collisions, fitted to e and sticking of each group; any of\n"
      "# {}\n"
      "laws = {}\n\n"
      "[figures]\n"
      "# kinds that pool runs, and snapshots of each; an empty list is all that there are data for (mdana plot --list)\n"
      "kinds = {}\n\n"
      "# name: must differ. group: runs that differ by velocity or orientation alone. frames (optional): A:B[:K],\n"
      "# as --frames. log (optional): of LAMMPS, for potential energies.\n",
      quoted(plan.title), s.accuracy, s.stability, s.defects, s.sizes, s.aggregates, law_names(), list_of(s.laws),
      list_of(s.figures));
  for (const PlannedRun& run : plan.runs) text += run_toml(run);
  return text + other_dumps(plan);
}

}  // namespace mdana
