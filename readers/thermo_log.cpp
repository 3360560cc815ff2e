// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/thermo_log.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "readers/column_names.hpp"
#include "readers/flow_list.hpp"
#include "readers/input_error.hpp"
#include "readers/line_reader.hpp"
#include "readers/shown.hpp"

namespace mdana {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view beginning = "LAMMPS (";

// Of a log, which is kept in memory as a whole.
constexpr std::size_t most_numbers = std::size_t{1} << 27;
constexpr std::size_t most_sections = std::size_t{1} << 20;

/// A number with what its digits tell.
struct Printed {
  double value = 0;
  double last_digit = 0;  ///< unit of the last printed digit
};

std::optional<Printed> printed_number(std::string_view text) {
  Printed number;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number.value);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), e);
  int exponent = point < e ? -static_cast<int>(e - point - 1) : 0;
  if (e + 1 < text.size()) {
    int power = 0;
    const std::size_t sign = text[e + 1] == '+' ? 2 : 1;
    std::from_chars(text.data() + e + sign, end, power);
    exponent += std::clamp(power, -1000, 1000);
  }
  number.last_digit = std::pow(10.0, exponent);
  return number;
}

bool is_rule(std::string_view word) {
  return word.size() > 3 && word.find_first_not_of('-') == std::string_view::npos;
}

/// "------------ Step 10 ----- CPU = 0.05 (sec) -------------"
bool is_block_head(const Words& w) {
  return w.size() == 9 && is_rule(w[0]) && w[1] == "Step" && is_rule(w[3]) && w[4] == "CPU" &&
         w[5] == "=" && is_rule(w[8]);
}

bool is_yaml_keywords(std::string_view line) { return line.starts_with("keywords:"); }

/// Passes over a log and keeps what is thermodynamic output.
class LogReader {
 public:
  explicit LogReader(const std::filesystem::path& path) : lines_(open_bytes(path)) {
    log_.path = path.string();
  }

  ThermoLog read() {
    while (const auto line = lines_.line()) {
      if (lines_.number() == 1) first_line(*line);
      use(*line);
    }
    if (lines_.number() == 0) first_line({});
    end();
    log_.input = lines_.bytes().record();
    return std::move(log_);
  }

 private:
  enum class Place { outside, before_keywords, rows, blocks, yaml };

  [[noreturn]] void fail(const std::string& what) const {
    const std::uint64_t line = std::max<std::uint64_t>(lines_.number(), 1);
    throw InputError(fmt::format("{}:{}: {}", log_.path, line, what));
  }

  void first_line(std::string_view line) {
    if (!line.starts_with(beginning))
      fail("not a log of LAMMPS, which begins with 'LAMMPS (' and its version");
    log_.version = shown(line.substr(beginning.size(), line.rfind(')') - beginning.size()));
  }

  void use(std::string_view line) {
    if (line.starts_with("WARNING")) {
      ++log_.warnings;
      other_line();
    } else if (line.starts_with("ERROR")) {
      log_.error = shown(line, 1000);
      close(false);
    } else if (line.starts_with("Loop time of")) {
      close(true);
    } else if (place_ == Place::outside || place_ == Place::before_keywords) {
      outside(line);
    } else if (place_ == Place::rows) {
      row(words_of(line));
    } else if (place_ == Place::blocks) {
      block(words_of(line));
    } else {
      yaml(line);
    }
  }

  void outside(std::string_view line) {
    const Words w = words_of(line);
    if (w.empty()) return;
    if (is_block_head(w)) {
      begin(Place::blocks);
      block(w);
    } else if (is_yaml_keywords(line) && after_rule_) {
      begin(Place::yaml);
      keywords(line);
    } else if (w[0] == "---") {
      after_rule_ = true;
      return;
    } else if (place_ == Place::before_keywords || (w[0] == "Step" && w.size() > 1)) {
      sure_ = place_ == Place::before_keywords;
      begin(Place::rows);
      for (const std::string_view name : w) add_column(name);
    } else if (line.starts_with("Per MPI rank memory") || line.starts_with("Memory usage per")) {
      place_ = Place::before_keywords;
    } else {
      setting(w);
    }
    after_rule_ = false;
  }

