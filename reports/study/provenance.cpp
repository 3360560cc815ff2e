// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/provenance.hpp"

#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <sys/utsname.h>

#include "readers/input_record.hpp"
#include "readers/input_error.hpp"
#include "reports/stability.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

Json command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  Json words = Json::array();
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != line.npos) return line.substr(line.find(": ") + 2);
  return "unknown";
}

Json machine() {
  utsname system{};
  ::uname(&system);
  return {{"system", fmt::format("{} {}", system.sysname, system.release)},
          {"architecture", system.machine},
          {"processor", processor()},
          {"cores", std::thread::hardware_concurrency()}};
}

Json libraries_json() {
  Json json = Json::object();
  for (const auto& [name, number] : library_versions) json[name] = number;
  return json;
}

Json seeds() {
  Json last_digits = Json::array();
  for (int seed = 1; seed <= stability_repetitions; ++seed) last_digits.push_back(seed);
  return {{"last_digits", last_digits}};
}

}  // namespace

const std::string& program_identity() {
  static const std::string identity = [] {
    try {
      return fmt::format("{} {}", version, input_record("/proc/self/exe").hash);
    } catch (const InputError&) {
      return std::string(version);
    }
  }();
  return identity;
}

Json provenance() {
  return {{"command_line", command_line()}, {"program", program_identity()}, {"compiler", compiler_version},
          {"machine", machine()},           {"libraries", libraries_json()}, {"seeds", seeds()}};
}

}  // namespace mdana
