// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "reports/accuracy.hpp"
#include "reports/accuracy/price.hpp"

namespace mdana {
namespace {

using Numbers = std::vector<JudgedNumber>;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// A value of the knob that could be measured.
struct Rung {
  KnobValue value;
  std::vector<Numbers> draws;  ///< one if nothing is drawn at random
  Cost cost;
};

bool same_bits(const Numbers& a, const Numbers& b) {
  return std::ranges::equal(a, b, [](const JudgedNumber& x, const JudgedNumber& y) {
    return x.name == y.name && (x.value.value == y.value.value || (std::isnan(x.value.value) && std::isnan(y.value.value)));
  });
}

Rung measure(const AccuracySubject& subject, const Knob& knob, std::size_t k, int repetitions) {
  KnobChoice choice;
  choice.values[knob.name] = k;
  Rung rung{knob.values[k], {}, {}};
  rung.cost = price_of(static_cast<std::size_t>(knob.draws > 1 ? knob.draws : repetitions), [&] {
    Numbers numbers = subject.measure(choice);
    if (knob.draws > 1)
      ++choice.draw;
    else if (!rung.draws.empty() && !same_bits(rung.draws[0], numbers))
      throw std::logic_error(fmt::format("{}, {} {}: the same measurement gives other numbers when it is repeated",
                                         subject.name, knob.name, rung.value.text));
    if (knob.draws > 1 || rung.draws.empty()) rung.draws.push_back(std::move(numbers));
  });
  return rung;
}

/// Of one number, the values that were drawn; none if a draw lacks it.
std::vector<double> values_of(const Rung& rung, const std::string& quantity) {
  std::vector<double> values;
  for (const Numbers& numbers : rung.draws)
    if (const auto at = std::ranges::find(numbers, quantity, &JudgedNumber::name); at != numbers.end())
      values.push_back(at->value.value);
  return values.size() == rung.draws.size() ? values : std::vector<double>{};
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? not_known : sum / static_cast<double>(values.size());
}

/// Root mean square distance from a number.
double distance(const std::vector<double>& values, double from) {
  double squares = 0;
  for (const double v : values) squares += (v - from) * (v - from);
  return values.empty() ? not_known : std::sqrt(squares / static_cast<double>(values.size()));
}

/// What is left at the finest value, by the two or three finest: |x1 - x0| / (r^p - 1).
double extrapolated(const std::vector<double>& x, const std::vector<double>& h, double greatest_order) {
  const double change = std::abs(x[1] - x[0]), ratio = h[1] / h[0];
  if (greatest_order <= 0 || !(ratio > 1)) return change;
  double order = 1;
  if (x.size() > 2 && change > 0 && h[2] > h[1])
    order = std::log(std::abs(x[2] - x[1]) / change) / std::log(std::sqrt(h[2] / h[0]));
  order = std::isnan(order) ? 1 : std::clamp(order, std::min(1.0, greatest_order), greatest_order);
  return change / (std::pow(ratio, order) - 1);
}

/// The number that one quantity is compared with, and its own error.
struct Compared {
  double value, error;
};

Compared reference_of(const std::vector<Rung>& rungs, const AccuracySubject& subject, const Knob& knob,
                      const std::string& quantity) {
  if (const auto known = subject.exact.find(quantity); known != subject.exact.end()) return {known->second, 0};
  const std::vector<double> finest = values_of(rungs[0], quantity);
  if (knob.draws > 1) return {mean(finest), distance(finest, mean(finest)) / std::sqrt(static_cast<double>(finest.size()))};
  if (knob.reference != Reference::finest) return {finest[0], 0};
  std::vector<double> x, h;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, rungs.size()); ++k) {
    const std::vector<double> values = values_of(rungs[k], quantity);
    if (values.empty() || std::isnan(values[0])) break;
    x.push_back(values[0]), h.push_back(rungs[k].value.number);
  }
  return {finest[0], x.size() < 2 ? not_known : extrapolated(x, h, knob.order)};
}

double error_of(const Rung& rung, const std::string& quantity, const Compared& reference, const Knob& knob) {
  const double away = distance(values_of(rung, quantity), reference.value);
  return knob.draws > 1 ? std::hypot(away, reference.error) : away + reference.error;
}

