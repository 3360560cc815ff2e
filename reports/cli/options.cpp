// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "readers/ranks.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/sink.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

std::filesystem::path output_of(const Values& values) {
  return values.count("output") ? values["output"].as<std::string>() : std::string();
}

/// The sink that the name's ending asks for; none that needs a table if there is none.
const Sink* sink_of(const std::filesystem::path& output, bool table) {
  for (const Sink* sink : sinks())
    if (output.extension() == sink->ending && (table || !sink->needs_table)) return sink;
  return nullptr;
}

/// "a, b or c" of the sinks that can be used.
template <class Tell>
std::string listed(bool table, Tell&& tell) {
  std::vector<std::string> words;
  for (const Sink* sink : sinks())
    if (table || !sink->needs_table) words.push_back(tell(*sink));
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? " or " : ", ") + words[k];
  return text;
}

std::string text_of(const Values& values, const char* option) {
  return values.count(option) ? values[option].as<std::string>() : std::string();
}

/// Bytes of "512M", "2G" or, in MB, "512".
std::size_t bytes_of(const std::string& text) {
  std::size_t count = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, count);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  const int bits = unit == "K" ? 10 : unit.empty() || unit == "M" ? 20 : unit == "G" ? 30 : 0;
  if (error != std::errc() || bits == 0 || count == 0 || count > (std::size_t{1} << 50 >> bits))
    throw UsageError(fmt::format("--memory {}: a size such as 512M or 2G expected, at least 1", text));
  return count << bits;
}

Units units_option(const std::string& text) {
  const auto units = parse_units(text);
  if (!units) throw UsageError(fmt::format("--units {}: one of {} expected", text, units_names()));
  return *units;
}

/// "R" or "R1,R2".
std::array<double, 2> radius_option(const std::string& text) {
  const auto number = [&](std::string_view part) {
    double value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc{} || end != part.data() + part.size())
      throw UsageError(fmt::format("--radius {}: R or R1,R2 expected", text));
    return positive(value, "radius");
  };
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return {number(text), number(text)};
  const std::string_view view(text);
  return {number(view.substr(0, comma)), number(view.substr(comma + 1))};
}

}  // namespace

double positive(double value, const char* option) {
  if (!(value > 0) || !std::isfinite(value))
    throw UsageError(fmt::format("--{} must be a number greater than zero", option));
  return value;
}

std::optional<double> positive_option(const Values& values, const char* name) {
  if (!values.count(name)) return std::nullopt;
  return positive(values[name].as<double>(), name);
}

void add_dump_options(Options& options) {
  options.add_options()                                                                           //
      ("scene", po::value<std::string>()->value_name("FILE"),
       "scene file (default: scene.toml beside the dump, if it names the dump)")                  //
      ("units", po::value<std::string>()->value_name("NAME"),
       "units of the dump, by LAMMPS' names (default: from the dump or the scene)")               //
      ("masses", po::value<std::string>()->value_name("LIST"),
       "masses by atom type, as 1=39.95,2=107.87 (default: dump, scene, in lj units 1)")          //
      ("select", po::value<std::string>()->value_name("COLUMN:RANGES"),
       "use some atoms only, as type:1-2 or id:1-500,900")                                        //
      ("bodies", po::value<std::string>()->value_name("RULE"),
       "what tells the bodies apart: type, mol, clusters or id:FIRST-LAST (default: scene; types "
       "if there are exactly two, else mol, else clusters)")                                      //
      ("timestep", po::value<double>()->value_name("DT"),
       "time between steps (default: times in the dump, else scene)");
}

void add_run_options(Options& options) {
  add_dump_options(options);
  options.add_options()("radius", po::value<std::string>()->value_name("R[,R2]"),
                        "radius of the bodies, for delta (default: scene, else sqrt(5/3) r_g)")(
      "physical", po::value<std::string>()->value_name("MATERIAL"),
      "give results in SI besides, with units lj that stand for argon, water, silver or "
      "m=39.95g/mol,sigma=0.341nm,epsilon=10.32meV");
}

RunOptions run_options(const Values& values) try {
  RunOptions options;
  options.dump = text_of(values, "input");
  options.scene = text_of(values, "scene");
  if (values.count("units")) options.units = units_option(text_of(values, "units"));
  if (values.count("masses")) options.masses = parse_masses(text_of(values, "masses"));
  if (values.count("bodies")) check_bodies_rule(options.bodies = text_of(values, "bodies"));
  if (values.count("select")) options.selection = Selection(text_of(values, "select"));
  if (values.count("radius")) options.radius = radius_option(text_of(values, "radius"));
  if (values.count("physical")) options.physical = parse_physical(text_of(values, "physical"));
  if (values.count("timestep"))
    options.timestep = positive(values["timestep"].as<double>(), "timestep");
  return options;
} catch (const InputError& error) {
  throw UsageError(error.what());
}