  /// Commands that the log shows, and what LAMMPS says of the set-up of a run.
  void setting(const Words& w) {
    const bool said = w.size() == 4 && w[2] == ":";
    if (w[0] == "units" && w.size() > 1) units(w[1]);
    if (said && w[0] == "Unit" && w[1] == "style") units(w[3]);
    if (w[0] == "timestep" && w.size() > 1) timestep(w[1]);
    if (said && w[0] == "Time" && w[1] == "step") timestep(w[3]);
  }

  /// A variable, as in "units ${system}", is no name; the log shows its value in the next line.
  void units(std::string_view name) {
    const auto found = parse_units(name);
    if (found && log_.units && *found != *log_.units)
      fail(fmt::format("units change from {} to {}; cut the log between the two",
                       mdana::name(*log_.units), shown(name)));
    if (found) log_.units = found;
  }

  void timestep(std::string_view text) {
    if (const auto found = printed_number(text)) timestep_ = found->value;
  }

  void begin(Place place) {
    place_ = place;
    section_ = {};
    section_.first_line = lines_.number();
    section_.timestep = timestep_;
    block_.clear();
    names_known_ = false;
  }

  void add_column(std::string_view name) {
    if (section_.table.columns.size() == most_columns)
      fail(fmt::format("more than {} columns", most_columns));
    if (name.size() > longest_column_name)
      fail(fmt::format("the name '{}' of a column has {} bytes", shown(name), name.size()));
    section_.table.columns.push_back({std::string(name), {}, 0});
  }

  void other_line() {
    if (place_ != Place::outside && place_ != Place::before_keywords) ++section_.other_lines;
  }

  void add_row(const std::vector<Printed>& row) {
    if ((numbers_ += row.size()) > most_numbers)
      fail(fmt::format("more than {} numbers; cut the log", most_numbers));
    for (std::size_t k = 0; k < row.size(); ++k) {
      ThermoTable::Column& column = section_.table.columns[k];
      const bool first = column.values.empty();
      if (first || row[k].last_digit < column.last_digit) column.last_digit = row[k].last_digit;
      column.values.push_back(row[k].value);
    }
  }

  /// The numbers of a row; throws if one is none.
  template <class Texts>
  std::vector<Printed> numbers(const Texts& texts) const {
    if (texts.size() != section_.table.columns.size())
      fail(fmt::format("{} values (line {} names {} columns)", texts.size(), section_.first_line,
                       section_.table.columns.size()));
    std::vector<Printed> row;
    for (const std::string_view text : texts) {
      const auto number = printed_number(text);
      if (!number)
        fail(fmt::format("'{}' in column {} is not a number", shown(text),
                         section_.table.columns[row.size()].name));
      row.push_back(*number);
    }
    return row;
  }

  /// Lines that do not begin with a number are not rows.
  void row(const Words& w) {
    const bool numeric = !w.empty() && printed_number(w[0]);
    const bool first = section_.table.rows() == 0;
    if (first && !sure_ && !(numeric && w.size() == section_.table.columns.size())) {
      place_ = Place::outside;  // words that only look like keywords
    } else if (numeric) {
      add_row(numbers(w));
    } else {
      other_line();
    }
  }

  void yaml(std::string_view line) {
    if (trimmed(line) == "...") return close(true);
    if (trimmed(line) == "data:") return;
    const auto item = list_item(line);
    if (!item || !item->starts_with('[')) return other_line();
    const auto values = flow_list(*item);
    if (!values) fail("a row is not a list of numbers");
    add_row(numbers(*values));
  }

  void keywords(std::string_view line) {
    const auto names = flow_list(line.substr(line.find(':') + 1));
    if (!names) fail("the keywords are not a list of words");
    for (const std::string& name : *names) add_column(name);
  }

