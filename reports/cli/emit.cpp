// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/atomic_file.hpp"
#include "reports/cli/contact_options.hpp"
#include "reports/inline_lines.hpp"
#include "reports/inline_run.hpp"
#include "reports/powder_lines.hpp"
#include "reports/whole_file.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 4> codes{"lammps", "liggghts", "yade", "lammps-inline"};
constexpr std::size_t inline_code = 3;

void add_options(Options& options) {
  const InlineWishes defaults;
  options.add_options()                                                                       //
      ("for", po::value<std::string>()->required()->value_name("CODE"),
       "lammps, liggghts or yade: of a fit; lammps-inline: of a dump")                        //
      ("parameter,p", po::value<std::vector<std::string>>()->composing()->value_name("NAME=VALUE"),
       "a number that the fit does not have, or has several values of: E, R, m, nu, v ...")   //
      ("output,o", po::value<std::string>()->value_name("FILE"), "write the lines to a file")  //
      ("every", po::value<long>()->default_value(static_cast<long>(defaults.every))->value_name("STEPS"),
       "lammps-inline: how often LAMMPS writes")                                              //
      ("file", po::value<std::string>()->default_value(defaults.file)->value_name("NAME"),
       "lammps-inline: what LAMMPS writes, where it runs")                                    //
      ("no-potential", po::bool_switch(),
       "lammps-inline: without potential energies of the bodies (as of a pair style that has none of atoms)");
  add_run_options(options);
}

/// A word that LAMMPS takes as one.
std::string file_option(const Values& values) {
  const std::string file = values["file"].as<std::string>();
  const bool plain = !file.empty() && std::ranges::all_of(file, [](unsigned char c) { return std::isalnum(c) || std::strchr("-_./+,:", c); });
  if (!plain) throw UsageError(fmt::format("--file {}: letters, digits and -_./+,: expected", file));
  return file;
}

std::string inline_text(const Values& values) {
  const long every = values["every"].as<long>();
  if (every < 1) throw UsageError("--every must be at least 1");
  if (values.count("parameter")) throw UsageError("--parameter: of a fit, not of lammps-inline");
  InlineWishes wishes{static_cast<std::uint64_t>(every), file_option(values), !values["no-potential"].as<bool>()};
  const RunOptions options = run_options(values);
  Run run = prepare_run(options);
  require_two_bodies(run);
  if (!has_atoms(run)) throw InputError(fmt::format("{}: lammps-inline {}", run.dump.string(), needs_atoms));
  if (options.radius) run.scene.radii = {(*options.radius)[0], (*options.radius)[1]};
  if (run.scene.interaction == Interaction::aggregate) wishes.potential = false;  // pair granular has no energy
  return inline_lines(run, wishes);
}

std::string powder_text(const Values& values, PowderCode code) {
  const std::vector<NamedNumber> given = constants_option(values);
  const std::filesystem::path path = values["input"].as<std::string>();
  const WholeFile file = read_whole(path);
  const auto fit = nlohmann::ordered_json::parse(file.text, nullptr, false);
  if (fit.is_discarded() || !fit.is_object())
    throw InputError(fmt::format("{}: a document of 'mdana fit-contact --json' is expected", path.string()));
  return powder_lines(code, fit, given, path.string());
}

int run_command(const Values& values) {
  const std::size_t code = choice(values, "for", codes);
  const std::string lines = code == inline_code ? inline_text(values) : powder_text(values, static_cast<PowderCode>(code));
  if (!values.count("output")) return print(lines), done;
  const std::filesystem::path output = values["output"].as<std::string>();
  check_directory(output);
  write_file(output, lines);
  return done;
}

}  // namespace

extern const Command emit_command;
const Command emit_command{
    "emit",
    "FIT.json|DUMP",
    "input lines: a fit's contact parameters for powders, or what LAMMPS measures during a run",
    "Writes what mdana fit-contact --json found as input lines of a code for powders, with intervals and the range\n"
    "that it was fitted in as comments. What the code has no counterpart of is said in a comment.\n"
    "lammps-inline: of a dump, one frame of which is enough, lines for LAMMPS that write centres of mass, velocities,\n"
    "forces and energies of its two bodies during the run, in all digits, so that few dumps are needed: mdana force,\n"
    "fit-hertz, fit-force and energy read that file as they read a dump.",
    "  mdana emit --for lammps fit.json -p E=65.5 -p R=147 -p m=14434147\n"
    "  mdana emit --for liggghts fit.json -p v=0.1 -o contact.in\n"
    "  mdana emit --for yade fit.json -o contact.py\n"
    "  mdana emit --for lammps-inline sample-data/hertz-tiny/dump.lammpstrj.gz --every 32",
    add_options,
    run_command};

}  // namespace mdana::cli