void add_frame_options(Options& options) {
  options.add_options()                                                                        //
      ("frames", po::value<std::string>()->value_name("A:B[:K]"),
       "use frames A to B - 1, counted from 0 (every K-th); A or B may be missing, as in 100:")  //
      ("stride", po::value<long>()->default_value(1)->value_name("K"),
       "use every K-th frame only")                                                            //
      ("strict", po::bool_switch(),
       "fail at damaged input, instead of using the whole frames before the damage (exit code 3)");
}

FrameChoice frame_choice(const Values& values) try {
  const long stride = values["stride"].as<long>();
  if (stride < 1) throw UsageError("--stride must be at least 1");
  FrameChoice choice;
  if (values.count("frames")) choice = parse_frame_choice(text_of(values, "frames"));
  if (choice.stride > 1 && stride > 1)
    throw UsageError("--stride and the stride in --frames: give one of them");
  choice.stride *= static_cast<std::uint64_t>(stride);
  return choice;
} catch (const InputError& error) {
  throw UsageError(error.what());
}

void add_threads_option(Options& options) {
  options.add_options()("threads", po::value<long>()->default_value(0, "all")->value_name("N"),
                        "threads for the blocks of large frames, or for small frames; the results are the "
                        "same bits with any number");
}

std::size_t threads_option(const Values& values) {
  const long threads = values["threads"].as<long>();
  if (threads < 0) throw UsageError("--threads must be at least 1");
  return threads > 0 ? static_cast<std::size_t>(threads)
                     : std::max(1u, std::thread::hardware_concurrency());
}

void add_resource_options(Options& options) {
  add_threads_option(options);
  options.add_options()  //
      ("memory", po::value<std::string>()->default_value("128M")->value_name("SIZE"),
       "memory for the atoms of a frame that are looked at twice; beyond it they are read twice "
       "(besides, about 5 MB a thread). 512M, 2G ...; MB without a letter")
      ("timings", po::bool_switch(), "tell on the standard error where the time went");
}

void set_resources(const Values& values, SweepOptions& sweeping) {
  sweeping.threads = threads_option(values);
  sweeping.memory = bytes_of(values["memory"].as<std::string>());
  if (!values["memory"].defaulted()) sweeping.frame_memory = sweeping.memory;
}

std::string output_help(bool table) {
  return "write " + listed(table, [](const Sink& sink) {
           return fmt::format("{} ({})", sink.summary, sink.ending);
         });
}

void add_output_options(Options& options, bool table) {
  add_frame_options(options);
  add_resource_options(options);
  options.add_options()                                                              //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"),
       output_help(table).c_str());
}

SweepOptions sweep_options(const Values& values) {
  SweepOptions options;
  options.choice = frame_choice(values);
  options.strict = values["strict"].as<bool>();
  set_resources(values, options);
  options.stop = &stop_signal();
  options.progress = progress_printer();
  return options;
}

void check_output(const Values& values, bool table) {
  const auto output = output_of(values);
  if (output.empty()) return;
  if (!sink_of(output, table))
    throw UsageError(fmt::format("-o {}: the name must end in {}", output.string(),
                                 listed(table, [](const Sink& s) { return std::string(s.ending); })));
  check_directory(output);
}

bool output_holds_all_tables(const Values& values) {
  const Sink* sink = sink_of(output_of(values), true);
  return sink && sink->all_tables;
}

void check_directory(const std::filesystem::path& output) {
  const auto directory = output.parent_path();
  if (!directory.empty() && !std::filesystem::is_directory(directory))
    throw std::runtime_error(fmt::format("-o {}: No such file or directory: {}",
                                         output.string(), directory.string()));
}

void print(const std::string& text) {
  if (!is_first_rank()) return;
  std::cout << text << std::flush;
  if (!std::cout) throw std::runtime_error("cannot write to the standard output");
}

int emit(const Values& values, const Document& document, const Table* table) {
  const auto output = output_of(values);
  if (const Sink* sink = sink_of(output, table != nullptr)) sink->write(output, document, table);
  print(values["json"].as<bool>() ? document.to_json() : document.to_terminal());
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
