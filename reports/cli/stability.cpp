// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fits/law_catalogue.hpp"
#include "reports/cli/command.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

Table law_table(const std::vector<LawCase>& cases) {
  std::vector<std::string> laws, names;
  Table table;
  std::vector<double> law, index, computed, exact, digits, needed, evaluations, seconds;
  for (const LawCase& c : cases) {
    index.push_back(static_cast<double>(names.size()));
    law.push_back(index.back());
    laws.emplace_back(c.law);
    names.push_back(c.what);
    computed.push_back(c.computed);
    exact.push_back(c.exact);
    digits.push_back(c.digits);
    needed.push_back(c.needed);
    evaluations.push_back(static_cast<double>(c.evaluations));
    seconds.push_back(c.seconds);
  }
  table.add_column({"law", dimension::none, std::move(laws)}, std::move(law));
  table.add_column({"case", dimension::none, std::move(names)}, std::move(index));
  table.add_column({"computed", dimension::none}, std::move(computed));
  table.add_column({"exact", dimension::none}, std::move(exact));
  table.add_column({"digits", dimension::none}, std::move(digits));
  table.add_column({"needed", dimension::none}, std::move(needed));
  table.add_column({"evaluations", dimension::none}, std::move(evaluations));
  table.add_column({"seconds", dimension::time}, std::move(seconds));
  return table;
}

nlohmann::ordered_json to_json(const LawCase& c) {
  nlohmann::ordered_json json{{"law", c.law}, {"case", c.what}};
  json["digits"] = c.digits;
  json["needed"] = c.needed;
  json["kept"] = c.kept();
  json["unresolved"] = c.unresolved;
  json["evaluations"] = c.evaluations;
  json["seconds"] = c.seconds;
  return json;
}

void add_options(Options& options) {
  options.add_options()                                                              //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"), output_help(true).c_str());
}

int run_command(const Values& values) {
  check_output(values, true);
  const std::string what = values["input"].as<std::string>();
  if (what != "laws") throw UsageError(fmt::format("{}: 'laws' is what can be examined", what));
  const std::vector<LawCase> cases = law_catalogue();
  Document document("stability");
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  long lost = 0;
  for (const LawCase& c : cases) {
    lost += c.kept() ? 0 : 1;
    results.push_back(to_json(c));
    document.line(
        std::string(c.law),
        fmt::format("{:<52} {:4.1f} of {:4.1f} digits {:>9} evaluations in {:.5f} s{}", c.what,
                    c.digits, c.needed, c.evaluations, c.seconds, c.kept() ? "" : "  LOST"));
  }
  document.json("cases", cases.size());
  document.json("lost", lost);
  document.json("results", std::move(results));
  document.line("cases",
                fmt::format("{}, {} with fewer digits than they should keep", cases.size(), lost));
  const Table table = law_table(cases);
  const int code = emit(values, document, &table);
  return lost > 0 ? failed : code;
}

}  // namespace

extern const Command stability_command;
const Command stability_command{
    "stability",
    "laws",
    "extreme cases of the contact laws against what is known of them",
    "Computes collisions that are stiff or extreme (no dissipation, much of it, no adhesion, any "
    "units,\n"
    "radii from 1 to 1e9, at the limit of sticking ...) and of which something is known by "
    "analysis:\n"
    "digits kept, evaluations and seconds of each. Fails if one keeps fewer digits than it should.",
    "  mdana stability laws\n"
    "  mdana stability laws --json -o laws.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
