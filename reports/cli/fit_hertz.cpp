// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/cli/command.hpp"
#include "reports/fitted.hpp"
#include "reports/measured.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 2> method_names{"force", "linear"};
constexpr std::array<std::string_view, 2> phase_names{"loading", "all"};
constexpr std::array<std::string_view, 3> loss_names{"none", "huber", "cauchy"};

void add_options(Options& options) {
  const HertzSettings defaults;
  add_run_options(options);
  options.add_options()                                                                        //
      ("method", po::value<std::string>()->default_value("force")->value_name("NAME"),
       "least squares in F (force) or in F^(2/3) (linear)")                                    //
      ("min-force-fraction",
       po::value<double>()->default_value(defaults.min_force_fraction, "0.05")->value_name("P"),
       "leave out points with F below this part of F_max")                                     //
      ("max-force-fraction",
       po::value<double>()->default_value(defaults.max_force_fraction, "1")->value_name("P"),
       "leave out points with F above this part of F_max")                                     //
      ("phase", po::value<std::string>()->default_value("loading")->value_name("NAME"),
       "fit the frames up to the greatest compression (loading) or all")                       //
      ("loss", po::value<std::string>()->default_value("none")->value_name("NAME"),
       "damp outliers: none, huber or cauchy");
  add_output_options(options, true);
}

HertzSettings settings(const Values& values) {
  HertzSettings s;
  s.method = static_cast<HertzMethod>(choice(values, "method", method_names));
  s.phase = static_cast<HertzPhase>(choice(values, "phase", phase_names));
  s.loss = static_cast<Loss>(choice(values, "loss", loss_names));
  s.min_force_fraction = values["min-force-fraction"].as<double>();
  s.max_force_fraction = values["max-force-fraction"].as<double>();
  if (!(s.min_force_fraction >= 0 && s.min_force_fraction < s.max_force_fraction))
    throw UsageError("0 <= --min-force-fraction < --max-force-fraction is needed");
  return s;
}

int run_command(const Values& values) {
  check_output(values, true);
  const RunOptions options = run_options(values);
  const SweepOptions sweeping = sweep_options(values);
  const HertzSettings wanted = settings(values);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const ForceSource source = best_force_source(run);
  const MeasuredMotion measured = measure_motion(run, parts_for(source), {}, sweeping);
  const Radii radii = find_radii(run, options);
  require_equal_bodies(run, measured.swept.tables[0], radii);
  const ForceCurve curve = touching_force_curve(run, measured.motion, source, radii);
  const HertzResult hertz =
      told_of(run, [&] { return fit_hertz_with_spread(hertz_data(curve), wanted); });

  Document document("fit-hertz", run);
  document.sweep(measured.swept, run.format);
  document.json("force_source", name(source));
  document.line("force from", std::string(description(source)));
  add_hertz(document, run, hertz);
  const Table table = hertz_table(hertz, curve);
  const int code = emit(values, document, &table);
  return hertz.fit.fit.usable ? code : not_converged;
}

}  // namespace

extern const Command fit_hertz_command;
const Command fit_hertz_command{
    "fit-hertz",
    "DUMP",
    "reduced modulus E* and radius R from a Hertz fit",
    "Fits F(X) = 4/3 E* sqrt(R/2) (2R - X)^1.5 for two equal bodies and tells what the choice of\n"
    "method, force range and phase does to E* and R: that spread is the real error of E*, and is\n"
    "what 'error' means in the output. The table (-o FILE.csv) has the fitted points.",
    "  mdana fit-hertz hertz-small/dump.lammpstrj.gz\n"
    "  mdana fit-hertz hertz-small/dump.lammpstrj.gz --method linear --min-force-fraction 0.1\n"
    "  mdana fit-hertz dump.lammpstrj --units lj --timestep 0.0078125 --json -o fit.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
