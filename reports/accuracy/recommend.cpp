// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <tuple>

#include "readers/input_error.hpp"
#include "reports/accuracy.hpp"
#include "reports/accuracy/price.hpp"

namespace mdana {
namespace {

using Numbers = std::vector<JudgedNumber>;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A knob's ladder, and which of its values is taken.
struct Taken {
  const Ladder* ladder;
  std::size_t value = 0;

  double error() const { return ladder->error_at(ladder->knob.values[value].text); }
};

/// The last, cheapest value that is good enough, else the best one.
Taken cheapest(const Ladder& ladder, double wanted) {
  Taken taken{&ladder};
  for (std::size_t k = ladder.knob.values.size(); k-- > 0;)
    if (Taken{&ladder, k}.error() <= wanted) return {&ladder, k};
  for (std::size_t k = 1; k < ladder.knob.values.size(); ++k)
    if (Taken{&ladder, k}.error() < taken.error()) taken.value = k;
  return taken;
}

KnobChoice choice_of(const std::vector<Taken>& taken) {
  KnobChoice choice;
  for (const Taken& t : taken) choice.values[t.ladder->knob.name] = t.value;
  return choice;
}

/// The first row of a quantity, which is that of the reference.
const AccuracyRow* reference_row(const Ladder& ladder, const std::string& quantity) {
  const auto at = std::ranges::find(ladder.rows, quantity, &AccuracyRow::quantity);
  return at == ladder.rows.end() ? nullptr : &*at;
}

/// |value - reference| and the errors that the references have by all knobs, as a part of the size.
double error_of(const JudgedNumber& number, const AccuracySubject& subject, const std::vector<Taken>& taken) {
  const auto known = subject.exact.find(number.name);
  if (known != subject.exact.end()) return std::abs(number.value.value - known->second) / number.size();
  double squares = 0, value = std::numeric_limits<double>::quiet_NaN();
  for (const Taken& t : taken)
    if (const AccuracyRow* row = reference_row(*t.ladder, number.name)) {
      value = row->value;
      if (!std::isnan(row->error)) squares += row->error * row->error;
    }
  return std::abs(number.value.value - value) / number.size() + std::sqrt(squares);
}

/// Measures what is taken.
Recommendation verified(const AccuracySubject& subject, const std::vector<Taken>& taken, double wanted) {
  Recommendation r{subject.name, wanted, choice_of(taken), {}, 0, {}, {}};
  for (const Taken& t : taken) r.settings.emplace_back(t.ladder->knob.name, t.ladder->knob.values[t.value].text);
  Numbers numbers;
  r.cost = price_of(1, [&] { numbers = subject.measure(r.choice); });
  for (const JudgedNumber& number : numbers)
    if (const double error = error_of(number, subject, taken); error >= r.error) r.error = error, r.quantity = number.name;
  return r;
}

bool can_be_dearer(const Taken& t) { return t.value > 0; }

/// The greatest error that a number is known to have: what it states, and how far it is from the one before.
std::pair<double, std::string> doubt(const Numbers& numbers, const std::optional<Numbers>& before, bool last) {
  std::pair<double, std::string> worst{0, {}};
  for (const JudgedNumber& n : numbers) {
    if (std::isnan(n.value.value)) continue;
    double error = std::isnan(n.stated()) ? infinite : n.stated();
    if (!before && !last) error = infinite;
    if (before)
      if (const auto at = std::ranges::find(*before, n.name, &JudgedNumber::name); at != before->end() && !std::isnan(at->value.value))
        error = std::max(error, last ? 0.0 : std::abs(n.value.value - at->value.value) / n.size());
    if (error >= worst.first) worst = {error, n.name};
  }
  return worst;
}

}  // namespace

Recommendation recommend(const AccuracySubject& subject, std::span<const Ladder> ladders, double wanted) {
  std::vector<Taken> taken;
  for (const Ladder& ladder : ladders)
    if (ladder.knob.reference == Reference::finest && ladder.knob.draws == 1) taken.push_back(cheapest(ladder, wanted));
  while (true) {
    Recommendation r = verified(subject, taken, wanted);
    if (r.met() || std::ranges::none_of(taken, can_be_dearer)) return r;
    const auto worst = std::ranges::max_element(taken, {}, [](const Taken& t) { return t.value == 0 ? -1 : t.error(); });
    --worst->value;
  }
}

Recommendation choose(const AccuracySubject& subject, const Knob& knob, double wanted) {
  Recommendation r{subject.name, wanted, {}, {}, infinite, {}, {}};
  std::optional<Numbers> before;
  for (std::size_t k = knob.values.size(); k-- > 0;) {
    KnobChoice choice;
    choice.values[knob.name] = k;
    Numbers numbers;
    try {
      r.cost = price_of(1, [&] { numbers = subject.measure(choice); });
    } catch (const InputError&) {
      if (k == 0) throw;
      continue;  // too few frames are left: finer values have more
    }
    r.choice = choice;
    r.settings = {{knob.name, knob.values[k].text}};
    std::tie(r.error, r.quantity) = doubt(numbers, before, k == 0);
    if (r.met()) return r;
    before = std::move(numbers);
  }
  return r;
}

}  // namespace mdana
