// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "fits/collision_limits.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/cli/signals.hpp"
#include "reports/predicted.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

/// What is to be computed.
struct Wanted {
  const CollisionLaw* law;
  std::vector<NamedValue> given;   ///< with the first velocity
  std::vector<double> velocities;  ///< empty if they are to be searched
  bool sweep = false;
  CollisionSettings settings;
};

const CollisionLaw& law_option(const Values& values) {
  const std::string text = values["law"].as<std::string>();
  if (const CollisionLaw* law = find_collision_law(text)) return *law;
  std::string names;
  for (const CollisionLaw* law : collision_laws()) names += fmt::format(" {}", law->name);
  throw UsageError(fmt::format("--law {}: one of{} expected", text, names));
}

/// "0.04:0.5:24": 24 values, the ends included; empty if it is one velocity.
std::vector<double> velocities_of(const std::string& text) {
  if (text.find(':') == std::string::npos) return {};
  const std::string expected = fmt::format(
      "-p v={}: a velocity, or FIRST:LAST:COUNT with 0 < FIRST < LAST and a COUNT of 2 to 1000000, is "
      "expected",
      text);
  const auto [first, last, count] = three_parts(text, expected);
  const double low = finite_number(first, expected), high = finite_number(last, expected);
  if (!(low > 0 && high > low)) throw UsageError(expected);
  return evenly(low, high, count_number(count, expected));
}

bool searching(const Values& values) {
  return values["sticking-velocity"].as<bool>() || values["peak"].as<bool>();
}

CollisionSettings settings_of(const Values& values) {
  CollisionSettings s;
  s.tolerance = positive(values["tolerance"].as<double>(), "tolerance");
  s.time_limit = positive(values["time-limit"].as<double>(), "time-limit");
  s.trajectory = values["trajectory"].as<bool>();
  s.sensitivities = values["sensitivities"].as<bool>();
  if (s.tolerance > 0.1 || s.tolerance < 1e-13)
    throw UsageError("--tolerance must be between 1e-13 and 0.1");
  return s;
}

Wanted wanted_of(const Values& values) {
  Wanted w{&law_option(values), parameters_option(values), {}, false, settings_of(values)};
  bool velocity = false;
  for (NamedValue& g : w.given) {
    if (g.name != "v") continue;
    velocity = true;
    w.velocities = velocities_of(g.text);
    w.sweep = !w.velocities.empty();
    if (w.sweep) g.text = fmt::format("{}", w.velocities.front());
  }
  if (searching(values) && velocity && !w.sweep)
    throw UsageError(
        "--sticking-velocity and --peak look at several velocities: v=FIRST:LAST:COUNT, "
        "or none");
  if (searching(values) && !velocity) w.given.push_back({"v", "1"});
  if (values.count("error") && (w.sweep || searching(values)))
    throw UsageError("--error is of one collision; --tolerance is of several velocities");
  if (w.settings.trajectory && (w.sweep || searching(values)))
    throw UsageError("--trajectory is of one collision, not of several velocities");
  return w;
}

void add_law(Document& document, const Wanted& wanted) {
  document.text("law", std::string(wanted.law->name));
  nlohmann::ordered_json json;
  std::string text;
  for (const NamedValue& g : wanted.given) {
    if (g.name == "v") continue;
    json[g.name] = g.text;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", g.name, g.text);
  }
  document.json("parameters", std::move(json));
  document.line("parameters", text);
  for (const CollisionParameter& p : wanted.law->parameters)
    if (p.dimension == dimension::length && p.fallback && *p.fallback == *p.fallback &&
        std::none_of(wanted.given.begin(), wanted.given.end(),
                     [&](auto& g) { return g.name == p.name; }))
      document.warn(
          fmt::format("{} is not given: {} in the length unit of R, right for units lj only",
                      p.name, *p.fallback));
}

