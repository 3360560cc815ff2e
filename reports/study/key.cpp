// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/study/provenance.hpp"
#include "reports/study/task.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

Json files_json(const std::vector<InputRecord>& files) {
  Json json = Json::object();
  for (const InputRecord& f : files) json[f.path] = {{"size", f.size}, {"hash", f.hash}};
  return json;
}

Json companion_json(const std::optional<Companion>& companion) {
  if (!companion) return nullptr;
  return {{"run", companion->name}, {"E_star", to_json(companion->modulus)}, {"R", to_json(companion->radius)}};
}

std::string changed_files(const Json& before, const Json& now) {
  std::vector<std::string> names;
  for (const auto& [name, file] : now.items())
    if (!before.contains(name) || before[name] != file) names.push_back(name + (before.contains(name) ? "" : " (new)"));
  for (const auto& [name, file] : before.items())
    if (!now.contains(name)) names.push_back(name + " (no longer)");
  return fmt::format("changed: {}", fmt::join(names, ", "));
}

}  // namespace

Json key_of(const RunTask& task) {
  return {{"program", program_identity()},
          {"name", task.name},
          {"files", files_json(task.files)},
          {"settings", {{"frames", task.frames}, {"accuracy", task.accuracy}, {"stability", task.stability},
                        {"defects", task.defects}, {"snapshots", task.snapshots}}},
          {"E* and R", companion_json(task.companion)}};
}

std::string difference(const Json& before, const Json& now) {
  if (before == now) return {};
  std::vector<std::string> reasons;
  for (const auto& [part, value] : now.items()) {
    if (before.contains(part) && before[part] == value) continue;
    if (part == "files" && before.contains(part))
      reasons.push_back(changed_files(before[part], value));
    else if (part == "program")
      reasons.push_back("made by another mdana");
    else
      reasons.push_back("changed: " + part);
  }
  return fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace mdana
