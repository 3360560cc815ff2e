// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/masses.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

template <class T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

void check(double mass) {
  if (!(mass > 0) || !std::isfinite(mass))
    throw InputError(fmt::format("a mass of {} is not positive and finite", mass));
}

}  // namespace

Masses Masses::from_column(std::string source) { return {{"mass"}, std::move(source)}; }

Masses Masses::by_type(std::map<std::int64_t, double> masses, std::string source) {
  for (const auto& [type, mass] : masses) check(mass);
  Masses result({"type"}, std::move(source));
  result.by_type_ = std::move(masses);
  return result;
}

Masses Masses::uniform(std::string source) { return {{}, std::move(source)}; }

void Masses::fill(const AtomBlock& block, std::vector<double>& mass) const {
  mass.assign(block.atoms(), 1.0);
  if (columns_.has("mass")) {
    const auto values = block.real("mass");
    for (std::size_t i = 0; i < values.size(); ++i) check(mass[i] = values[i]);
  } else if (columns_.has("type")) {
    const auto types = block.integer("type");
    auto last = by_type_.end();
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (last == by_type_.end() || last->first != types[i]) last = by_type_.find(types[i]);
      if (last == by_type_.end())
        throw InputError(fmt::format("no mass for atoms of type {}; add it to --masses or to "
                                     "[masses] in the scene file", types[i]));
      mass[i] = last->second;
    }
  }
}

std::map<std::int64_t, double> parse_masses(const std::string& text) {
  std::map<std::int64_t, double> masses;
  std::istringstream stream(text);
  for (std::string entry; std::getline(stream, entry, ',');) {
    const std::size_t equals = entry.find('=');
    std::int64_t type = 0;
    double mass = 0;
    if (equals == std::string::npos || !parse(std::string_view(entry).substr(0, equals), type) ||
        !parse(std::string_view(entry).substr(equals + 1), mass))
      throw InputError(fmt::format("masses '{}': TYPE=MASS,TYPE=MASS... expected", text));
    check(mass);
    if (!masses.emplace(type, mass).second)
      throw InputError(fmt::format("masses '{}': type {} stands twice", text, type));
  }
  return masses;
}

}  // namespace mdana
