// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/cli/command.hpp"
#include "reports/particle.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

std::string text_of(const Values& values, const char* option) {
  return values.count(option) ? values[option].as<std::string>() : std::string();
}

double number(const std::string& text, const char* option) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value))
    throw UsageError(fmt::format("--{} {}: a number is expected", option, text));
  return value;
}

/// "-9.2783e5": the error is that of a number rounded to the digits that are given.
Value energy_option(const std::string& text) {
  const double value = number(text, "energy");
  const std::size_t power = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), power);
  const auto decimals = static_cast<int>(power - point) - (point < power ? 1 : 0);
  const int exponent = power < text.size() ? std::atoi(text.c_str() + power + 1) : 0;
  return {value, std::pow(10.0, exponent - decimals) / std::sqrt(12.0), dimension::energy};
}

/// "5" or "none", yes or no, and the scales.
PotentialConstants potential_constants(const Values& values) {
  const std::string cutoff = text_of(values, "cutoff"), shift = text_of(values, "shift");
  if (!shift.empty() && shift != "yes" && shift != "no") throw UsageError("--shift: yes or no expected");
  PotentialConstants constants{positive_option(values, "epsilon"), positive_option(values, "sigma"), {}, cutoff == "none", {}};
  if (!cutoff.empty() && cutoff != "none") constants.cutoff = positive(number(cutoff, "cutoff"), "cutoff");
  if (!shift.empty()) constants.shifted = shift == "yes";
  return constants;
}

void add_potential(Document& document, const LennardJones& u, Units units) {
  nlohmann::ordered_json json{{"epsilon", u.epsilon}, {"sigma", u.sigma}};
  json["cutoff"] = u.cutoff ? nlohmann::ordered_json(*u.cutoff) : nlohmann::ordered_json(nullptr);
  json["shift"] = u.shifted;
  document.json("potential", std::move(json));
  document.line("potential",
                u.cutoff ? fmt::format("Lennard-Jones, cutoff {}, {}",
                                       to_text({*u.cutoff, {}, dimension::length}, units),
                                       u.shifted ? "shifted" : "not shifted")
                         : "Lennard-Jones without cutoff");
}

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()                                                                       //
      ("body", po::value<long>()->default_value(1)->value_name("K"),
       "which of the bodies: 1 or 2")                                                         //
      ("energy-column", po::value<std::string>()->value_name("NAME"),
       "the atoms' potential energies (default: the column that begins with c_pe)")           //
      ("energy", po::value<std::string>()->value_name("U"),
       "potential energy of the body, instead of a column")                                   //
      ("cutoff", po::value<std::string>()->value_name("LENGTH"),
       "of the Lennard-Jones potential, or none (default: scene)")                            //
      ("shift", po::value<std::string>()->value_name("yes|no"),
       "whether the potential is shifted to zero at the cutoff (default: scene)")             //
      ("epsilon", po::value<double>()->value_name("ENERGY"),
       "of the potential (default: 1 in lj units)")                                           //
      ("sigma", po::value<double>()->value_name("LENGTH"),
       "of the potential (default: scene; 1 in lj units)");
  add_output_options(options, false);
}

int run_command(const Values& values) {
  check_output(values, false);
  const RunOptions options = run_options(values);
  const SweepOptions sweeping = sweep_options(values);
  const long body = values["body"].as<long>();
  if (body != 1 && body != 2) throw UsageError("--body must be 1 or 2");
  const auto k = static_cast<std::size_t>(body);
  std::optional<Value> given;
  if (values.count("energy")) given = energy_option(text_of(values, "energy"));
  const PotentialConstants constants = potential_constants(values);
  const Run run = prepare_run(options);
  const LennardJones u = lennard_jones(run, constants);
  const FccCrystal crystal = relaxed_fcc(u);
  const std::string column = given ? "" : energy_column(run, text_of(values, "energy-column"));
  const Particle particle = measure_particle(run, k, column, sweeping);
  const ColdEnergy cold = cold_energy(given ? *given : *particle.potential, particle, u.epsilon);

  Document document("surface-energy", run);
  document.sweep(particle.swept, run.format);
  document.json("body", body);
  document.json("step", particle.swept.steps.front());
  document.line("body", fmt::format("{}, at step {}", body, particle.swept.steps.front()));
  add_potential(document, u, run.units);
  document.text("energy_source", given ? "option" : "sum of " + column);
  add_surface_energy(document, crystal, particle, cold, cut_radius(run, options, k));
  return emit(values, document, nullptr);
}

}  // namespace

extern const Command surface_energy_command;
const Command surface_energy_command{
    "surface-energy",
    "DUMP",
    "surface energy of a relaxed particle",
    "gamma = (U - N e_1)/(4 pi R^2): the energy U of a ball of N atoms above that of as many atoms\n"
    "of the endless fcc crystal (Lennard-Jones, summed pair by pair with the run's cutoff), over its\n"
    "surface. One frame is looked at, the first that --frames chooses; gamma is given with the\n"
    "radius that the ball was cut with, that of its volume, and that of its radius of gyration. There is no\n"
    "--error: all atoms of the frame are read, and nothing else takes time (mdana accuracy --only surface-energy).",
    "  mdana surface-energy relaxed.lammpstrj --bodies clusters --cutoff 5 --shift yes --radius 8\n"
    "  mdana surface-energy run/dump.lammpstrj.gz --frames 0:1 --body 2\n"
    "  mdana surface-energy relaxed.lammpstrj --units lj --energy -9.2783e5 --cutoff 5 --shift yes",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
