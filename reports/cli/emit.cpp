// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/atomic_file.hpp"
#include "reports/cli/contact_options.hpp"
#include "reports/powder_lines.hpp"
#include "reports/whole_file.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 3> codes{"lammps", "liggghts", "yade"};

void add_options(Options& options) {
  options.add_options()                                                                       //
      ("for", po::value<std::string>()->required()->value_name("CODE"), "lammps, liggghts or yade")  //
      ("parameter,p", po::value<std::vector<std::string>>()->composing()->value_name("NAME=VALUE"),
       "a number that the fit does not have, or has several values of: E, R, m, nu, v ...")   //
      ("output,o", po::value<std::string>()->value_name("FILE"), "write the lines to a file");
}

int run_command(const Values& values) {
  const auto code = static_cast<PowderCode>(choice(values, "for", codes));
  const std::vector<NamedNumber> given = constants_option(values);
  const std::filesystem::path path = values["input"].as<std::string>();
  const WholeFile file = read_whole(path);
  const auto fit = nlohmann::ordered_json::parse(file.text, nullptr, false);
  if (fit.is_discarded() || !fit.is_object())
    throw InputError(fmt::format("{}: a document of 'mdana fit-contact --json' is expected", path.string()));
  const std::string lines = powder_lines(code, fit, given, path.string());
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
    "FIT.json",
    "a fit's contact parameters as input lines for LAMMPS, LIGGGHTS or Yade",
    "Writes what mdana fit-contact --json found as input lines of a code for powders, with intervals and the range\n"
    "that it was fitted in as comments. What the code has no counterpart of is said in a comment.",
    "  mdana emit --for lammps fit.json -p E=65.5 -p R=147 -p m=14434147\n"
    "  mdana emit --for liggghts fit.json -p v=0.1 -o contact.in\n"
    "  mdana emit --for yade fit.json -o contact.py",
    add_options,
    run_command};

}  // namespace mdana::cli
