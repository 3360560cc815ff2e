// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/force_fit.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/fitted.hpp"
#include "reports/measured.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

using Texts = std::vector<std::string>;

constexpr std::array<std::string_view, 2> part_names{"loading", "loop"};
constexpr std::array<std::string_view, 3> loss_names{"none", "huber", "cauchy"};

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()                                                                          //
      ("law", po::value<std::string>()->required()->value_name("NAME"),
       "hertz, dmt, jkr, maugis, thornton or andrews")                                           //
      ("free", po::value<Texts>()->composing()->value_name("NAMES"),
       "what is to be found, as E,gamma,R (default: all that -p does not give, and R); R is "
       "(R1 + R2)/2 at the given ratio, offset is added to delta instead")                       //
      ("parameter,p", po::value<Texts>()->composing()->value_name("NAME=VALUE"),
       "a parameter of the law that is known: E (that is E*), gamma, Y, spacing")                //
      ("part", po::value<std::string>()->default_value("loading")->value_name("NAME"),
       "fit the frames up to the greatest compression (loading), or all of contact (loop)")      //
      ("min-delta-fraction", po::value<double>()->default_value(0, "0")->value_name("P"),
       "leave out points with delta below this part of the greatest (0: all of contact, by delta or by "
       "2 % of the greatest force)")                            //
      ("loss", po::value<std::string>()->default_value("none")->value_name("NAME"),
       "damp outliers: none, huber or cauchy");
  add_error_option(options, "the frame stride");
  add_output_options(options, true);
}

/// E stands for E*, which shells take for a pattern.
std::string law_name(const std::string& name) { return name == "E" ? "E*" : name; }

const ForceLaw& law_of(const Values& values) {
  const std::string text = values["law"].as<std::string>();
  if (const ForceLaw* law = find_force_law(text)) return *law;
  std::vector<std::string_view> names;
  for (const ForceLaw* law : force_laws()) names.push_back(law->name);
  throw UsageError(fmt::format("--law {}: one of {} is expected", text, fmt::join(names, ", ")));
}

/// The law's parameters that -p gives; their names.
std::vector<std::string> set_constants(const Values& values, const ForceLaw& law, ElasticContact& contact) {
  std::vector<std::string> given;
  for (const NamedValue& value : parameters_option(values)) {
    const std::string name = law_name(value.name), text = value.name + "=" + value.text;
    const auto at = std::ranges::find(law.parameters, name, &ContactParameter::name);
    if (at == law.parameters.end() || name == "R*")
      throw UsageError(fmt::format("-p {}: NAME=VALUE of a parameter of law {} is expected (radii: --radius)",
                                   text, law.name));
    contact.*(at->value) = number_option("-p", text, value.text);
    given.push_back(name);
  }
  return given;
}

ForceFitSettings settings(const Values& values, const ForceLaw& law) {
  ForceFitSettings s;
  const std::vector<std::string> given = set_constants(values, law, s.constants);
  if (values.count("free")) {
    for (const std::string& name : names_option(values, "free")) s.free.push_back(law_name(name));
  } else {
    s.free = usual_free_parameters(law);
    std::erase_if(s.free, [&](const std::string& name) { return std::ranges::find(given, name) != given.end(); });
  }
  for (const std::string& name : s.free)
    if (std::ranges::find(given, name) != given.end())
      throw UsageError(fmt::format("{} is given by -p and free", name));
  s.part = static_cast<ForcePart>(choice(values, "part", part_names));
  s.loss = static_cast<Loss>(choice(values, "loss", loss_names));
  s.min_delta_fraction = values["min-delta-fraction"].as<double>();
  if (!(s.min_delta_fraction >= 0 && s.min_delta_fraction < 1))
    throw UsageError("0 <= --min-delta-fraction < 1 is needed");
  return s;
}

