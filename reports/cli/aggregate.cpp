// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fits/aggregate_constants.hpp"
#include "reports/cli/command.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Constants of the grains, and E* of the two aggregates; NaN where not given.
struct AggregateInput {
  double r = unknown, modulus = unknown, nu = unknown, gamma = unknown, xi_c = unknown,
         aggregate_modulus = unknown;
};

struct InputName {
  std::string_view name;
  double AggregateInput::*value;
};

constexpr InputName input_names[] = {
    {"r", &AggregateInput::r},       {"E", &AggregateInput::modulus},
    {"nu", &AggregateInput::nu},     {"gamma", &AggregateInput::gamma},
    {"xi_c", &AggregateInput::xi_c}, {"E_aggregate", &AggregateInput::aggregate_modulus}};

void set(AggregateInput& input, const NamedValue& given) {
  const auto it = std::ranges::find(input_names, given.name, &InputName::name);
  if (it == std::end(input_names))
    throw UsageError(
        fmt::format("-p {}: r, E, nu, gamma, xi_c or E_aggregate is expected", given.name));
  double& value = input.*it->value;
  if (!std::isnan(value)) throw UsageError(fmt::format("-p {}: given twice", given.name));
  value = number_option("-p", given.name + "=" + given.text, given.text);
  const bool ratio = given.name == "nu";
  if (ratio ? value <= -1 || value > 0.5 : value <= 0)
    throw UsageError(fmt::format("-p {}={:g}: must be {}", given.name, value,
                                 ratio ? "above -1 and at most 0.5" : "positive"));
}

/// "0.4", or "FIRST:LAST:COUNT".
std::vector<double> fillings(const Values& values) {
  const std::string text = values["filling-factor"].as<std::string>();
  const std::string expected = fmt::format(
      "--filling-factor {}: a number above 0 and below {:.4f} is expected, or FIRST:LAST:COUNT of "
      "such",
      text, largest_filling);
  std::vector<double> all;
  if (text.find(':') == text.npos) {
    all.push_back(finite_number(text, expected));
  } else {
    const auto [first, last, count] = three_parts(text, expected);
    all = evenly(finite_number(first, expected), finite_number(last, expected),
                 count_number(count, expected));
  }
  for (const double phi : all)
    if (!(phi > 0 && phi < largest_filling)) throw UsageError(expected);
  return all;
}

/// Numbers that need what is not given are NaN.
Table estimates(const AggregateInput& in, const std::vector<double>& phis) {
  Table table(std::vector<ColumnSpec>{{"filling_factor", dimension::none},
                                      {"coordination_cpe", dimension::none},
                                      {"coordination_bcca", dimension::none},
                                      {"bulk_modulus_cpe", dimension::pressure},
                                      {"bulk_modulus_bcca", dimension::pressure},
                                      {"poisson_ratio_cpe", dimension::none},
                                      {"static_yield_stress", dimension::pressure}});
  const double stiffness = contact_stiffness(grain_contact(in.r, in.modulus, in.nu, in.gamma));
  for (const double phi : phis) {
    const double cpe = cpe_coordination(phi), bcca = bcca_coordination(phi);
    const double bulk = bulk_modulus(phi, cpe, stiffness, in.r);
    const double row[] = {phi,
                          cpe,
                          bcca,
                          bulk,
                          bulk_modulus(phi, bcca, stiffness, in.r),
                          aggregate_poisson_ratio(in.aggregate_modulus, bulk),
                          static_yield_stress(phi, in.r, in.gamma, in.xi_c)};
    table.add_row(row);
  }
  return table;
}

std::string cell(double value) { return std::isnan(value) ? "-" : fmt::format("{:.6g}", value); }

void add_results(Document& document, const Table& table) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    nlohmann::ordered_json entry;
    std::string text;
    for (std::size_t c = 0; c < table.columns().size(); ++c) {
      const double value = table.column(c)[row];
      const std::string& name = table.columns()[c].name;
      entry[name] =
          std::isnan(value) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(value);
      if (c > 0) text += fmt::format("{}{} {}", c > 1 ? "  " : "", name, cell(value));
    }
    document.line(fmt::format("phi = {:.6g}", table.column(0)[row]), text);
    list.push_back(std::move(entry));
  }
  document.json("results", std::move(list));
}

void add_options(Options& options) {
  options.add_options()  //
      ("filling-factor", po::value<std::string>()->required()->value_name("PHI"),
       "one, or FIRST:LAST:COUNT")  //
      ("parameter,p", po::value<std::vector<std::string>>()->composing()->value_name("NAME=VALUE"),
       "a constant, in any consistent units")                                        //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"), output_help(true).c_str());
}

int run_command(const Values& values) {
  check_output(values, true);
  AggregateInput input;
  for (const NamedValue& given : parameters_option(values)) set(input, given);
  const std::vector<double> phis = fillings(values);
  Document document("aggregate");
  const Table table = estimates(input, phis);
  add_results(document, table);
  return emit(values, document, &table);
}

}  // namespace

extern const Command aggregate_command;
const Command aggregate_command{
    "aggregate",
    "",
    "estimates for aggregates of grains over the filling factor",
    "Coordination of CPE aggregates (close packing less random grains) and of compressed BCCA; "
    "bulk modulus\n"
    "if every contact is at the equilibrium of JKR; Poisson's ratio that goes with E*; static "
    "yield stress of\n"
    "compressed BCCA (Arakawa et al. 2024, Sec. 5: orders of magnitude).\n"
    "Constants: radius r, Young's modulus E, Poisson's ratio nu and surface energy gamma of the "
    "grains, xi_c\n"
    "where rolling becomes inelastic, reduced modulus E_aggregate of two aggregates.",
    "  mdana aggregate --filling-factor 0.4\n"
    "  mdana aggregate --filling-factor 0.1:0.7:13 -p r=1e-7 -p E=7e9 -p nu=0.25 -p gamma=0.1 -p "
    "xi_c=8e-10 -o "
    "aggregate.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
