// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iostream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/atomic_file.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/csv.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

std::filesystem::path output_of(const Values& values) {
  return values.count("output") ? values["output"].as<std::string>() : std::string();
}

std::string text_of(const Values& values, const char* option) {
  return values.count(option) ? values[option].as<std::string>() : std::string();
}

}  // namespace

void add_run_options(Options& options) {
  options.add_options()                                                                           //
      ("scene", po::value<std::string>()->value_name("FILE"),
       "scene file (default: scene.toml beside the dump, if it names the dump)")                  //
      ("units", po::value<std::string>()->value_name("NAME"),
       "units of the dump, by LAMMPS' names (default: from the dump or the scene)")               //
      ("masses", po::value<std::string>()->value_name("LIST"),
       "masses by atom type, as 1=39.95,2=107.87 (default: dump, scene, in lj units 1)")          //
      ("bodies", po::value<std::string>()->value_name("RULE"),
       "what tells the bodies apart: type, mol, clusters or id:FIRST-LAST (default: scene; types "
       "if there are exactly two, else mol, else clusters)")                                      //
      ("radius", po::value<std::string>()->value_name("R[,R2]"),
       "radius of the bodies, for delta (default: scene, else sqrt(5/3) r_g)")                    //
      ("timestep", po::value<double>()->value_name("DT"),
       "time between steps (default: times in the dump, else scene)");
}

RunOptions run_options(const Values& values) {
  RunOptions options;
  options.dump = text_of(values, "input");
  options.scene = text_of(values, "scene");
  options.units = text_of(values, "units");
  options.masses = text_of(values, "masses");
  options.bodies = text_of(values, "bodies");
  options.radius = text_of(values, "radius");
  if (values.count("timestep")) {
    options.timestep = values["timestep"].as<double>();
    if (!(*options.timestep > 0) || !std::isfinite(*options.timestep))
      throw UsageError("--timestep must be greater than zero");
  }
  return options;
}

void add_output_options(Options& options, bool table) {
  options.add_options()                                                                         //
      ("stride", po::value<long>()->default_value(1)->value_name("K"),
       "use every K-th frame only")                                                             //
      ("memory", po::value<long>()->default_value(128)->value_name("MB"),
       "memory for the atoms of a frame that are looked at twice; beyond it they are read twice") //
      ("json", po::bool_switch(), "print one JSON document on the standard output")             //
      ("output,o", po::value<std::string>()->value_name("FILE"),
       table ? "write the table (.csv) or the document (.json)" : "write the document (.json)");
}

SweepOptions sweep_options(const Values& values) {
  SweepOptions options;
  if (values["stride"].as<long>() < 1) throw UsageError("--stride must be at least 1");
  if (values["memory"].as<long>() < 1) throw UsageError("--memory must be at least 1");
  options.stride = static_cast<std::uint64_t>(values["stride"].as<long>());
  options.memory = static_cast<std::size_t>(values["memory"].as<long>()) << 20;
  options.stop = &stop_signal();
  options.progress = progress_printer();
  return options;
}

void check_output(const Values& values) {
  const auto output = output_of(values);
  if (output.empty() || output.extension() == ".json" || output.extension() == ".csv") return;
  throw UsageError(fmt::format("-o {}: the name must end in .csv or .json", output.string()));
}

int emit(const Values& values, const Document& document, const Table* table) {
  const auto output = output_of(values);
  if (output.extension() == ".json") write_file(output, document.to_json());
  if (output.extension() == ".csv") {
    if (!table) throw UsageError("this command has no table; use -o FILE.json");
    write_file(output, to_csv(*table));
  }
  std::cout << (values["json"].as<bool>() ? document.to_json() : document.to_terminal())
            << std::flush;
  if (!std::cout) throw std::runtime_error("cannot write to the standard output");
  return document.damaged() ? damaged_input : done;
}

std::size_t choice(const Values& values, const std::string& option,
                   std::span<const std::string_view> names) {
  const std::string& value = values[option].as<std::string>();
  const auto it = std::find(names.begin(), names.end(), value);
  if (it == names.end())
    throw UsageError(fmt::format("--{} {}: one of {} expected", option, value,
                                 fmt::join(names, ", ")));
  return static_cast<std::size_t>(it - names.begin());
}

}  // namespace mdana::cli
