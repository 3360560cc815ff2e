// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/contact_options.hpp"

#include <array>

#include <fmt/format.h>

#include "reports/cli/signals.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 3> loss_names{"none", "huber", "cauchy"};

}  // namespace

std::vector<NamedNumber> constants_option(const Values& values) {
  std::vector<NamedNumber> constants;
  if (!values.count("parameter")) return constants;
  for (const std::string& text : values["parameter"].as<std::vector<std::string>>()) {
    const NamedValue named = named_value("-p", text);
    for (const NamedNumber& other : constants)
      if (other.name == named.name) throw UsageError(fmt::format("-p {}: {} is given twice", text, named.name));
    constants.push_back({named.name, number_option("-p", text, named.text)});
  }
  return constants;
}

void add_contact_fit_options(Options& options) {
  add_threads_option(options);
  options.add_options()                                                                          //
      ("motion", po::bool_switch(),
       "of dumps and HDF5 results fit delta(t), v(t) and F(t) of the first compression and return, not e")                                                                          //
      ("parameter,p", po::value<std::vector<std::string>>()->composing()->value_name("NAME=VALUE"),
       "a parameter that no column gives, the same for all collisions")                          //
      ("table2", po::bool_switch(),
       "take m and E by R, gamma 3.17, nu 0.25 and spacing 1.091 from Yoshida, Kokubo & Tanaka "
       "(2024), Table II, in units lj, where they are not given")                                //
      ("loss", po::value<std::string>()->default_value("none")->value_name("NAME"),
       "damp outliers: none, huber or cauchy")                                                   //
      ("starts", po::value<int>()->default_value(8)->value_name("N"),
       "where searches begin: the start or the middle of the bounds, then spread over them")     //
      ("json", po::bool_switch(), "print one JSON document on the standard output")              //
      ("output,o", po::value<std::string>()->value_name("FILE"), output_help(true).c_str());
}

Observations observations_option(const Values& values, std::span<const std::string> free, Wanted wanted) {
  std::vector<std::string> names{values["input"].as<std::string>()};
  if (values.count("more"))
    for (const std::string& name : values["more"].as<std::vector<std::string>>()) names.push_back(name);
  ObservationSettings settings{values["motion"].as<bool>() ? Wanted::motion : wanted, {}, {}};
  for (const NamedNumber& n : constants_option(values))
    if (n.name == "R") settings.radius = n.value;
  settings.sweeping.threads = threads_option(values);
  settings.sweeping.stop = &stop_signal();
  settings.sweeping.progress = progress_printer();
  Observations all = read_observations(std::vector<std::filesystem::path>(names.begin(), names.end()), settings);
  if (!values["table2"].as<bool>()) return all;
  std::vector<std::string> leave(free.begin(), free.end());
  for (const NamedNumber& n : constants_option(values)) leave.push_back(n.name);
  fill_from_lj_particles(all, leave);
  return all;
}

ContactFitSettings contact_settings(const Values& values) {
  ContactFitSettings s;
  s.constants = constants_option(values);
  s.loss = static_cast<Loss>(choice(values, "loss", loss_names));
  s.starts = values["starts"].as<int>();
  if (s.starts < 1 || s.starts > 1000) throw UsageError("--starts must be 1 to 1000");
  return s;
}

void add_inputs(Document& document, const Observations& observations) {
  for (const auto& file : observations.files) document.input(file.record, file.format);
}

}  // namespace mdana::cli
