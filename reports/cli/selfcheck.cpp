// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "readers/known_answer.hpp"
#include "reports/cli/command.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

/// The answers of one member and how long they took.
struct Checked {
  std::string_view member;
  std::vector<KnownAnswer> answers;
  double seconds;

  const KnownAnswer& worst() const {
    return *std::ranges::min_element(answers, {}, [](const KnownAnswer& a) { return correct_digits(a) - a.digits; });
  }
};

bool kept(const KnownAnswer& answer) { return correct_digits(answer) >= answer.digits; }

Checked check(const KnownMember& member) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<KnownAnswer> answers = member.answers();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {member.name, std::move(answers), seconds};
}

std::vector<double> numbers(const std::vector<Checked>& all, auto&& number) {
  std::vector<double> column;
  for (const Checked& c : all)
    for (const KnownAnswer& a : c.answers) column.push_back(number(c, a));
  return column;
}

/// A row an answer.
Table answer_table(const std::vector<Checked>& all) {
  std::vector<std::string> members, cases;
  std::vector<double> member, index;
  for (const Checked& c : all) {
    for (const KnownAnswer& a : c.answers) {
      member.push_back(static_cast<double>(members.size()));
      index.push_back(static_cast<double>(cases.size()));
      cases.push_back(a.what);
    }
    members.emplace_back(c.member);
  }
  Table table;
  table.add_column({"member", dimension::none, std::move(members)}, std::move(member));
  table.add_column({"case", dimension::none, std::move(cases)}, std::move(index));
  table.add_column({"computed", dimension::none}, numbers(all, [](auto&, auto& a) { return a.computed; }));
  table.add_column({"exact", dimension::none}, numbers(all, [](auto&, auto& a) { return a.exact; }));
  table.add_column({"digits", dimension::none}, numbers(all, [](auto&, auto& a) { return correct_digits(a); }));
  table.add_column({"needed", dimension::none}, numbers(all, [](auto&, auto& a) { return a.digits; }));
  table.add_column({"member_seconds", dimension::time}, numbers(all, [](auto& c, auto&) { return c.seconds; }));
  return table;
}

nlohmann::ordered_json to_json(const Checked& checked) {
  nlohmann::ordered_json json{{"member", checked.member}, {"seconds", checked.seconds}};
  for (const KnownAnswer& a : checked.answers)
    json["answers"].push_back({{"case", a.what},
                               {"computed", a.computed},
                               {"exact", a.exact},
                               {"digits", correct_digits(a)},
                               {"needed", a.digits},
                               {"kept", kept(a)}});
  return json;
}

void tell(Document& document, const Checked& checked) {
  const KnownAnswer& worst = checked.worst();
  document.line(std::string(checked.member),
                fmt::format("{:3} known answers in {:.4f} s; {:4.1f} of {:4.1f} digits in '{}'", checked.answers.size(),
                            checked.seconds, correct_digits(worst), worst.digits, worst.what));
  for (const KnownAnswer& a : checked.answers)
    if (!kept(a))
      document.line("", fmt::format("LOST: {}: {:.17g} instead of {:.17g}, {:.1f} digits of {:.1f}", a.what, a.computed,
                                    a.exact, correct_digits(a), a.digits));
}

void add_options(Options& options) {
  options.add_options()                                                              //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"), output_help(true).c_str());
}

int run_command(const Values& values) {
  check_output(values, true);
  Document document("selfcheck");
  nlohmann::ordered_json members = nlohmann::ordered_json::array();
  std::vector<Checked> all;
  long lost = 0, cases = 0;
  for (const KnownMember& member : known_members()) {
    all.push_back(check(member));
    tell(document, all.back());
    members.push_back(to_json(all.back()));
    cases += static_cast<long>(all.back().answers.size());
    lost += std::ranges::count_if(all.back().answers, [](const KnownAnswer& a) { return !kept(a); });
  }
  document.json("cases", cases);
  document.json("lost", lost);
  document.json("members", std::move(members));
  document.line("cases", fmt::format("{}, {} with fewer digits than they should keep", cases, lost));
  const Table table = answer_table(all);
  const int code = emit(values, document, &table);
  return lost > 0 ? failed : code;
}

}  // namespace

extern const Command selfcheck_command;
const Command selfcheck_command{
    "selfcheck",
    "",
    "known answers of all formats, analyses and laws of this build",
    "Every format, analysis and law has cases with answers in closed form: digits of each that this build keeps on\n"
    "this machine, and seconds. Fails if one keeps fewer digits than it should.",
    "  mdana selfcheck -o selfcheck.json\n"
    "  mdana selfcheck --json -o selfcheck.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
