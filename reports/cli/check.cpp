// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/trajectory.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

std::string_view name(Severity severity) {
  return severity == Severity::error ? "error" : "note";
}

template <class T>
nlohmann::ordered_json or_null(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json to_json(const Fault& fault) {
  const FaultKindWords& words = words_of(fault.kind);
  nlohmann::ordered_json json{{"kind", words.name}, {"severity", name(words.severity)},
                              {"file", fault.file}, {"line", or_null(fault.line)}};
  if (fault.atom) json["atom"] = *fault.atom;
  json["frame"] = or_null(fault.frame);
  json["step"] = or_null(fault.step);
  json["column"] =
      fault.column.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(fault.column);
  json["what"] = fault.what;
  json["times"] = fault.times;
  return json;
}

/// "dump:12: what (frame 3, step 100)".
std::string to_line(const Fault& fault) {
  std::string text = fault.file;
  if (fault.line) text += fmt::format(":{}", *fault.line);
  if (fault.atom) text += fmt::format(": atom {}", *fault.atom);
  text += fmt::format(": {}", fault.what);
  if (fault.frame && fault.step)
    text += fmt::format(" (frame {}, step {})", *fault.frame, *fault.step);
  else if (fault.frame)
    text += fmt::format(" (frame {})", *fault.frame);
  return text;
}

void add_faults(Document& document, const Faults& faults) {
  auto list = nlohmann::ordered_json::array();
  for (const Fault& fault : faults.kept()) {
    list.push_back(to_json(fault));
    document.line(std::string(name(words_of(fault.kind).severity)), to_line(fault));
  }
  auto counts = nlohmann::ordered_json::object();
  for (const FaultKindWords& words : fault_kinds()) {
    const std::uint64_t count = faults.count(words.kind);
    if (count == 0) continue;
    counts[std::string(words.name)] = count;
    document.line(std::string(words.name), fmt::format("{}: {}", count, words.meaning));
  }
  document.json("faults", std::move(list));
  document.json("counts", std::move(counts));
  document.json("errors", faults.count(Severity::error));
  document.json("notes", faults.count(Severity::note));
}

void add_checked(Document& document, const CheckResult& result) {
  document.json("atoms", result.atoms);
  document.line("atoms", fmt::format("{} in all frames", result.atoms));
  document.json("checked", {{"columns", result.columns},
                            {"ids_compared", result.ids_compared},
                            {"to_the_end", result.to_the_end}});
  document.line("columns", fmt::format("{}", fmt::join(result.columns, " ")));
}

void add_verdict(Document& document, const CheckResult& result) {
  const std::uint64_t errors = result.faults.count(Severity::error);
  const std::uint64_t notes = result.faults.count(Severity::note);
  document.line("result", errors + notes == 0 ? "no faults"
                                              : fmt::format("errors {}, notes {}", errors, notes));
  if (!result.to_the_end)
    document.warn("what follows the last error cannot be read and was not looked at");
}

Document document_of(const std::string& dump, const CheckResult& result) {
  Document document("check");
  document.line("dump", dump);
  SweepResult as_swept;  // says input and time in the same words as every command
  as_swept.steps.resize(result.frames);
  as_swept.inputs = result.inputs;
  as_swept.seconds = result.seconds;
  document.sweep(as_swept, format_of(dump));
  add_checked(document, result);
  add_faults(document, result.faults);
  add_verdict(document, result);
  return document;
}

void add_options(Options& options) {
  options.add_options()("limit", po::value<long>()->default_value(20)->value_name("N"),
                        "tell so many faults of a kind at most; all are counted")  //
      ("threads", po::value<long>()->default_value(0, "all")->value_name("N"),
       "threads for the blocks of large frames; the faults are the same with any number")  //
      ("memory", po::value<std::string>()->default_value("128M")->value_name("SIZE"),
       "memory for ids (24 bytes an atom while a first frame is read, then 8); beyond it they are "
       "not compared, which is a note")  //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"), "write the document (.json)");
}

CheckOptions check_options(const Values& values) {
  const long limit = values["limit"].as<long>();
  if (limit < 0) throw UsageError("--limit must not be negative");
  SweepOptions resources;
  set_resources(values, resources);
  CheckOptions options;
  options.limit = static_cast<std::size_t>(limit);
  options.threads = resources.threads;
  options.memory = resources.memory;
  options.stop = &stop_signal();
  options.progress = progress_printer();
  return options;
}

int run_command(const Values& values) {
  check_output(values, false);
  const CheckOptions options = check_options(values);
  const std::string dump = values["input"].as<std::string>();
  const CheckResult result = check_dump(dump, options);
  const int code = emit(values, document_of(dump, result), nullptr);
  return result.faults.count(Severity::error) > 0 ? damaged_input : code;
}

}  // namespace

extern const Command check_command;
const Command check_command{
    "check",
    "DUMP",
    "every fault of a dump: file, line and frame of each",
    "Reads every column of every atom of every frame and goes on after faults, where the other\n"
    "commands look at the columns that they need and stop at the first fault. Errors: words that\n"
    "are no numbers, lines with too few or many columns, wrong headers and numbers of atoms, cut or\n"
    "damaged files, ids that stand twice, nan and inf, types below 1, masses that are not above\n"
    "zero, steps, times and units that do not fit together. Notes, which need not be wrong:\n"
    "positions far outside a periodic box, ids lost or gained, numbers of atoms or columns that\n"
    "change. Exit code 0: no errors; 3: errors; 1: not readable at all.",
    "  mdana check sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana check 'run/dump.*.lammpstrj' --limit 5 --json -o faults.json",
    add_options,
    run_command};

}  // namespace mdana::cli