void add_sensitivities(Document& document, const CollisionLaw& law,
                       const CollisionSensitivities& s) {
  std::vector<std::string> names{"R_star", "m_star", "E", "v"};
  for (const CollisionParameter& p : law.parameters) names.emplace_back(p.name);
  nlohmann::ordered_json json;
  for (const auto& [what, by] :
       {std::pair{"e_squared", &s.e_squared}, {"delta_max", &s.delta_max}, {"t_max", &s.t_max}})
    for (std::size_t k = 0; k < names.size(); ++k)
      json[what][names[k]] = (*by)[static_cast<Eigen::Index>(k)];
  document.json("sensitivities", std::move(json));
}

nlohmann::ordered_json trajectory_json(const Table& table) {
  nlohmann::ordered_json json;
  for (const ColumnSpec& c : table.columns()) {
    const auto values = table.column(c.name);
    json[c.name] = std::vector<double>(values.begin(), values.end());
  }
  return json;
}

/// With --error: the greatest tolerance that gives it, which is set. Nothing if the collision is unresolved with all.
std::optional<Recommendation> choose_tolerance(const Values& values, const Wanted& wanted, const CollisionInput& input,
                                               CollisionSettings& settings) try {
  const std::optional<double> error = wanted_error(values);
  if (!error) return std::nullopt;
  if (!values["tolerance"].defaulted()) throw UsageError("--error chooses the tolerance: leave --tolerance out");
  const AccuracySubject subject = predict_subject(*wanted.law, input, settings);
  const Knob& knob = subject.knob("tolerance");
  const Recommendation chosen = choose(subject, knob, *error);
  settings.tolerance = knob.values[chosen.choice.of("tolerance")].number;
  return chosen;
} catch (const InputError&) {
  return std::nullopt;
}

int one_collision(const Values& values, const Wanted& wanted, const CollisionInput& input,
                  Document& document) {
  CollisionSettings settings = wanted.settings;
  const auto chosen = choose_tolerance(values, wanted, input, settings);
  const Collision c = collide(*wanted.law, input, settings);
  const auto numbers = to_json(c);
  for (const auto& [name, value] : numbers.items()) document.json(name, value);
  document.line("v", fmt::format("{:.10g}", input.impact.velocity));
  add_lines(document, c);
  if (c.sensitivities) add_sensitivities(document, *wanted.law, *c.sensitivities);
  const double velocity = input.impact.velocity;
  const Table table =
      wanted.settings.trajectory ? trajectory_table(c) : collision_table({&velocity, 1}, {&c, 1});
  if (wanted.settings.trajectory) document.json("trajectory", trajectory_json(table));
  tell_choice(document, chosen);
  const int code = emit(values, document, &table);
  return c.outcome == CollisionOutcome::unresolved ? not_converged : choice_code(chosen, code);
}

int sweep_velocities(const Values& values, const Wanted& wanted, CollisionInput input,
                     Document& document) {
  std::vector<Collision> collisions;
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  bool resolved = true;
  for (const double v : wanted.velocities) {
    if (stop_signal()) throw Interrupted(stop_signal());
    input.impact.velocity = v;
    collisions.push_back(collide(*wanted.law, input, wanted.settings));
    const Collision& c = collisions.back();
    nlohmann::ordered_json json{{"v", v}};
    json.update(to_json(c));
    results.push_back(std::move(json));
    resolved = resolved && c.outcome != CollisionOutcome::unresolved;
    document.line(
        fmt::format("v = {:.6g}", v),
        c.e > 0 ? fmt::format("e {:.10g} ± {:.1g}", c.e, c.e_error) : std::string(name(c.outcome)));
  }
  document.json("results", std::move(results));
  const Table table = collision_table(wanted.velocities, collisions);
  const int code = emit(values, document, &table);
  return resolved ? code : not_converged;
}

int search(const Values& values, const Wanted& wanted, const CollisionInput& input,
           Document& document) {
  const std::vector<double> velocities =
      wanted.sweep ? wanted.velocities : search_velocities(*wanted.law, input);
  bool found = true;
  if (values["sticking-velocity"].as<bool>()) {
    const VelocityFound v = sticking_velocity(*wanted.law, input, velocities, wanted.settings);
    add_velocity(document, "sticking_velocity", v);
    found = found && v.found();
  }
  if (values["peak"].as<bool>()) {
    const VelocityFound v = peak_velocity(*wanted.law, input, velocities, wanted.settings);
    add_velocity(document, "peak", v);
    found = found && v.found();
  }
  const int code = emit(values, document, nullptr);
  return found ? code : not_converged;
}

