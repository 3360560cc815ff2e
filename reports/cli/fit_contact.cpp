// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/contact_options.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/contact_fitted.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

using Texts = std::vector<std::string>;

Texts texts_of(const Values& values, const char* option) {
  return values.count(option) ? values[option].as<Texts>() : Texts();
}

const CollisionLaw& law_of(const Values& values) {
  const std::string text = values["law"].as<std::string>();
  if (const CollisionLaw* law = find_collision_law(text)) return *law;
  Texts names;
  for (const CollisionLaw* law : collision_laws()) names.emplace_back(law->name);
  throw UsageError(fmt::format("--law {}: one of {} is expected", text, fmt::join(names, ", ")));
}

FreeParameter& find_free(std::vector<FreeParameter>& free, const char* option, const std::string& name) {
  const auto at = std::ranges::find(free, name, &FreeParameter::name);
  if (at != free.end()) return *at;
  Texts names;
  for (const FreeParameter& f : free) names.push_back(f.name);
  throw UsageError(fmt::format("--{} {}: not a free parameter; these are {}", option, name, fmt::join(names, ", ")));
}

/// zeta=1:8
void set_bounds(std::vector<FreeParameter>& free, const std::string& text) {
  const NamedValue named = named_value("--bound", text);
  const std::size_t colon = named.text.find(':');
  if (colon == std::string::npos) throw UsageError(fmt::format("--bound {}: NAME=LEAST:GREATEST is expected", text));
  FreeParameter& f = find_free(free, "bound", named.name);
  f.least = number_option("--bound", text, std::string_view(named.text).substr(0, colon));
  f.greatest = number_option("--bound", text, std::string_view(named.text).substr(colon + 1));
  if (!(*f.least > 0 && *f.least < *f.greatest))
    throw UsageError(fmt::format("--bound {}: 0 < LEAST < GREATEST is needed", text));
}

/// gamma=3.17+-0.1
void set_prior(std::vector<FreeParameter>& free, const std::string& text) {
  const NamedValue named = named_value("--prior", text);
  const std::size_t sign = named.text.find("+-");
  if (sign == std::string::npos) throw UsageError(fmt::format("--prior {}: NAME=VALUE+-ERROR is expected", text));
  FreeParameter& f = find_free(free, "prior", named.name);
  f.prior = Measured{number_option("--prior", text, std::string_view(named.text).substr(0, sign)),
                     number_option("--prior", text, std::string_view(named.text).substr(sign + 2))};
  if (!(f.prior->value > 0 && f.prior->error > 0))
    throw UsageError(fmt::format("--prior {}: VALUE and ERROR greater than 0 are needed", text));
}

void set_start(std::vector<FreeParameter>& free, const std::string& text) {
  const NamedValue named = named_value("--start", text);
  FreeParameter& f = find_free(free, "start", named.name);
  f.start = number_option("--start", text, named.text);
  if (!(*f.start > 0)) throw UsageError(fmt::format("--start {}: a number greater than 0 is needed", text));
}

std::vector<FreeParameter> named_free(const std::vector<std::string>& names, const ContactFitSettings& settings) {
  std::vector<FreeParameter> free;
  for (const std::string& name : names) {
    if (std::ranges::find(free, name, &FreeParameter::name) != free.end())
      throw UsageError(fmt::format("--free: {} stands twice", name));
    if (std::ranges::find(settings.constants, name, &NamedNumber::name) != settings.constants.end())
      throw UsageError(fmt::format("{} is fixed by -p and free by --free", name));
    free.push_back({name, {}, {}, {}, {}, false});
  }
  return free;
}

IntervalSettings intervals_of(const Values& values) {
  IntervalSettings s;
  s.profile = values["intervals"].as<bool>();
  const long draws = values["bootstrap"].as<long>();
  if (draws < 0 || (draws > 0 && draws < 20) || draws > 1000000)
    throw UsageError("--bootstrap must be 0 or 20 to 1000000");
  s.draws = static_cast<std::size_t>(draws);
  s.seed = values["seed"].as<std::uint64_t>();
  s.level = values["level"].as<double>();
  if (!(s.level >= 0.01 && s.level <= 0.9999)) throw UsageError("--level must be between 0.01 and 0.9999");
  return s;
}

/// Free parameters with their starts, bounds and priors.
void set_free(ContactFitSettings& settings, const Values& values, const CollisionLaw& law,
              const std::vector<std::string>& names, const Observations& observations) {
  settings.free = names.empty() ? free_by_default(law, observations, settings) : named_free(names, settings);
  if (settings.free.empty())
    throw UsageError(fmt::format("law {}: nothing is free; name what is to be found by --free, and give it neither "
                                 "by a column nor by -p", law.name));
  for (const std::string& text : texts_of(values, "start")) set_start(settings.free, text);
  for (const std::string& text : texts_of(values, "bound")) set_bounds(settings.free, text);
  for (const std::string& text : texts_of(values, "prior")) set_prior(settings.free, text);
  for (const std::string& name : names_option(values, "per-radius"))
    find_free(settings.free, "per-radius", name).per_radius = true;
}

