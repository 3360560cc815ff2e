// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "readers/input_error.hpp"
#include "reports/observations.hpp"

namespace mdana {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{4} << 20;

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

}  // namespace

ObservedCollision parse_collision_document(std::string_view text, const std::string& place) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: larger than {} MB: that is no document of one collision", place, most_bytes >> 20));
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) throw InputError(fmt::format("{}: not JSON as a whole", place));
  const std::string command = word(document, "command");
  if (command != "collision" && command != "force")
    throw InputError(fmt::format("{}: a document of 'mdana collision' is expected, this one is of '{}'", place, command));
  ObservedCollision c;
  c.place = place;
  c.given = {{"v", needed(document, "speed_before", place)}};
  give(c.given, "R", of_bodies(document, "radius"));
  if (c.given.size() == 1) c.given.push_back({"R", needed(document, "radius_sum", place) / 2});
  give(c.given, "m", of_bodies(document, "mass"));
  const std::string outcome = word(document, "outcome");
  if (outcome != "stick" && outcome != "bounce")
    throw InputError(fmt::format("{}: outcome '{}': such a collision tells nothing; leave it out", place, outcome));
  c.stuck = outcome == "stick";
  c.e = number(document, "e");
  if (c.stuck) c.e.value = 0;
  if (!c.stuck && !(c.e.value > 0))
    throw InputError(fmt::format("{}: the spheres bounce, but e is not known", place));
  return c;
}

}  // namespace mdana
