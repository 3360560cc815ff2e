// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/study_options.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

void add_options(Options& options) {
  add_study_options(options, "directory of the report: index.html, results.json, .csv, .h5, runs, figures, tables, cache",
                    "print results.json on the standard output");
  options.add_options()  //
      ("only", po::value<std::string>()->default_value("")->value_name("NAME"),
       "analyse these runs only (* and ? stand for anything); others are told as far as their results are there")  //
      ("dry-run", po::bool_switch(), "tell what would be analysed and why, and write nothing");
}

int run_command(const Values& values) {
  ReportOptions options = study_options(values);
  options.only = values["only"].as<std::string>();
  if (values["dry-run"].as<bool>()) return print(planned_report(options)), done;
  return resumably([&] { return tell_report(values, make_report(options)); });
}

}  // namespace

extern const Command report_command;
const Command report_command{
    "report",
    "STUDY",
    "a whole study in one page, with tables and figures",
    "Of all runs of a study file (mdana study init writes one), or in a directory (a scene.toml with its dump\n"
    "each): one page, documents, tables, and figures as SVG, PDF, gnuplot script and CSV. Runs are analysed side by\n"
    "side. Results are kept in OUT/cache: only what is new, or was made from other files, settings or another mdana, is\n"
    "analysed anew, and a report that was stopped goes on. A run that fails is told in the page (exit code 1).",
    "  mdana report sample-data -o report\n"
    "  mdana report sample-data -o report --dry-run\n"
    "  mdana report runs/study.toml -o runs-report --only 'hertz*' --json",
    add_options,
    run_command};

}  // namespace mdana::cli