  struct Named {
    std::string name;
    Printed printed;
  };

  /// A head begins the next block; the lines below it say "name = number", up to three times.
  void block(const Words& w) {
    if (is_block_head(w)) {
      close_block();
      block_value("Step", w[2]);
      block_value("CPU", w[6]);
      return;
    }
    bool equations = !w.empty() && w.size() % 3 == 0;
    for (std::size_t k = 1; k < w.size(); k += 3) equations = equations && w[k] == "=";
    if (!equations) return other_line();
    for (std::size_t k = 0; k < w.size(); k += 3) block_value(w[k], w[k + 2]);
  }

  void block_value(std::string_view name, std::string_view text) {
    const auto number = printed_number(text);
    if (!number) fail(fmt::format("'{}' of {} is not a number", shown(text), shown(name)));
    const bool in_head = block_.size() >= 2 && (name == "Step" || name == "CPU");
    if (!in_head) block_.push_back({std::string(name), *number});
  }

  /// The first block gives the names of the columns.
  void close_block() {
    if (block_.empty()) return;
    if (!names_known_)
      for (const Named& value : block_) add_column(value.name);
    names_known_ = true;
    const auto& columns = section_.table.columns;
    bool same = block_.size() == columns.size();
    for (std::size_t k = 0; same && k < columns.size(); ++k)
      same = block_[k].name == columns[k].name;
    if (!same)
      fail(
          fmt::format("the block that ends here has {} values, or other names than the {} of the "
                      "first one (line {})",
                      block_.size(), columns.size(), section_.first_line));
    std::vector<Printed> row;
    for (const Named& value : block_) row.push_back(value.printed);
    add_row(row);
    block_.clear();
  }

  void close(bool finished) {
    if (place_ == Place::blocks && finished) close_block();
    const bool open = place_ != Place::outside && place_ != Place::before_keywords;
    const bool doubtful = place_ == Place::rows && !sure_ && section_.table.rows() == 0;
    place_ = Place::outside;
    if (!open || doubtful) return;
    section_.finished = finished;
    if (log_.sections.size() == most_sections)
      fail(fmt::format("more than {} runs; cut the log", most_sections));
    log_.sections.push_back(std::move(section_));
  }

  void end() {
    const bool open = place_ != Place::outside && place_ != Place::before_keywords;
    const std::uint64_t last = lines_.number();
    bool incomplete = lines_.unfinished();
    if (place_ == Place::blocks) {  // the last block is whole if it is as long as the others
      if (names_known_ && !incomplete && block_.size() == section_.table.columns.size())
        close_block();
      incomplete = incomplete || !block_.empty();
    }
    close(false);
    const std::string damage = lines_.bytes().damage();
    if (!damage.empty()) log_.cut = damage + "; ";
    if (open || incomplete || !damage.empty())
      log_.cut += fmt::format("the log ends{} behind line {}{}", open ? " within a run" : "", last,
                              incomplete ? ", within a row or line, which is left out" : "");
  }

  LineReader lines_;
  ThermoLog log_;
  Place place_ = Place::outside;
  ThermoSection section_;     ///< that is being read
  std::vector<Named> block_;  ///< that is being read
  bool names_known_ = false;
  bool sure_ = false;        ///< the keywords stand where LAMMPS prints them
  bool after_rule_ = false;  ///< the line before is "---"
  std::optional<double> timestep_;
  std::size_t numbers_ = 0;  ///< kept
};

}  // namespace

const ThermoTable::Column* ThermoTable::find(std::string_view name) const {
  for (const Column& column : columns)
    if (column.name == name) return &column;
  return nullptr;
}

bool is_lammps_log(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  char head[beginning.size()];
  return std::string_view(head, open_bytes(path)->read(head)) == beginning;
}

ThermoLog read_thermo_log(const std::filesystem::path& path) { return LogReader(path).read(); }

}  // namespace mdana
