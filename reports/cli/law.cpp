// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fits/force_law.hpp"
#include "readers/input_error.hpp"
#include "reports/cli/command.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

const ForceLaw& law_option(const Values& values) {
  const std::string text = values["law"].as<std::string>();
  if (const ForceLaw* law = find_force_law(text)) return *law;
  std::string names;
  for (const ForceLaw* law : force_laws()) names += fmt::format(" {}", law->name);
  throw UsageError(fmt::format("--law {}: one of{} expected", text, names));
}

/// What --delta says.
struct Range {
  bool from_least = false;
  double first = 0, last = 0;
  std::size_t count = 0;
};

Range delta_option(const Values& values) {
  const std::string text = values["delta"].as<std::string>();
  const std::string expected = fmt::format(
      "--delta {}: FIRST:LAST:COUNT with FIRST < LAST (or FIRST = least) and a COUNT of 2 to "
      "1000000 "
      "is expected",
      text);
  const auto [first, last, count] = three_parts(text, expected);
  Range r;
  r.from_least = first == "least";
  r.first = r.from_least ? 0 : finite_number(first, expected);
  r.last = finite_number(last, expected);
  r.count = count_number(count, expected);
  if (!r.from_least && !(r.first < r.last)) throw UsageError(expected);
  return r;
}

Table empty_table() {
  return Table(std::vector<ColumnSpec>{{"branch", dimension::none, {"loading", "unloading"}},
                                       {"delta", dimension::length},
                                       {"F", dimension::force},
                                       {"a", dimension::length},
                                       {"p_c", dimension::pressure},
                                       {"U", dimension::energy},
                                       {"stiffness", Dimension{1, 0, -2}}});
}

double finite_or_nan(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

/// COUNT rows from the range's first delta, or the branch's least, to the last; unloading
/// downwards.
void add_branch(Table& table, const ForceBranch& b, const ElasticContact& c, const Range& range,
                bool downwards) {
  const double first = range.from_least ? b.least_delta(c) : range.first;
  if (!(first < range.last))
    throw InputError(fmt::format("--delta: the contact begins at {:g}, above the last delta {:g}",
                                 first, range.last));
  std::vector<double> deltas = evenly(first, range.last, range.count);
  if (downwards) std::reverse(deltas.begin(), deltas.end());
  for (const double d : deltas) {
    std::vector<double> row{downwards ? 1.0 : 0.0, d,
                            b.force(d, c),         b.contact_radius(d, c),
                            b.pressure(0, d, c),   b.energy(d, c),
                            b.stiffness(d, c)};
    std::transform(row.begin(), row.end(), row.begin(), finite_or_nan);
    table.add_row(row);
  }
}

/// Where the pressure is asked for: at a delta on loading, or on unloading from delta_max.
struct Place {
  const ForceBranch* branch;
  ElasticContact contact;
  double delta;
};

Place place_of(const Values& values, const ForceLaw& law, const ElasticContact& contact) {
  Place p{&law, contact, values["profile"].as<double>()};
  if (values.count("delta-max")) {
    if (!law.unloading)
      throw UsageError(
          fmt::format("--delta-max: law {} has no history, its way back is the same", law.name));
    p.branch = law.unloading;
    p.contact.delta_max = values["delta-max"].as<double>();
    if (!(p.delta <= p.contact.delta_max && std::isfinite(p.contact.delta_max)))
      throw UsageError("--delta-max must be at least the delta of --profile");
  }
  const double least = p.branch->least_delta(p.contact);
  if (!(p.delta > least && std::isfinite(p.delta)))
    throw InputError(
        fmt::format("--profile {:g}: the contact begins at delta = {:g}", p.delta, least));
  return p;
}

/// 201 radii from the centre to where the pressure ends.
Table profile(const Place& p) {
  Table table(std::vector<ColumnSpec>{{"r", dimension::length}, {"p", dimension::pressure}});
  for (const double r : evenly(0, p.branch->pressure_radius(p.delta, p.contact), 201))
    table.add_row(std::vector{r, finite_or_nan(p.branch->pressure(r, p.delta, p.contact))});
  return table;
}

nlohmann::ordered_json column_json(const Table& table, std::size_t k) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  const std::vector<std::string>& labels = table.columns()[k].labels;
  for (const double x : table.column(k))
    if (!labels.empty())
      json.push_back(labels[static_cast<std::size_t>(x)]);
    else
      json.push_back(std::isnan(x) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(x));
  return json;
}

void add_parameters(Document& document, const std::vector<NamedValue>& given) {
  nlohmann::ordered_json json;
  std::string text;
  for (const NamedValue& g : given) {
    json[g.name] = g.text;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", g.name, g.text);
  }
  document.json("parameters", std::move(json));
  document.line("parameters", text);
}

void add_plain(Document& document, const std::string& name, double value) {
  document.json(name, value);
  document.line(name, fmt::format("{:.8g}", value));
}

