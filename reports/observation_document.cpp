// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fits/followed_collision.hpp"
#include "readers/input_error.hpp"
#include "readers/units.hpp"
#include "reports/observations.hpp"

namespace mdana {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{16} << 20;  ///< a study of some thousand runs

/// {"value": ..., "error": ...} of a document; unknown if there is none.
Measured number(const Json& document, const char* name) {
  Measured m;
  const auto at = document.find(name);
  if (at == document.end() || !at->is_object()) return m;
  const auto get = [&](const char* key, double& into) {
    if (const auto found = at->find(key); found != at->end() && found->is_number()) into = found->get<double>();
  };
  get("value", m.value);
  get("error", m.error);
  if (!(m.error > 0)) m.error = std::numeric_limits<double>::quiet_NaN();
  return m;
}

std::string word(const Json& document, const char* name) {
  const auto at = document.find(name);
  return at != document.end() && at->is_string() ? at->get<std::string>() : std::string();
}

/// A number of both bodies, as `name.body1` and `name.body2`; unknown if the document has none.
std::array<double, 2> of_bodies(const Json& document, const char* name) {
  const auto at = document.find(name);
  if (at == document.end() || !at->is_object()) return {Measured().value, Measured().value};
  return {number(*at, "body1").value, number(*at, "body2").value};
}

double needed(const Json& document, const char* name, const std::string& place) {
  const Measured m = number(document, name);
  if (!(m.value > 0) || !std::isfinite(m.value))
    throw InputError(fmt::format("{}: {} is not known; a collision is needed that begins before contact", place, name));
  return m.value;
}

/// e or sticking of a document of `mdana collision`.
void take_restitution(const Json& document, ObservedCollision& c) {
  const std::string outcome = word(document, "outcome");
  if (outcome != "stick" && outcome != "bounce")
    throw InputError(fmt::format("{}: outcome '{}': such a collision tells nothing; leave it out", c.place, outcome));
  c.stuck = outcome == "stick";
  c.e = number(document, "e");
  if (c.stuck) c.e.value = 0;
  if (!c.stuck && !(c.e.value > 0))
    throw InputError(fmt::format("{}: the spheres bounce, but e is not known", c.place));
}

/// delta_max and t_max of the same. They count from X = R1 + R2, so the radii must be those of the spheres.
void take_compression(const Json& document, ObservedCollision& c) {
  if (word(document, "radius_source").starts_with("sqrt(5/3) r_g"))
    throw InputError(fmt::format("{}: delta_max counts from radii of gyration, which are not those at which the bodies "
                                 "touch; give R to 'mdana collision' (--radius)", c.place));
  c.delta_max = number(document, "delta_max");
  c.t_max = number(document, "t_max");
  if (!(c.delta_max.value > 0) || !(c.t_max.value > 0))
    throw InputError(fmt::format("{}: delta_max and t_max are not both known; a collision is needed that begins before "
                                 "contact and turns", c.place));
}

/// Mass that makes mass velocity^2 an energy in the document's units: E is in force/length^2 then.
double mass_unit(const Json& document) {
  const auto units = parse_units(word(document, "units"));
  return units ? force_per_mass_acceleration(*units) : 1;
}

void give_bodies(const Json& document, ObservedCollision& c) {
  const std::size_t before = c.given.size();
  const auto radii = of_bodies(document, "radius"), masses = of_bodies(document, "mass");
  give_both(c.given, "R", radii[0], radii[1]);
  if (c.given.size() == before) c.given.push_back({"R", needed(document, "radius_sum", c.place) / 2});
  give_both(c.given, "m", mass_unit(document) * masses[0], mass_unit(document) * masses[1]);
}

ObservedCollision motion_of(const Json& document, const std::string& place, const std::vector<MotionSample>& rows) {
  if (rows.empty())
    throw InputError(place + ": a document has no motion delta(t); give the table (-o FILE.csv or FILE.h5), or the dump");
  ObservedCollision c = followed_collision(rows, place);
  give_bodies(document, c);
  return c;
}

ObservedCollision collision_of(const Json& document, const std::string& place, Wanted wanted) {
  ObservedCollision c;
  c.place = place;
  c.given = {{"v", needed(document, "speed_before", place)}};
  give_bodies(document, c);
  wanted == Wanted::compression ? take_compression(document, c) : take_restitution(document, c);
  return c;
}

/// One run of `mdana compress`: delta_max from 2 R_eff, and m* of R_eff (Arakawa et al. 2024, eq. 29).
ObservedCollision compression_of(const Json& document, const std::string& place) {
  ObservedCollision c;
  c.place = place;
  c.given = {{"R", needed(document, "R_eff", place)},
             {"m", 2 * mass_unit(document) * needed(document, "m_star", place)},
             {"v", needed(document, "speed_before", place)}};
  c.delta_max = number(document, "delta_max_eff");
  c.t_max = number(document, "t_max");
  if (!(c.delta_max.value > 0))
    throw InputError(fmt::format("{}: delta_max is not known: the dump ends before it; leave the run out", place));
  return c;
}

std::vector<ObservedCollision> compressions_of(const Json& document, const std::string& place) {
  const auto runs = document.find("runs");
  if (runs == document.end() || !runs->is_array()) return {compression_of(document, place)};
  std::vector<ObservedCollision> all;
  for (const Json& run : *runs)
    if (run.is_object() && !run.contains("failure"))
      all.push_back(compression_of(run, fmt::format("{}: run {}", place, all.size() + 1)));
  if (all.empty()) throw InputError(place + ": a study without runs");
  return all;
}

}  // namespace

ObservedDocument parse_observed_document(std::string_view text, const std::string& place, Wanted wanted,
                                         const std::vector<MotionSample>& rows) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: larger than {} MB: that is no document of collisions", place, most_bytes >> 20));
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) throw InputError(fmt::format("{}: not JSON as a whole", place));
  const std::string command = word(document, "command");
  const bool collision = command == "collision" || command == "force" || (command == "report" && !document.contains("runs"));
  if (collision && wanted == Wanted::motion) return {{motion_of(document, place, rows)}, "motion"};
  if (collision) return {{collision_of(document, place, wanted)}, "collision"};
  if (command == "compress") return {compressions_of(document, place), command};
  throw InputError(fmt::format("{}: a document of 'mdana collision' or 'mdana compress' is expected, this one is of '{}'",
                               place, command));
}

}  // namespace mdana