const JudgedNumber* number_of(const Rung& rung, const std::string& quantity) {
  const auto at = std::ranges::find(rung.draws[0], quantity, &JudgedNumber::name);
  return at == rung.draws[0].end() ? nullptr : &*at;
}

/// The rows of one quantity.
void add_rows(const std::vector<Rung>& rungs, const AccuracySubject& subject, const JudgedNumber& judged, Ladder& ladder) {
  const Compared reference = reference_of(rungs, subject, ladder.knob, judged.name);
  const std::size_t first = ladder.rows.size();
  for (const Rung& rung : rungs) {
    AccuracyRow row{{}, subject.name, ladder.knob.name, rung.value.text, judged.name, rung.value.number,
                    mean(values_of(rung, judged.name)), error_of(rung, judged.name, reference, ladder.knob) / judged.size(),
                    not_known, not_known, rung.cost};
    if (const JudgedNumber* number = number_of(rung, judged.name)) row.stated = number->stated();
    ladder.rows.push_back(std::move(row));
  }
  const bool known = subject.exact.contains(judged.name);
  if (ladder.knob.reference != Reference::finest && !known) return;  // a change from a default has no order
  // The finest value's error follows from those of the next two, unless the number is known.
  const std::size_t free = known || ladder.knob.draws > 1 ? 1 : 2;
  for (std::size_t k = first + free; k < ladder.rows.size(); ++k) {
    const AccuracyRow &finer = ladder.rows[k - 1], &row = ladder.rows[k];
    ladder.rows[k].order = std::log(row.error / finer.error) / std::log(row.number / finer.number);
  }
}

}  // namespace

double JudgedNumber::stated() const { return value.error ? *value.error / size() : not_known; }

std::string_view name(Reference reference) {
  constexpr std::array<std::string_view, 3> names{"finest", "default", "same bits"};
  return names[static_cast<std::size_t>(reference)];
}

std::size_t KnobChoice::of(std::string_view knob) const {
  const auto at = values.find(knob);
  return at == values.end() ? 0 : at->second;
}

const Knob& AccuracySubject::knob(std::string_view wanted) const {
  const auto at = std::ranges::find(knobs, wanted, &Knob::name);
  if (at == knobs.end()) throw std::out_of_range(fmt::format("{} has no knob {}", name, wanted));
  return *at;
}

double Ladder::error_at(const std::string& setting) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double greatest = -1, first_stated = not_known;
  const std::string* quantity = nullptr;
  for (const AccuracyRow& row : rows) {
    if (!quantity || *quantity != row.quantity) first_stated = row.stated;
    quantity = &row.quantity;
    if (row.setting != setting) continue;
    const double added = 0.5 * (row.stated - first_stated);  // that `stated` holds with twice its size
    greatest = std::isnan(row.error) ? infinite : std::max({greatest, row.error, std::isnan(added) ? 0 : added});
  }
  return greatest < 0 ? infinite : greatest;
}

Ladder climb(const AccuracySubject& subject, const Knob& knob, int repetitions) {
  Ladder ladder{subject.name, knob, {}, {}};
  std::vector<Rung> rungs;
  for (std::size_t k = 0; k < knob.values.size(); ++k) try {
      rungs.push_back(measure(subject, knob, k, repetitions));
    } catch (const InputError& error) {
      if (k == 0) throw;
      if (ladder.left_out.empty()) ladder.left_out = fmt::format("{}: {}", knob.values[k].text, error.what());
    }
  for (const JudgedNumber& judged : rungs[0].draws[0])
    if (!std::isnan(judged.value.value)) add_rows(rungs, subject, judged, ladder);
  return ladder;
}

AccuracySubject judged_by(AccuracySubject subject, std::vector<std::string> numbers) {
  if (numbers.empty()) return subject;
  subject.measure = [measure = std::move(subject.measure), numbers, name = subject.name](const KnobChoice& choice) {
    Numbers all = measure(choice);
    std::vector<std::string> known;
    for (const JudgedNumber& n : all) known.push_back(n.name);
    std::erase_if(all, [&](const JudgedNumber& n) { return std::ranges::find(numbers, n.name) == numbers.end(); });
    if (all.empty())
      throw InputError(fmt::format("{} gives no {}; its numbers are {}", name, fmt::join(numbers, ", "), fmt::join(known, ", ")));
    return all;
  };
  return subject;
}

}  // namespace mdana
