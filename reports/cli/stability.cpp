// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/cli/command.hpp"
#include "reports/compressed.hpp"
#include "reports/extreme.hpp"
#include "reports/row_columns.hpp"
#include "reports/stability.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

/// What can be examined without a dump.
struct Catalogue {
  std::string_view name;
  std::vector<ExtremeCase> (*cases)();
};
constexpr std::array<Catalogue, 5> catalogues{{{"laws", extreme_laws},
                                               {"fits", extreme_fits},
                                               {"dumps", extreme_dumps},
                                               {"structures", extreme_structures},
                                               {"networks", extreme_networks}}};

bool is_catalogue(std::string_view what) {
  return what == "all" || std::ranges::find(catalogues, what, &Catalogue::name) != catalogues.end();
}

Table case_table(const std::vector<ExtremeCase>& cases) {
  Table table;
  add_words(table, "member", cases, [](const ExtremeCase& c) { return c.member; });
  add_words(table, "case", cases, [](const ExtremeCase& c) { return c.what; });
  add_words(table, "quantity", cases, [](const ExtremeCase& c) { return c.quantity; });
  add_numbers(table, "computed", cases, [](const ExtremeCase& c) { return c.computed; });
  add_numbers(table, "exact", cases, [](const ExtremeCase& c) { return c.exact; });
  add_numbers(table, "digits", cases, [](const ExtremeCase& c) { return c.digits; });
  add_numbers(table, "needed", cases, [](const ExtremeCase& c) { return c.needed; });
  add_numbers(table, "condition", cases, [](const ExtremeCase& c) { return c.condition; });
  add_numbers(table, "evaluations", cases, [](const ExtremeCase& c) { return c.evaluations; });
  add_numbers(table, "seconds", cases, [](const ExtremeCase& c) { return c.seconds; }, dimension::time);
  add_words(table, "verdict", cases, [](const ExtremeCase& c) { return name(c.verdict); });
  return table;
}

Json to_json(const ExtremeCase& c) {
  return {{"member", c.member},       {"case", c.what},         {"quantity", c.quantity},
          {"computed", c.computed},   {"exact", c.exact},       {"digits", c.digits},
          {"needed", c.needed},       {"kept", c.right()},      {"verdict", name(c.verdict)},
          {"told", c.told},           {"condition", c.condition}, {"unresolved", c.unresolved},
          {"evaluations", c.evaluations}, {"seconds", c.seconds}};
}

std::string in_words(const ExtremeCase& c) {
  using Verdict = ExtremeCase::Verdict;
  if (c.verdict == Verdict::refused) return fmt::format("{:<52} refused: {}", c.what, c.told);
  if (c.verdict == Verdict::accepted) return fmt::format("{:<52} ACCEPTED: {:.6g} {}", c.what, c.computed, c.told);
  if (c.quantity.empty() && !c.told.empty()) return fmt::format("{:<52} LOST: {}", c.what, c.told);
  return fmt::format("{:<52} {:4.1f} of {:4.1f} digits{}{}{} in {:.5f} s{}", c.what, c.digits, c.needed,
                     c.quantity.empty() ? "" : " of " + c.quantity,
                     c.condition > 0 ? fmt::format(", condition {:.1e}", c.condition) : "",
                     c.evaluations > 0 ? fmt::format(", {} evaluations", c.evaluations) : "", c.seconds,
                     c.verdict == Verdict::lost ? "  LOST" : "");
}

int examine_catalogues(const Values& values, std::string_view what) {
  Document document("stability");
  std::vector<ExtremeCase> cases;
  for (const Catalogue& catalogue : catalogues)
    if (what == "all" || what == catalogue.name)
      for (ExtremeCase& c : catalogue.cases()) cases.push_back(std::move(c));
  Json results = Json::array();
  long lost = 0;
  for (const ExtremeCase& c : cases) {
    lost += c.right() ? 0 : 1;
    results.push_back(to_json(c));
    document.line(c.member, in_words(c));
  }
  document.json("cases", cases.size());
  document.json("lost", lost);
  document.json("results", std::move(results));
  document.line("cases", fmt::format("{}, {} with fewer digits than they should keep", cases.size(), lost));
  const Table table = case_table(cases);
  const int code = emit(values, document, &table);
  return lost > 0 ? failed : code;
}

/// All that mdana collision or mdana compress publishes of a run, and the condition of its fit.
struct Published {
  std::vector<PublishedValue> numbers;
  SweepResult swept;
  std::optional<double> condition = {};
};

