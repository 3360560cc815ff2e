// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <limits>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/collision_summary.hpp"
#include "reports/compression_study.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

/// What the command line asks of every run.
struct Wishes {
  RunOptions run;
  SweepOptions sweeping;
  Split split = Split::sign;
  std::optional<SurfaceOffset> offset;
};

std::optional<SurfaceOffset> offset_option(const Values& values) {
  if (!values.count("offset")) return std::nullopt;
  const double offset = values["offset"].as<double>();
  if (!std::isfinite(offset)) throw UsageError("--offset must be a finite number");
  return SurfaceOffset{{offset, {}, dimension::length}, "option"};
}

Wishes wishes(const Values& values) {
  return {run_options(values), sweep_options(values),
          static_cast<Split>(choice(values, "split", split_names)), offset_option(values)};
}

std::vector<std::string> dumps_of(const Values& values) {
  std::vector<std::string> dumps{values["input"].as<std::string>()};
  if (values.count("more"))
    for (const std::string& dump : values["more"].as<std::vector<std::string>>()) dumps.push_back(dump);
  return dumps;
}

CompressedRun measure(const Run& run, const Wishes& wanted) {
  require_two_bodies(run);
  return measure_compression(run, wanted.run, wanted.sweeping);
}

Document document_of(const Run& run, const CompressedRun& compressed, Split split, const SurfaceOffset& offset) {
  Document document("compress", run);
  document.sweep(compressed.measured.swept, run.format);
  Plan plan = plan_command(run, "compress");
  settle(plan, compressed);
  add_plan(document, plan);
  add_compression(document, compressed, split, offset);
  return document;
}

int run_single(const Values& values, Wishes wanted) {
  const Run run = prepare_run(wanted.run);
  const SurfaceOffset offset = wanted.offset.value_or(SurfaceOffset{});
  const DumpQuestion question{run, wanted.run, wanted.sweeping, {}, {}, {}, {}, wanted.split, offset};
  const auto chosen = choose_stride(values, compress_subject(question), wanted.sweeping);
  const CompressedRun compressed = measure(run, wanted);
  Document document = document_of(run, compressed, wanted.split, offset);
  const Compressing c = compressing(compressed, offset);
  add_degeneracy(document, c.impact, c.by[static_cast<std::size_t>(wanted.split)].delta);
  tell_choice(document, chosen);
  const Table table = compression_table(compressed, wanted.split);
  return choice_code(chosen, emit(values, document, &table));
}

/// The runs of a study; one that cannot be analysed does not stop the others.
class Series {
 public:
  void add(const Wishes& wanted) {
    const std::string dump = wanted.run.dump.string();
    try {
      Run run = prepare_run(wanted.run);
      measured_.push_back(measure(run, wanted));
      told_.push_back(std::move(run));
      failures_.emplace_back();
    } catch (const InputError& error) {
      failures_.push_back({dump, error.what()});
      std::cerr << fmt::format("mdana: {}: failed: {}\n", dump, error.what());
    }
  }

  int emit(const Values& values, const Wishes& wanted) {
    if (measured_.empty()) throw InputError("none of the runs can be analysed");
    const CompressionStudy study = study_compression(std::move(measured_), wanted.split, wanted.offset);
    tell_runs(study);
    add_compression_study(document_, study);
    const Table table = compression_study_table(study);
    const int code = cli::emit(values, document_, &table);
    if (told_.size() < failures_.size()) return failed;
    if (damaged_) return damaged_input;
    return study.fit_failed() ? not_converged : code;
  }

 private:
  struct Failure {
    std::string dump, what;  ///< empty: the run could be analysed
  };

  void tell_runs(const CompressionStudy& study) {
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    std::vector<SeriesOutcome> outcomes;
    std::size_t next = 0;
    for (const Failure& failure : failures_) {
      if (!failure.what.empty()) {
        runs.push_back({{"dump", failure.dump}, {"failure", failure.what}});
        outcomes.push_back({failure.dump, failure.what, {}, unknown_, unknown_, unknown_});
        document_.line(failure.dump, "failed");
        continue;
      }
      const CompressedRun& run = study.runs[next];
      const Document one = document_of(told_[next], run, study.split, study.offset);
      runs.push_back(one.content());
      tell_run(study, next++, one);
      outcomes.push_back({run.dump, {}, run.curve.outcome, run.restitution.e, run.restitution.e_total,
                          run.restitution.speed_before});
    }
    document_.json("runs", std::move(runs));
    add_summary(document_, outcomes);
  }

  void tell_run(const CompressionStudy& study, std::size_t run, const Document& one) {
    const MaximumCompression& m = study.maximum(run);
    document_.line(study.runs[run].dump,
                   fmt::format("{}, delta_max_eff {}, t_max {}", name(study.runs[run].curve.outcome),
                               to_text(m.delta, one.units()), to_text(m.time, one.units())));
    for (const std::string& w : one.warnings()) document_.warn(study.runs[run].dump + ": " + w);
    damaged_ = damaged_ || one.damaged();
  }

  static constexpr Value unknown_{std::numeric_limits<double>::quiet_NaN(), {}, dimension::none};
  Document document_{"compress"};
  std::vector<Failure> failures_;  ///< one a dump
  std::vector<Run> told_;          ///< of those that could be analysed
  std::vector<CompressedRun> measured_;
  bool damaged_ = false;
};

int run_series(const Values& values, Wishes each, const std::vector<std::string>& dumps) {
  Series series;
  for (const std::string& dump : dumps) {
    each.run.dump = dump;
    series.add(each);
  }
  return series.emit(values, each);
}

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()                                                                                    //
      ("split", po::value<std::string>()->default_value("sign")->value_name("HOW"),
       "what an atom counts for: sign (the side of the contact plane where it is) or membership (its body); "
       "both are told")                                                                                    //
      ("offset", po::value<double>()->value_name("LENGTH"),
       "R_eff = R_agg - LENGTH (default: from delta_max against R_agg if there are several radii, else 0)");
  add_error_option(options, "the frame stride of a single run");
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const Wishes wanted = wishes(values);
  const std::vector<std::string> dumps = dumps_of(values);
  if (dumps.size() > 1 && wanted_error(values)) throw UsageError("--error is of a single run");
  return dumps.size() == 1 ? run_single(values, wanted) : run_series(values, wanted, dumps);
}

}  // namespace

extern const Command compress_command;
const Command compress_command{
    "compress",
    "DUMP...",
    "greatest compression of colliding aggregates: delta_max, t_max, outcome; E*, Y",
    "Of one run of two dust aggregates delta(t), v_rel(t) (the table, -o FILE.csv), delta_max and t_max with\n"
    "their errors, the outcome, the return, and the pairs E*, Y of Andrews' law that delta_max allows. Of several\n"
    "runs of one filling factor besides delta_max against R_agg with the offset of the effective surface, the\n"
    "dispersion of repeated runs, sticking statistics, and E* and Y by delta_max and t_max over velocities, with\n"
    "the elastic and the rigid plastic limit (Arakawa et al. 2024); the table has a row a run then. If the\n"
    "runs do not determine E* and Y, the exit code is 4 and the reason says what they determine.",
    "  mdana compress sample-data/aggregate-tiny/dump.lammpstrj.gz\n"
    "  mdana compress run/dump.lammpstrj.gz --split membership --offset 50 -o compression.csv\n"
    "  mdana compress v5/dump.lammpstrj.gz v10/dump.lammpstrj.gz v20/dump.lammpstrj.gz --json",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
