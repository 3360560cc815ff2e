// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/inline_log.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/flow_list.hpp"
#include "readers/input_error.hpp"
#include "readers/line_reader.hpp"

namespace mdana {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view bodies_key = " bodies=";
constexpr double most_atoms = 9007199254740992.0;  ///< 2^53: beyond it doubles do not count
constexpr std::array<std::string_view, 11> motion_columns{"n", "m", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz"};
constexpr std::array<std::string_view, 10> energy_columns{"Kt", "Lx", "Ly", "Lz", "Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Ixz"};

template <class Number>
bool is_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

/// Unit of the last printed digit.
double last_digit_of(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), e);
  int power = 0;
  if (e + 1 < text.size()) is_number(text.substr(text[e + 1] == '+' ? e + 2 : e + 1), power);
  const int decimals = point < e ? static_cast<int>(e - point - 1) : 0;
  return std::pow(10.0, std::clamp(power, -1000, 1000) - decimals);
}

class InlineReader {
 public:
  explicit InlineReader(const std::filesystem::path& path) : lines_(open_bytes(path)) { log_.path = path.string(); }

  InlineLog read() {
    read_title();
    read_columns();
    while (const auto line = lines_.line()) add_row(*line);
    end();
    log_.input = lines_.bytes().record();
    return std::move(log_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", log_.path, std::max<std::uint64_t>(lines_.number(), 1), what));
  }

  void read_title() {
    const auto line = lines_.line();
    if (!line || !line->starts_with(inline_title))
      fail(fmt::format("not what the lines of mdana emit --for lammps-inline write, which begins with '{}'", inline_title));
    std::map<std::string, std::string, std::less<>> said;
    const std::size_t bodies = std::min(line->find(bodies_key), line->size());  // the last, in words
    if (bodies < line->size()) log_.bodies = trimmed(line->substr(bodies + bodies_key.size()));
    for (const std::string_view word : words_of(line->substr(0, bodies).substr(inline_title.size()))) {
      const std::size_t equals = word.find('=');
      if (equals == word.npos) fail(fmt::format("'{}': NAME=VALUE expected", word.substr(0, 40)));
      said.emplace(word.substr(0, equals), word.substr(equals + 1));
    }
    for (const auto& [key, value] : said) take(key, value);
    if (!said.contains("units")) fail("the first line does not state units");
  }

  void take(const std::string& key, const std::string& value) {
    if (key == "units") {
      const auto units = parse_units(value);
      if (!units) fail(fmt::format("units {} are unknown (known: {})", value, units_names()));
      log_.units = *units;
    } else if (key == "interaction") {
      log_.interaction = interaction(value);
    } else if (key == "radii") {
      const std::size_t comma = value.find(',');
      if (comma == value.npos) fail(fmt::format("radii={}: R1,R2 expected", value));
      log_.radii = {positive(key, value.substr(0, comma)), positive(key, value.substr(comma + 1))};
    } else if (key == "radius_definition") {
      log_.radius_definition = value;
    } else {
      fail(fmt::format("'{}' in the first line is not known to this mdana", key.substr(0, 40)));
    }
  }

  double positive(const std::string& key, std::string_view text) const {
    double value = 0;
    if (!is_number(text, value) || !std::isfinite(value) || !(value > 0))
      fail(fmt::format("{}={}: a number greater than zero is expected", key, text.substr(0, 40)));
    return value;
  }

  Interaction interaction(const std::string& value) const {
    for (const Interaction i : {Interaction::unknown, Interaction::hertz, Interaction::adhesive, Interaction::aggregate})
      if (name(i) == value) return i;
    fail(fmt::format("interaction={}: unknown", value.substr(0, 40)));
  }

  void read_columns() {
    const auto line = lines_.line();
    if (!line || !line->starts_with(inline_columns_title)) fail(fmt::format("a line '{}...' is expected", inline_columns_title));
    for (const std::string_view word : words_of(line->substr(inline_columns_title.size()))) log_.columns.emplace_back(word);
    if (log_.columns != inline_columns(false) && log_.columns != inline_columns(true))
      fail(fmt::format("the columns must be TimeStep {} [W1] ... [W2]", fmt::join(inline_columns(false), " ")));
    log_.values.resize(log_.columns.size());
    log_.last_digit.assign(log_.columns.size(), std::numeric_limits<double>::infinity());
  }

  void add_row(std::string_view line) {
    const Words w = words_of(line);
    if (w.empty()) fail("an empty line");
    if (w[0].starts_with('#'))
      fail("a second head: a run that was started anew wrote into the same file; keep the rows of one of them");
    if (w.size() != log_.columns.size() + 1)
      fail(fmt::format("{} values (line 2 names {} columns)", w.size(), log_.columns.size() + 1));
    std::int64_t step = 0;
    if (!is_number(w[0], step)) fail(fmt::format("'{}' is no time step", w[0].substr(0, 40)));
    if (!log_.steps.empty() && step <= log_.steps.back())
      fail(fmt::format("step {} does not come after {}: keep the rows of one run", step, log_.steps.back()));
    log_.steps.push_back(step);
    for (std::size_t k = 0; k < log_.columns.size(); ++k) add_value(k, w[k + 1]);
  }

  void add_value(std::size_t k, std::string_view text) {
    double value = 0;
    if (!is_number(text, value)) fail(fmt::format("'{}' in column {} is not a number", text.substr(0, 40), log_.columns[k]));
    if (!std::isfinite(value)) fail(fmt::format("{} in column {}: the run went wrong; use the rows before it", value, log_.columns[k]));
    const char first = log_.columns[k][0];
    if ((first == 'n' || first == 'm') && !(value > 0)) fail(fmt::format("{} in column {}: a body has no atoms", value, log_.columns[k]));
    if (first == 'n' && (value != std::floor(value) || value > most_atoms))
      fail(fmt::format("{} in column {}: a number of atoms is expected", value, log_.columns[k]));
    log_.values[k].push_back(value);
    log_.last_digit[k] = std::min(log_.last_digit[k], last_digit_of(text));
  }

  void end() {
    if (const std::string damage = lines_.bytes().damage(); !damage.empty()) log_.cut = damage + "; ";
    if (lines_.unfinished()) log_.cut += fmt::format("it ends within line {}, which is left out", lines_.number() + 1);
    if (log_.steps.empty()) fail("there are no rows");
  }

  LineReader lines_;
  InlineLog log_;
};

}  // namespace

const std::vector<double>* InlineLog::find(std::string_view column) const {
  const auto at = std::ranges::find(columns, column);
  return at == columns.end() ? nullptr : &values[static_cast<std::size_t>(at - columns.begin())];
}

std::vector<std::string> inline_columns(bool potential) {
  std::vector<std::string> all{"time", "dt"};
  for (const char* body : {"1", "2"}) {
    for (const std::string_view name : motion_columns) all.push_back(std::string(name) + body);
    for (const std::string_view name : energy_columns) all.push_back(std::string(name) + body);
    if (potential) all.push_back(std::string("W") + body);
  }
  return all;
}

bool is_inline_log(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::array<char, inline_title.size()> head;
  return std::string_view(head.data(), open_bytes(path)->read(head)) == inline_title;
}

InlineLog read_inline_log(const std::filesystem::path& path) { return InlineReader(path).read(); }

}  // namespace mdana