Published publish(const Run& run, const RunOptions& options, const SweepOptions& sweeping) {
  Document document("stability", run);
  if (run.scene.interaction == Interaction::aggregate) {
    const CompressedRun compressed = measure_compression(run, options, sweeping);
    add_compression(document, compressed, Split::sign, {});
    return {document.numbers(), compressed.measured.swept};
  }
  PlanWishes asked;
  asked.parts = parts_of("report").value();
  asked.structure = asked.pictures = asked.accuracy = asked.stability = false;
  RunWishes wishes;
  wishes.plan = plan_run(run, asked);
  if (!wishes.plan.has(Part::hertz_fit)) wishes.radii = find_radii(run, options);
  const AnalysedRun analysed = analyse_run(run, wishes, sweeping);
  add_collision(document, run, analysed, {analysed.radii.reduced(), 0, 0}, sweeping, false);
  if (!analysed.hertz) return {document.numbers(), analysed.measured.swept};
  add_hertz(document, run, *analysed.hertz);
  return {document.numbers(), analysed.measured.swept, analysed.hertz->fit.fit.condition};
}

std::string verdict(const StabilityRow& row) {
  if (!row.weak()) return "kept";
  return row.told() ? "weak, as its error says" : "WEAK";
}

Table stability_table(const std::vector<StabilityRow>& rows) {
  Table table;
  add_words(table, "quantity", rows, [](const StabilityRow& r) { return r.quantity; });
  add_numbers(table, "value", rows, [](const StabilityRow& r) { return r.value; });
  add_numbers(table, "error", rows, [](const StabilityRow& r) { return r.error.value_or(std::nan("")); });
  add_numbers(table, "change", rows, [](const StabilityRow& r) { return r.change; });
  add_numbers(table, "digits", rows, [](const StabilityRow& r) { return r.digits; });
  add_words(table, "verdict", rows, verdict);
  return table;
}

int examine_dump(const Values& values) {
  const RunOptions options = run_options(values);
  const SweepOptions sweeping = sweep_options(values);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const Published full = publish(run, options, sweeping);
  const auto again = [&](const SweepOptions& moved) { return publish(run, options, moved).numbers; };
  const std::vector<StabilityRow> rows = stability_rows(full.numbers, again, sweeping);
  Document document("stability", run);
  document.sweep(full.swept, run.format);
  Json results = Json::array();
  long weak = 0;
  for (const StabilityRow& row : rows) {
    weak += row.weak() ? 1 : 0;
    results.push_back({{"quantity", row.quantity}, {"value", row.value}, {"error", row.error ? Json(*row.error) : Json()},
                       {"change", row.change}, {"digits", row.digits}, {"weak", row.weak()}, {"verdict", verdict(row)}});
    document.line(row.quantity, fmt::format("{:<13.6g} changes by {:<9.2g} {:4.1f} digits  {}", row.value, row.change, row.digits,
                                            verdict(row)));
  }
  document.json("repetitions", stability_repetitions);
  if (full.condition) {
    document.json("condition", {{"hertz", *full.condition}});
    document.line("condition of the Hertz fit", fmt::format("{:.3g}", *full.condition));
  }
  document.json("weak", weak);
  document.json("results", std::move(results));
  document.line("numbers", fmt::format("{}, {} that keep fewer than {:g} digits if each number of the dump moves within its last "
                                       "printed digit ({} repetitions)",
                                       rows.size(), weak, StabilityRow::least_stable_digits, stability_repetitions));
  const Table table = stability_table(rows);
  return emit(values, document, &table);
}

void add_options(Options& options) {
  add_run_options(options);
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const std::string what = values["input"].as<std::string>();
  if (is_catalogue(what)) return examine_catalogues(values, what);
  return examine_dump(values);
}

}  // namespace

extern const Command stability_command;
const Command stability_command{
    "stability",
    "DUMP|laws|fits|dumps|structures|networks|all",
    "digits that numbers keep: of your dump, and in stiff and extreme cases",
    "Of a dump: repeats the analysis with each number moved at random within its last printed digit, and tells\n"
    "how many digits of each published number stay. One that keeps fewer than 3 is called weak.\n"
    "Of laws, fits, dumps, structures, networks, or all: computes cases that are stiff or extreme and of which something is known by\n"
    "analysis (any units and sizes, far from the origin, on a drift, coarse, few and noisy frames, no\n"
    "dissipation or much of it, the limit of sticking, narrow ranges, data that determine nothing ...): digits kept\n"
    "of those that should be, and what is refused. Fails if one is lost.",
    "  mdana stability sample-data/hertz-tiny/dump.lammpstrj.gz\n"
    "  mdana stability all\n"
    "  mdana stability laws --json -o laws.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