void add_options(Options& options) {
  const auto list = [] { return po::value<Texts>()->composing(); };
  options.add_options()                                                                            //
      ("law", po::value<std::string>()->required()->value_name("NAME"),
       "the law; mdana predict --help tells all with their parameters")                            //
      ("free", list()->value_name("NAMES"),
       "what is to be found, as C,B,zeta (default: what is usual for the law and not given)")      //
      ("start", list()->value_name("NAME=VALUE"), "where the first search begins")                 //
      ("bound", list()->value_name("NAME=A:B"), "a parameter must stay between A and B")           //
      ("prior", list()->value_name("NAME=X+-S"), "what is known of a parameter from elsewhere")    //
      ("per-radius", list()->value_name("NAMES"), "one value of the parameter for each R")         //
      ("intervals", po::bool_switch(), "profile-likelihood intervals")                             //
      ("bootstrap", po::value<long>()->default_value(0)->value_name("N"),
       "intervals from N fits to collisions drawn from those seen")                                //
      ("seed", po::value<std::uint64_t>()->default_value(1)->value_name("N"), "of the draws")      //
      ("level", po::value<double>()->default_value(IntervalSettings().level, "0.683")->value_name("P"),
       "probability of the intervals");
  add_error_option(options, "the starts");
  add_contact_fit_options(options);
}

int run_command(const Values& values) {
  check_output(values, true);
  const CollisionLaw& law = law_of(values);
  const std::vector<std::string> names = names_option(values, "free");
  ContactFitSettings settings = contact_settings(values);
  settings.intervals = intervals_of(values);
  const Wanted wanted = law.name == "andrews" ? Wanted::compression : Wanted::restitution;
  const Observations observations = observations_option(values, names, wanted);
  set_free(settings, values, law, names, observations);
  const auto chosen = choose_starts(values, fit_contact_subject(law, observations.seen, settings), settings);
  const ContactFit fit = fit_contact(law, observations.seen, settings);

  Document document("fit-contact");
  add_inputs(document, observations);
  add_contact_fit(document, law, settings, observations.seen, fit);
  tell_choice(document, chosen);
  const Table table = contact_fit_table(observations.seen, fit);
  const int code = emit(values, document, &table);
  return fit.usable ? choice_code(chosen, code) : not_converged;
}

}  // namespace

extern const Command fit_contact_command;
const Command fit_contact_command{
    "fit-contact",
    "INPUT...",
    "parameters of a contact law from e(v), sticking, delta_max, t_max",
    "Fits a law of collisions to collisions that were seen: tables (CSV) with the columns R, v, e, sigma (standard\n"
    "error of e) and, where needed, outcome (stick or bounce; e = 0 or empty: stick), delta_max, delta_max_error,\n"
    "t_max, t_max_error, m, E, gamma, nu, spacing or any parameter of the laws; # begins a comment. Or results of\n"
    "mdana collision (e; for the law andrews delta_max and t_max) and of mdana compress (delta_max and t_max, their\n"
    "errors by the scatter of repeated runs), as JSON or HDF5. Or dumps, measured as mdana collision does with what\n"
    "their scenes say and R of -p. With --motion delta(t), v(t) and F(t) of dumps and of HDF5 results are fitted\n"
    "instead; tables of them (time, delta, v, F, as mdana force writes) always are. The table (-o FILE.csv) has what was seen, the fit and the residuals. If the\n"
    "data do not determine what is asked, the exit code is 4 and the reason says what they determine.",
    "  mdana fit-contact --law stress runs.csv --table2\n"
    "  mdana fit-contact --law krijt runs.csv --table2 --per-radius T_vis --loss huber\n"
    "  mdana fit-contact --law jkr runs.csv -p E=65.5 --free gamma --intervals --bootstrap 200 --json\n"
    "  mdana fit-contact --law andrews aggregates.csv --free E,Y --bound Y=1e4:1e7\n"
    "  mdana fit-contact --law andrews compress-v5.json compress-v10.json compress-v20.json\n"
    "  mdana fit-contact --law jkr adhesive-small/dump.lammpstrj.gz --motion --free gamma,E\n"
    "  mdana fit-contact --law viscous-hertz force.csv -p R=10.4 -p m=4200 -p nu=0.25 --free T_vis,E\n"
    "  mdana fit-contact --law jkr a.json b.json -p m=14434147 --free gamma,E --prior E=65.5+-3",
    add_options,
    run_command};

}  // namespace mdana::cli
