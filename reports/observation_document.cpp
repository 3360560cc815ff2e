// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

/// Equal bodies (within 1 %) under the name of both, others under their own; nothing that is unknown.
void give(std::vector<NamedNumber>& given, const std::string& name, const std::array<double, 2>& values) {
  const auto [a, b] = values;
  if (!(a > 0 && b > 0 && std::isfinite(a) && std::isfinite(b))) return;
  if (std::abs(a - b) <= 0.01 * std::max(a, b)) return given.push_back({name, (a + b) / 2});
  given.push_back({name + "1", a});
  given.push_back({name + "2", b});
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

ObservedCollision collision_of(const Json& document, const std::string& place, Wanted wanted) {
  ObservedCollision c;
  c.place = place;
  c.given = {{"v", needed(document, "speed_before", place)}};
  give(c.given, "R", of_bodies(document, "radius"));
  if (c.given.size() == 1) c.given.push_back({"R", needed(document, "radius_sum", place) / 2});
  give(c.given, "m", of_bodies(document, "mass"));
  wanted == Wanted::compression ? take_compression(document, c) : take_restitution(document, c);
  return c;
}

/// One run of `mdana compress`: delta_max from 2 R_eff, and m* of R_eff (Arakawa et al. 2024, eq. 29).
ObservedCollision compression_of(const Json& document, const std::string& place) {
  ObservedCollision c;
  c.place = place;
  const auto units = parse_units(word(document, "units"));
  const double mass_unit = units ? force_per_mass_acceleration(*units) : 1;
  c.given = {{"R", needed(document, "R_eff", place)},
             {"m", 2 * mass_unit * needed(document, "m_star", place)},
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

ObservedDocument parse_observed_document(std::string_view text, const std::string& place, Wanted wanted) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: larger than {} MB: that is no document of collisions", place, most_bytes >> 20));
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) throw InputError(fmt::format("{}: not JSON as a whole", place));
  const std::string command = word(document, "command");
  if (command == "compress") return {compressions_of(document, place), command};
  if (command == "collision" || command == "force") return {{collision_of(document, place, wanted)}, "collision"};
  throw InputError(fmt::format("{}: a document of 'mdana compress' or of 'mdana collision' is expected, this one is of '{}'",
                               place, command));
}

}  // namespace mdana
