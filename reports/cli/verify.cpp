// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "reports/cli/command.hpp"
#include "reports/study.hpp"

namespace mdana::cli {
namespace {

void add_options(Options&) {}

int run_command(const Values& values) {
  const Verified verified = verify_report(values["input"].as<std::string>());
  std::string text;
  for (const std::string& change : verified.changes) text += change + "\n";
  text += fmt::format("{} inputs and {} outputs: {}\n", verified.inputs, verified.outputs,
                      verified.changes.empty() ? "as the report was made" : fmt::format("{} changed", verified.changes.size()));
  print(text);
  return verified.changes.empty() ? done : failed;
}

}  // namespace

extern const Command verify_command;
const Command verify_command{
    "verify",
    "OUT",
    "whether a report and what it was made from are unchanged",
    "Hashes the dumps, scenes and study file that a report was made from, and the report's own files, and tells\n"
    "which are no longer what they were (exit code 1).",
    "  mdana verify runs-report",
    add_options,
    run_command};

}  // namespace mdana::cli
