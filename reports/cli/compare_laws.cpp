// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "fits/residual_pattern.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/contact_options.hpp"
#include "reports/cli/error_option.hpp"

namespace mdana::cli {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string parameters_text(const ContactFit& fit) {
  std::string text;
  for (const Estimate& p : fit.parameters)
    text += fmt::format("{}{} {:.4g} ± {:.2g}", text.empty() ? "" : ", ", p.full_name(), p.value, p.error);
  return text.empty() ? "nothing free" : text;
}

Json law_json(const ComparedLaw& j, const std::vector<std::string>& fails) {
  Json json{{"law", j.law->name}, {"k", j.fit.parameters.size()}};
  json["parameters"] = Json::object();
  for (const Estimate& p : j.fit.parameters)
    json["parameters"][p.full_name()] = {{"value", number(p.value)}, {"error", number(p.error)}, {"interval", nullptr}};
  json["chi2"] = number(j.fit.chi2);
  json["aic"] = number(j.fit.aic);
  json["bic"] = number(j.fit.bic);
  json["cross_validation"] = {{"velocity", number(j.fit.left_out_velocity)}, {"radius", number(j.fit.left_out_radius)}};
  json["fails"] = fails;
  json["usable"] = j.fit.usable;
  json["reason"] = j.fit.reason;
  json["seconds"] = j.fit.seconds;
  return json;
}

void tell(Document& document, const ComparedLaw& j, std::span<const ObservedCollision> seen, Json& laws) {
  const std::vector<std::string> fails = describe_residuals(seen, j.fit.points);
  const std::string law(j.law->name);
  const auto known = [](double rms) { return std::isnan(rms) ? std::string("-") : fmt::format("{:.3g}", rms); };
  document.line(law, fmt::format("k {}, chi2 {:.5g}, AIC {:.5g}, BIC {:.5g}, left out v: {}, R: {}", j.fit.parameters.size(),
                                 j.fit.chi2, j.fit.aic, j.fit.bic, known(j.fit.left_out_velocity),
                                 known(j.fit.left_out_radius)));
  document.line("", parameters_text(j.fit));
  for (const std::string& f : fails) document.line("", f);
  if (!j.fit.usable) document.line("", "not usable: " + j.fit.reason);
  laws.push_back(law_json(j, fails));
}

Table comparison_table(const std::vector<ComparedLaw>& all) {
  std::vector<std::string> names;
  for (const ComparedLaw& j : all) names.emplace_back(j.law->name);
  Table table(std::vector<ColumnSpec>{{"law", dimension::none, names}, {"k", dimension::none}, {"chi2", dimension::none},
                                      {"aic", dimension::none}, {"bic", dimension::none},
                                      {"left_out_velocity", dimension::none}, {"left_out_radius", dimension::none},
                                      {"usable", dimension::none, {"no", "yes"}}});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ContactFit& f = all[i].fit;
    table.add_row(std::array{static_cast<double>(i), static_cast<double>(f.parameters.size()), f.chi2, f.aic, f.bic,
                             f.left_out_velocity, f.left_out_radius, f.usable ? 1.0 : 0.0});
  }
  return table;
}

void add_options(Options& options) {
  add_error_option(options, "the starts");
  add_contact_fit_options(options);
}

int run_command(const Values& values) {
  check_output(values, true);
  ContactFitSettings settings = contact_settings(values);
  settings.cross_validation = true;
  const Observations observations = observations_option(values, {});
  Document document("compare-laws");
  add_inputs(document, observations);
  document.json("observations", observations.seen.size());
  document.line("observations", fmt::format("{}", observations.seen.size()));
  const auto chosen = choose_starts(values, compare_laws_subject(observations, settings), settings);
  const ComparedLaws compared = compare_laws(observations, settings);
  for (const auto& [law, reason] : compared.left_out) document.left_out(law, reason);
  const std::vector<ComparedLaw>& all = compared.laws;
  if (all.empty()) throw InputError("no law can be computed from the tables: " + observations.seen.front().place);
  Json laws = Json::array();
  for (const ComparedLaw& j : all) tell(document, j, observations.seen, laws);
  document.json("laws", std::move(laws));
  const auto best = std::ranges::find_if(all, [](const ComparedLaw& j) { return j.fit.usable; });
  if (best != all.end())
    document.text("best", std::string(best->law->name));
  else
    document.left_out("best", "no fit is usable");
  if (!observations.known_errors)
    document.warn("no standard errors are given: AIC and BIC take the scatter about each fit for the error");
  tell_choice(document, chosen);
  const Table table = comparison_table(all);
  return choice_code(chosen, emit(values, document, &table));
}

}  // namespace

extern const Command compare_laws_command;
const Command compare_laws_command{
    "compare-laws",
    "INPUT...",
    "all contact laws on the same collisions: AIC, BIC, cross-validation, where each fails",
    "Fits every law whose constants are known to the tables of fit-contact, with what is usually free in it and not\n"
    "given, and tells of each: number of free parameters k, chi2, AIC, BIC, the root mean square residual of a\n"
    "velocity and of a radius that were left out of the fit (- with one of them), and where it fails. The best has the least AIC\n"
    "of those that are usable.",
    "  mdana compare-laws runs.csv --table2\n"
    "  mdana compare-laws runs.csv -p E=65.5 -p gamma=3.17 -p nu=0.25 --loss huber --json",
    add_options,
    run_command};

}  // namespace mdana::cli
