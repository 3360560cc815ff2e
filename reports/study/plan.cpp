// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/plan.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "fits/collision_law.hpp"
#include "readers/frame_choice.hpp"
#include "readers/input_error.hpp"
#include "readers/shown.hpp"
#include "readers/toml_text.hpp"
#include "reports/study/found.hpp"
#include "reports/figure_kinds.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

/// One table of the file; names that nobody took are errors.
class Entries {
 public:
  Entries(const toml::table& table, std::string path, std::string prefix)
      : table_(table), path_(std::move(path)), prefix_(std::move(prefix)) {}

  [[noreturn]] void fail(const toml::node& node, std::string_view key, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}{}: {}", path_, node.source().begin.line, prefix_, shown(key), what));
  }

  const toml::node* take(std::string_view key) {
    taken_.insert(std::string(key));
    return table_.get(key);
  }

  void text(std::string_view key, std::string& into) {
    const toml::node* node = take(key);
    if (!node) return;
    if (!node->is_string()) fail(*node, key, "a text in quotes is expected");
    into = *node->value<std::string>();
  }

  void truth(std::string_view key, bool& into) {
    const toml::node* node = take(key);
    if (!node) return;
    if (!node->is_boolean()) fail(*node, key, "true or false is expected");
    into = *node->value<bool>();
  }

  /// Texts of a list, each of which must be known.
  void texts(std::string_view key, std::vector<std::string>& into, const std::vector<std::string_view>& known) {
    const toml::node* node = take(key);
    if (!node) return;
    if (!node->is_array()) fail(*node, key, "a list of texts in quotes is expected");
    for (const toml::node& entry : *node->as_array()) {
      const auto word = entry.is_string() ? entry.value<std::string>() : std::nullopt;
      if (!word || std::ranges::find(known, *word) == known.end())
        fail(entry, key, fmt::format("{}is none of {}", word ? "'" + shown(*word) + "' " : "", fmt::join(known, ", ")));
      into.push_back(*word);
    }
  }

  void finish() const {
    for (const auto& [key, node] : table_)
      if (!taken_.contains(std::string(key.str()))) fail(node, key.str(), "unknown key");
  }

  const std::string& path() const { return path_; }

 private:
  const toml::table& table_;
  std::string path_, prefix_;
  std::set<std::string> taken_;
};

template <class Read>
void subtable(Entries& entries, const char* key, Read&& read) {
  const toml::node* node = entries.take(key);
  if (!node) return;
  if (!node->is_table()) entries.fail(*node, key, "a table is expected");
  Entries inner(*node->as_table(), entries.path(), std::string(key) + ".");
  read(inner);
  inner.finish();
}

std::vector<std::string_view> known_laws() {
  std::vector<std::string_view> names;
  for (const CollisionLaw* law : collision_laws()) names.push_back(law->name);
  return names;
}

std::vector<std::string_view> known_kinds() {
  std::vector<std::string_view> names;
  for (const FigureKind& kind : figure_kinds()) names.push_back(kind.name);
  return names;
}

PlannedRun read_run(const toml::node& node, const std::string& path, const fs::path& directory) {
  Entries entries(*node.as_table(), path, "run.");
  PlannedRun run;
  std::string scene, log;
  entries.text("name", run.name);
  entries.text("group", run.group);
  entries.text("scene", scene);
  entries.text("frames", run.frames);
  entries.text("log", log);
  entries.finish();
  if (run.name.empty()) entries.fail(node, "name", "every run needs one");
  if (scene.empty()) entries.fail(node, "scene", fmt::format("run '{}' needs a scene file", shown(run.name)));
  run.scene = scene;
  run.log = log;
  try {
    if (!run.frames.empty()) parse_frame_choice(run.frames);
  } catch (const InputError& error) {
    entries.fail(*entries.take("frames"), "frames", error.what());
  }
  if (run.group.empty() && fs::is_regular_file(directory / run.scene)) {
    try {
      run.group = group_of(load_scene(directory / run.scene));
    } catch (const InputError&) {  // the run itself tells of it
    }
  }
  return run;
}

void read_runs(Entries& entries, StudyPlan& plan) {
  const toml::node* node = entries.take("run");
  if (!node || !node->is_array_of_tables())
    throw InputError(fmt::format("{}: no [[run]] tables; mdana study init DIR writes them", entries.path()));
  std::set<std::string> names;
  for (const toml::node& entry : *node->as_array()) {
    plan.runs.push_back(read_run(entry, entries.path(), plan.directory));
    if (!names.insert(plan.runs.back().name).second)
      entries.fail(entry, "run.name", fmt::format("'{}' stands twice", shown(plan.runs.back().name)));
  }
}

StudyPlan read(const toml::table& table, const fs::path& file) {
  StudyPlan plan;
  plan.file = fs::weakly_canonical(file);
  plan.directory = plan.file.parent_path();
  plan.title = "Contact mechanics";
  Entries entries(table, file.string(), "");
  const toml::node* schema = entries.take("schema");
  if (!schema || schema->value<std::int64_t>() != 1) throw InputError(file.string() + ": 'schema = 1' is expected");
  entries.text("title", plan.title);
  StudySettings& s = plan.settings;
  subtable(entries, "checks", [&](Entries& e) { e.truth("accuracy", s.accuracy), e.truth("stability", s.stability); });
  subtable(entries, "analyses", [&](Entries& e) { e.truth("defects", s.defects); });
  subtable(entries, "fits", [&](Entries& e) {
    e.truth("sizes", s.sizes), e.truth("aggregates", s.aggregates), e.texts("laws", s.laws, known_laws());
  });
  subtable(entries, "figures", [&](Entries& e) { e.texts("kinds", s.figures, known_kinds()); });
  read_runs(entries, plan);
  entries.finish();
  return plan;
}

}  // namespace

StudyPlan read_study(const fs::path& input) {
  if (fs::is_directory(input)) return find_runs(input);
  if (!fs::is_regular_file(input))
    throw InputError(fmt::format("{}: No such file or directory; a study file or a directory with runs is expected", input.string()));
  try {
    return read(toml::parse(toml_text(input), input.string()), input);
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", input.string(), e.source().begin.line, e.description()));
  }
}

}  // namespace mdana
