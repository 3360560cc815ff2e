// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/study.hpp"
#include "reports/study/report_directory.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What is different about a file; empty if nothing is.
std::string change(const fs::path& file, const Json& record) {
  if (!fs::is_regular_file(file)) return "is no longer there";
  const InputRecord now = input_record(file);
  if (now.hash == record.value("hash", "")) return {};
  const auto size = record.value("size", std::uint64_t{0});
  return now.size == size ? "has other bytes" : fmt::format("has {} bytes, not {}", now.size, size);
}

std::size_t compare(const Json& records, const fs::path& directory, const char* what, std::vector<std::string>& changes) {
  for (const Json& record : records) {
    const std::string path = record.value("path", "");
    if (const std::string how = change(directory / path, record); !how.empty())
      changes.push_back(fmt::format("{} {} {}", what, path, how));
  }
  return records.size();
}

}  // namespace

Verified verify_report(const fs::path& output) try {
  std::ifstream stream(output / manifest_name);
  if (!stream)
    throw InputError(fmt::format("{}: No such file or directory; mdana report writes it last",
                                 (output / manifest_name).string()));
  const Json manifest = Json::parse(stream);
  const fs::path study = manifest.at("study").at("directory").get<std::string>();
  Verified verified;
  verified.inputs = compare(manifest.at("inputs"), study, "input", verified.changes);
  verified.outputs = compare(manifest.at("outputs"), output, "output", verified.changes);
  return verified;
} catch (const Json::exception&) {
  throw InputError(fmt::format("{}: not the manifest of a report", (output / manifest_name).string()));
}

}  // namespace mdana
