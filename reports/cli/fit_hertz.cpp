// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/fitted.hpp"
#include "reports/measured.hpp"
#include "reports/hertz_sizes.hpp"
#include "reports/plan.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 2> method_names{"force", "linear"};
constexpr std::array<std::string_view, 2> phase_names{"loading", "all"};
constexpr std::array<std::string_view, 3> loss_names{"none", "huber", "cauchy"};
constexpr std::array<std::string_view, 2> weight_names{"equal", "errors"};
constexpr std::array<std::string_view, 2> row_names{"run", "size"};

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
       "damp outliers: none, huber or cauchy")                                                 //
      ("weights", po::value<std::string>()->default_value("equal")->value_name("NAME"),
       "weigh points alike (equal) or by the errors of their forces (errors)")                 //
      ("rows", po::value<std::string>()->default_value("run")->value_name("NAME"),
       "of the table of several dumps: a run or a size (bodies whose atoms differ by 1 % at most)");
  add_error_option(options, "the frame stride, dump by dump,");
  add_output_options(options, true);
}

HertzSettings settings(const Values& values) {
  HertzSettings s;
  s.method = static_cast<HertzMethod>(choice(values, "method", method_names));
  s.phase = static_cast<HertzPhase>(choice(values, "phase", phase_names));
  s.loss = static_cast<Loss>(choice(values, "loss", loss_names));
  s.weights = static_cast<HertzWeights>(choice(values, "weights", weight_names));
  s.min_force_fraction = values["min-force-fraction"].as<double>();
  s.max_force_fraction = values["max-force-fraction"].as<double>();
  if (!(s.min_force_fraction >= 0 && s.min_force_fraction < s.max_force_fraction))
    throw UsageError("0 <= --min-force-fraction < --max-force-fraction is needed");
  return s;
}

/// What one dump gives.
struct Told {
  Document document;
  Table points;
  HertzResult hertz;
  double atoms;  ///< of the first body
  std::optional<Recommendation> chosen = {};  ///< for --error
};

Told analyse(const Values& values, const RunOptions& options, SweepOptions sweeping, const HertzSettings& wanted) {
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const ForceSource source = best_force_source(run);
  const auto chosen = choose_stride(values, fit_hertz_subject({run, options, sweeping, {}, {}, source, wanted}), sweeping);
  const MeasuredMotion measured = measure_motion(run, parts_for(source), {}, sweeping);
  const Radii radii = find_radii(run, options);
  require_known_ratio(run, measured.swept.tables[0], radii);
  const ForceCurve curve = touching_force_curve(run, measured.motion, source, radii);
  const HertzResult hertz =
      told_of(run, [&] { return fit_hertz_with_spread(hertz_data(curve, radii), wanted); });

  Told told{Document("fit-hertz", run), hertz_table(hertz, curve), hertz,
            measured.swept.tables[0].column("atoms1")[0], chosen};
  told.document.sweep(measured.swept, run.format);
  add_plan(told.document, plan_command(run, "fit-hertz"));
  told.document.json("force_source", name(source));
  told.document.line("force from", std::string(description(source)));
  add_hertz(told.document, run, hertz);
  tell_choice(told.document, chosen);
  return told;
}

/// Fits of several dumps: each its own, and what those of one size say together.
class Series {
 public:
  void add(const Values& values, const RunOptions& options, const SweepOptions& sweeping, const HertzSettings& wanted) {
    const std::string dump = options.dump.string();
    try {
      const Told told = analyse(values, options, sweeping, wanted);
      runs_.push_back(told.document.content());
      for (const std::string& w : told.document.warnings()) document_.warn(dump + ": " + w);
      damaged_ = damaged_ || told.document.damaged();
      met_ = met_ && choice_code(told.chosen, done) == done;
      add_row(told.atoms, told.hertz);
      const Units units = told.document.units();
      document_.set_units(units);
      const bool usable = told.hertz.fit.fit.usable;
      document_.line(dump, usable ? fmt::format("E_star {}, R {}", to_text(told.hertz.modulus, units),
                                                to_text(told.hertz.radius, units))
                                  : "not usable");
      if (usable) fitted_.push_back({told.atoms, told.hertz.modulus, told.hertz.radius});
    } catch (const InputError& error) {
      runs_.push_back({{"dump", dump}, {"failure", error.what()}});
      document_.line(dump, "failed");
      std::cerr << fmt::format("mdana: {}: failed: {}\n", dump, error.what());
      failed_ = true;
    }
  }