void tell(Document& document, const ForceLaw& law, const ForceFit& f, const ForceFitSettings& s) {
  document.text("law", std::string(law.name));
  for (const ForceEstimate& e : f.parameters)
    document.number("parameters." + e.name,
                    {e.value, std::isfinite(e.error) ? std::optional(e.error) : std::nullopt, e.dimension});
  document.text("part", std::string(name(s.part)));
  document.json("points", f.points.size());
  document.line("points", fmt::format("{}", f.points.size()));
  nlohmann::ordered_json correlation = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < f.correlation.rows(); ++i) {
    const Eigen::VectorXd row = f.correlation.row(i);
    correlation.push_back(std::vector<double>(row.begin(), row.end()));
  }
  document.json("correlation", correlation);
  document.json("singular_values", f.singular_values);
  document.text("weak_direction", f.weak_direction);
  document.json("known_errors", f.known_errors);
  document.json("chi2", f.chi2);
  document.json("rms_residual", f.rms_residual);
  document.line("rms residual", fmt::format("{:.3g} of the greatest force", f.rms_residual));
  document.json("digits", f.fit.digits);
  document.line("digits of the optimum", fmt::format("{:.1f}", f.fit.digits));
  document.json("fit_seconds", f.fit.seconds);
  document.json("usable", f.fit.usable);
  document.json("reason", f.fit.reason);
  if (!f.fit.usable) document.warn("the fit is not usable: " + f.fit.reason);
  if (f.rms_residual > 0.1)
    document.warn(fmt::format("law {} does not describe these forces: residuals of {:.0f} % of the greatest "
                              "force, so its parameters mean little", law.name, 100 * f.rms_residual));
}

Table table_of(const ForceFit& f, const ForceCurve& curve) {
  Table table({{"frame", dimension::none},
               {"X", dimension::length},
               {"delta", dimension::length},
               {"F", dimension::force},
               {"F_error", dimension::force},
               {"F_fit", dimension::force},
               {"residual", dimension::force}});
  for (std::size_t k = 0; k < f.points.size(); ++k) {
    const std::size_t i = f.points[k];
    table.add_row(std::array{static_cast<double>(i), curve.distance[i],
                             f.radius_sum - curve.distance[i] + f.offset, curve.force[i],
                             curve.force_error[i], f.model[k], f.model[k] - curve.force[i]});
  }
  return table;
}

int run_command(const Values& values) {
  check_output(values, true);
  const ForceLaw& law = law_of(values);
  const ForceFitSettings wanted = settings(values, law);
  const RunOptions options = run_options(values);
  SweepOptions sweeping = sweep_options(values);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const ForceSource source = best_force_source(run);
  DumpQuestion question{run, options, sweeping};
  question.law = &law;
  question.force_fit = wanted;
  const auto chosen = choose_stride(values, fit_force_subject(question), sweeping);
  const MeasuredMotion measured = measure_motion(run, parts_for(source), {}, sweeping);
  const Radii radii = find_radii(run, options);
  const ForceCurve curve = touching_force_curve(run, measured.motion, source, radii);
  const ForceFit fit = told_of(run, [&] { return fit_force(law, force_data(curve, radii), wanted); });

  Document document("fit-force", run);
  document.sweep(measured.swept, run.format);
  document.json("force_source", name(source));
  document.line("force from", std::string(description(source)));
  tell(document, law, fit, wanted);
  tell_choice(document, chosen);
  const Table table = table_of(fit, curve);
  const int code = emit(values, document, &table);
  return fit.fit.usable ? choice_code(chosen, code) : not_converged;
}

}  // namespace

extern const Command fit_force_command;
const Command fit_force_command{
    "fit-force",
    "DUMP",
    "parameters of a force law from F(delta)",
    "Fits a law of the force between two bodies to F(delta) of a dump: E*, gamma and what else the law\n"
    "has, together with R or with an offset of delta. Errors are those of the data; compare laws, parts\n"
    "and ranges to see what the choice does. The table (-o FILE.csv) has the fitted points.",
    "  mdana fit-force --law hertz sample-data/hertz-tiny/dump.lammpstrj.gz\n"
    "  mdana fit-force --law jkr adhesive-small/dump.lammpstrj.gz\n"
    "  mdana fit-force --law jkr --part loop --free E,R -p gamma=3.17 dump.lammpstrj\n"
    "  mdana fit-force --law dmt --free E,gamma,offset --radius 10 dump.lammpstrj --json",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
