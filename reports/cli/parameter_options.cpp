// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "reports/cli/command.hpp"

namespace mdana::cli {

NamedValue named_value(std::string_view option, const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == 0 || sign == std::string::npos)
    throw UsageError(fmt::format("{} {}: NAME=VALUE is expected", option, text));
  return {text.substr(0, sign), text.substr(sign + 1)};
}

double number_option(std::string_view option, const std::string& whole, std::string_view text) {
  return finite_number(text, fmt::format("{} {}: '{}' is not a finite number", option, whole, text));
}

std::vector<std::string> names_option(const Values& values, const char* option) {
  std::vector<std::string> names;
  if (!values.count(option)) return names;
  for (const std::string& list : values[option].as<std::vector<std::string>>())
    for (std::size_t from = 0; from <= list.size();) {
      const std::size_t comma = std::min(list.find(',', from), list.size());
      if (comma == from)
        throw UsageError(fmt::format("--{} {}: NAME,NAME,... is expected", option, list));
      names.push_back(list.substr(from, comma - from));
      from = comma + 1;
    }
  return names;
}

std::vector<NamedValue> parameters_option(const Values& values) {
  std::vector<NamedValue> given;
  if (values.count("parameter"))
    for (const std::string& text : values["parameter"].as<std::vector<std::string>>())
      given.push_back(named_value("-p", text));
  return given;
}

double finite_number(std::string_view text, std::string_view expected) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw UsageError(std::string(expected));
  return value;
}

std::array<std::string_view, 3> three_parts(std::string_view text, std::string_view expected) {
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (first == text.npos || second == text.npos) throw UsageError(std::string(expected));
  return {text.substr(0, first), text.substr(first + 1, second - first - 1),
          text.substr(second + 1)};
}

std::size_t count_number(std::string_view text, std::string_view expected) {
  const double count = finite_number(text, expected);
  if (!(count >= 2 && count <= 1e6 && count == std::floor(count)))
    throw UsageError(std::string(expected));
  return static_cast<std::size_t>(count);
}

std::vector<double> evenly(double first, double last, std::size_t count) {
  std::vector<double> all;
  const double steps = static_cast<double>(count - 1);
  for (std::size_t k = 0; k < count; ++k)
    all.push_back(first + (last - first) * (static_cast<double>(k) / steps));
  all.back() = last;
  return all;
}

}  // namespace mdana::cli