  int emit(const Values& values) {
    const std::vector<HertzSize> sizes = pool_by_size(fitted_);
    document_.json("runs", std::move(runs_));
    document_.json("pooled_runs", fitted_.size());
    add_sizes(document_, sizes);
    const bool by_size = choice(values, "rows", row_names) == 1;
    const Table table = by_size ? size_table(sizes) : table_;
    const int code = cli::emit(values, document_, &table);
    return failed_ ? failed : damaged_ ? damaged_input : fitted_.empty() || !met_ ? not_converged : code;
  }

 private:
  void add_row(double atoms, const HertzResult& h) {
    table_.add_row(std::array{static_cast<double>(runs_.size() - 1), atoms, h.radius.value, *h.radius.error,
                              h.modulus.value, *h.modulus.error, h.fit.rms_residual,
                              h.fit.fit.usable ? 1.0 : 0.0});
  }

  Document document_{"fit-hertz"};
  nlohmann::ordered_json runs_ = nlohmann::ordered_json::array();
  std::vector<HertzRun> fitted_;
  Table table_{{{"run", dimension::none},
                {"N", dimension::none},
                {"R", dimension::length},
                {"R_error", dimension::length},
                {"E_star", dimension::pressure},
                {"E_star_error", dimension::pressure},
                {"rms_residual", dimension::none},
                {"usable", dimension::none}}};
  bool failed_ = false, damaged_ = false, met_ = true;
};

int run_command(const Values& values) {
  check_output(values, true);
  RunOptions options = run_options(values);
  const SweepOptions sweeping = sweep_options(values);
  const HertzSettings wanted = settings(values);
  choice(values, "rows", row_names);
  if (!values.count("more")) {
    const Told told = analyse(values, options, sweeping, wanted);
    const int code = emit(values, told.document, &told.points);
    return told.hertz.fit.fit.usable ? choice_code(told.chosen, code) : not_converged;
  }
  Series series;
  series.add(values, options, sweeping, wanted);
  for (const std::string& dump : values["more"].as<std::vector<std::string>>()) {
    options.dump = dump;
    series.add(values, options, sweeping, wanted);
  }
  return series.emit(values);
}

}  // namespace

extern const Command fit_hertz_command;
const Command fit_hertz_command{
    "fit-hertz",
    "DUMP...",
    "reduced modulus E* and radius R from a Hertz fit",
    "Fits F(X) = 4/3 E* sqrt(R*) (R1 + R2 - X)^1.5 and tells what the choice of method, force range and\n"
    "phase does to E* and R: that spread is the real error of E*, and is what 'error' means in the\n"
    "output. Of unequal bodies F(X) tells E* sqrt(R*) and R1 + R2 = 2R; E* needs their ratio by --radius.\n"
    "The table (-o FILE.csv) has the fitted points. Of several dumps, as of other orientations, each is\n"
    "fitted, E* and R of equal bodies are pooled with their spread within and between runs, and the table has a\n"
    "run or a size a row (as Table II of Yoshida, Kokubo & Tanaka 2024).",
    "  mdana fit-hertz sample-data/hertz-tiny/dump.lammpstrj.gz\n"
    "  mdana fit-hertz hertz-small/dump.lammpstrj.gz --method linear --min-force-fraction 0.1\n"
    "  mdana fit-hertz run-1/dump.lammpstrj.gz run-2/dump.lammpstrj.gz run-3/dump.lammpstrj.gz\n"
    "  mdana fit-hertz r8-*/dump.lammpstrj.gz r10-*/dump.lammpstrj.gz --rows size -o sizes.csv\n"
    "  mdana fit-hertz dump.lammpstrj --units lj --timestep 0.0078125 --json -o fit.csv",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