void add_results(Document& document, const Table& table) {
  nlohmann::ordered_json json;
  for (std::size_t k = 0; k < table.columns().size(); ++k)
    json[table.columns()[k].name] = column_json(table, k);
  document.json("results", std::move(json));
}

void add_lines(Document& document, const Table& table) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    document.line(fmt::format("delta = {:.6g}", table.column("delta")[row]),
                  fmt::format("F {:<13.8g} a {:<13.8g} p_c {:.8g}{}", table.column("F")[row],
                              table.column("a")[row], table.column("p_c")[row],
                              table.column("branch")[row] > 0 ? " unloading" : ""));
}

void add_options(Options& options) {
  options.add_options()                                                                        //
      ("law", po::value<std::string>()->required()->value_name("NAME"), "the law, see above")  //
      ("parameter,p", po::value<std::vector<std::string>>()->composing()->value_name("NAME=VALUE"),
       "a parameter, in any consistent units")  //
      ("delta", po::value<std::string>()->value_name("FIRST:LAST:COUNT"),
       "values of delta, ends included; FIRST can be 'least': where the contact begins")  //
      ("profile", po::value<double>()->value_name("DELTA"),
       "instead, the pressure p(r) at this delta, from the centre to where it ends")  //
      ("delta-max", po::value<double>()->value_name("DELTA"),
       "of --profile: on unloading from there")                                      //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"), output_help(true).c_str());
}

/// The law over the range of delta.
Table curve(const ForceLaw& law, ElasticContact contact, const Range& range, Document& document) {
  contact.delta_max = range.last;
  Table table = empty_table();
  add_branch(table, law, contact, range, false);
  add_plain(document, "least_delta", law.least_delta(contact));
  if (law.unloading) {
    add_branch(table, *law.unloading, contact, range, true);
    add_plain(document, "least_delta_unloading", law.unloading->least_delta(contact));
  }
  add_lines(document, table);
  return table;
}

/// The pressure over the contact.
Table pressures(const Place& place, Document& document) {
  add_plain(document, "delta", place.delta);
  add_plain(document, "a", place.branch->contact_radius(place.delta, place.contact));
  add_plain(document, "p_c", place.branch->pressure(0, place.delta, place.contact));
  return profile(place);
}

int run_command(const Values& values) {
  check_output(values, true);
  const ForceLaw& law = law_option(values);
  const bool whole = values.count("delta") > 0;
  if (whole == (values.count("profile") > 0) || (whole && values.count("delta-max")))
    throw UsageError("either --delta, or --profile with or without --delta-max, is needed");
  const std::vector<NamedValue> given = parameters_option(values);
  const Range range = whole ? delta_option(values) : Range{};
  const ElasticContact contact = elastic_contact(law, given);
  Document document("law");
  document.text("law", std::string(law.name));
  add_parameters(document, given);
  add_plain(document, "R_star", contact.radius);
  const Table table = whole ? curve(law, contact, range, document)
                            : pressures(place_of(values, law, contact), document);
  add_results(document, table);
  return emit(values, document, &table);
}

/// The laws with their parameters, from the laws' own tables.
std::string describe_laws() {
  std::string text =
      "A force law as a table over delta: force F (repulsive > 0), contact radius a, pressure p_c "
      "at "
      "the\n"
      "centre, energy U (work done since the spheres were apart; on unloading what is left to be "
      "gained)\n"
      "and stiffness dF/ddelta; of laws with history also unloading from the last delta down.\n"
      "R is that of each of two equal spheres, else R1 and R2 (inf: a wall); E is the reduced "
      "modulus "
      "E*.\n";
  for (const ForceLaw* law : force_laws()) {
    text += fmt::format("\n{}: {}\n", law->name, law->summary);
    for (const ContactParameter& p : law->parameters)
      if (p.value != &ElasticContact::radius)
        text += fmt::format("  {:<15}{}\n", given_name(p), p.meaning);
  }
  text.pop_back();
  return text;
}

const std::string description = describe_laws();

}  // namespace

extern const Command law_command;
const Command law_command{
    "law",
    "",
    "a force law as a table: F, a, p_c, energy, stiffness over delta",
    description,
    "  mdana law --law jkr -p R=147 -p E=65.5 -p gamma=3.17 --delta least:8:101\n"
    "  mdana law --law andrews -p R1=1e-6 -p R2=inf -p E=3.7e9 -p Y=1e8 --delta 0:1e-8:51 -o "
    "andrews.csv\n"
    "  mdana law --law thornton -p R=147 -p E=65.5 -p gamma=3.17 -p Y=7.9 --delta least:8:101 "
    "--json\n"
    "  mdana law --law andrews -p R=147 -p E=65.5 -p Y=7.9 --profile 5 --delta-max 6 -o p.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