void add_options(Options& options) {
  options.add_options()                                                                        //
      ("law", po::value<std::string>()->required()->value_name("NAME"), "the law, see above")  //
      (
          "parameter,p",
          po::value<std::vector<std::string>>()->composing()->value_name("NAME=VALUE"),
          "a parameter, in any consistent units; v=FIRST:LAST:COUNT sweeps velocities, ends "
          "included")                                                             //
      ("trajectory", po::bool_switch(), "t, delta, v, a and F of the collision")  //
      ("sensitivities", po::bool_switch(),
       "derivatives of e^2, delta_max and t_max by the parameters (JSON)")                     //
      ("sticking-velocity", po::bool_switch(), "the velocity above which the spheres bounce")  //
      ("peak", po::bool_switch(), "the velocity at which e is greatest")                       //
      ("tolerance", po::value<double>()->default_value(1e-8, "1e-8")->value_name("E"),
       "wanted error of e")  //
      ("error", po::value<double>()->value_name("E"),
       "wanted error of all numbers, as a part of them: chooses the tolerance")  //
      ("time-limit", po::value<double>()->default_value(2)->value_name("SECONDS"),
       "of one collision; beyond it the outcome is unresolved")                      //
      ("json", po::bool_switch(), "print one JSON document on the standard output")  //
      ("output,o", po::value<std::string>()->value_name("FILE"), output_help(true).c_str());
}

int run_command(const Values& values) {
  check_output(values, !searching(values));
  const Wanted wanted = wanted_of(values);
  const CollisionInput input = collision_input(*wanted.law, wanted.given);
  Document document("predict");
  add_law(document, wanted);
  if (searching(values)) return search(values, wanted, input, document);
  if (wanted.sweep) return sweep_velocities(values, wanted, input, document);
  return one_collision(values, wanted, input, document);
}

/// The laws with their parameters, from the laws' own tables.
std::string describe_laws() {
  std::string text =
      "Predicts the collision of two spheres by a contact law: outcome, coefficient of "
      "restitution,\n"
      "greatest compression, times, contact radius, pressure, each by integration to a stated "
      "error.\n"
      "R and m are those of each of two equal spheres, E is the reduced modulus E*.\n\nall laws:\n";
  for (const CollisionParameter& p : impact_parameters())
    text += fmt::format("  {:<15}{}\n", p.name, p.meaning);
  for (const CollisionLaw* law : collision_laws()) {
    text += fmt::format("\n{}: {}\n", law->name, law->summary);
    for (const CollisionParameter& p : law->parameters)
      text += fmt::format("  {:<15}{}\n", p.name, p.meaning);
  }
  text.pop_back();
  return text;
}

const std::string description = describe_laws();

}  // namespace

extern const Command predict_command;
const Command predict_command{
    "predict",
    "",
    "a collision by a contact law: e, contact time, greatest compression",
    description,
    "  mdana predict --law krijt -p R=147 -p m=14434147 -p E=65.5 -p gamma=3.17 -p nu=0.25 -p "
    "T_vis=0.075 -p v=0.1\n"
    "  mdana predict --law jkr -p R1=1e-7 -p R2=inf -p m1=4.2e-18 -p m2=inf -p E=3.7e9 -p "
    "gamma=0.1 -p v=5 --trajectory -o t.csv\n"
    "  mdana predict --law stress -p R=147 -p m=14434147 -p E=65.5 -p gamma=3.17 -p nu=0.25 -p "
    "C=2.1e-4 -p B=6.2 -p zeta=4 -p v=0.04:0.5:24\n"
    "  mdana predict --law power -p R=147 -p m=14434147 -p E=65.5 -p gamma=3.17 -p D=118 -p "
    "alpha=3 -p beta=1.5 --sticking-velocity --peak",
    add_options,
    run_command};

}  // namespace mdana::cli
