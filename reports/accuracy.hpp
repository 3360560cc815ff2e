// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analyses/table.hpp"
#include "analyses/value.hpp"

namespace mdana {

/// A number whose error is judged.
struct JudgedNumber {
  std::string name;  ///< "F_max"
  Value value;       ///< with the error that is stated of it
  double scale = 0;  ///< that errors are parts of, > 0; 0: |value| itself

  double size() const { return scale > 0 ? scale : std::abs(value.value); }
  double stated() const;  ///< error as a part of the size; NaN if none is stated
};

/// What the values of a knob are compared with.
enum class Reference {
  finest,    ///< the first value; the error falls towards it
  standard,  ///< the first value, which is the default; none is nearer to the truth by itself
  bits       ///< the first value; nothing may change
};
std::string_view name(Reference reference);

/// A value of a knob.
struct KnobValue {
  std::string text;  ///< "every 2nd frame"
  double number = std::numeric_limits<double>::quiet_NaN();  ///< that the error is a power of
};

/// Something that can be chosen, as data. Values from the finest, dearest one on, or from the default on.
struct Knob {
  std::string name;     ///< "stride"
  std::string meaning;  ///< "use every K-th frame only"
  Reference reference = Reference::finest;
  double order = 0;     ///< greatest p of error ~ number^p that may be counted with; 0: not known
  std::vector<KnobValue> values;
  int draws = 1;        ///< more: values are drawn at random; errors are root mean squares over the draws
};

/// What could be chosen elsewhere, and is not: told beside the knobs.
struct FixedChoice {
  std::string name, value, reason;  ///< "block-size", "32768 atoms", why
};

/// What is chosen: the values of knobs that are not at their first one, and the seed of draws.
struct KnobChoice {
  std::map<std::string, std::size_t, std::less<>> values;
  std::uint64_t draw = 1;

  std::size_t of(std::string_view knob) const;
};

/// An analysis or a fit whose numbers depend on knobs.
struct AccuracySubject {
  std::string name;  ///< of the command that gives the numbers: "force"
  std::vector<Knob> knobs;
  std::function<std::vector<JudgedNumber>(const KnobChoice&)> measure;  ///< throws InputError
  std::map<std::string, double> exact = {};  ///< numbers that are known
  std::vector<FixedChoice> fixed = {};

  const Knob& knob(std::string_view name) const;  ///< throws std::out_of_range
};

/// Price of a measurement.
struct Cost {
  double seconds = 0, spread = 0;  ///< median, and greatest less least
  double memory = 0;               ///< greatest resident size of the program meanwhile [bytes]; NaN if not known
};

/// One number at one value of a knob.
struct AccuracyRow {
  std::string input;     ///< that the subject is measured of; set by the caller
  std::string subject, knob, setting, quantity;
  double number = 0;     ///< of the knob's value; NaN if it has none
  double value = 0;      ///< of the quantity; of draws the mean
  double error = 0;      ///< distance from the reference, with the reference's own error, as a part of the size
  double stated = 0;     ///< the error that the number states of itself, likewise; NaN if none
  double order = 0;      ///< that the errors of this and the value before show; NaN if not known
  Cost cost;
};

/// All numbers over the values of one knob, in their order, number by number. Values that cannot be measured
/// are left out, and the first reason is told.
struct Ladder {
  std::string subject;
  Knob knob;
  std::vector<AccuracyRow> rows;
  std::string left_out;

  /// Greatest error of all numbers at a value of the knob, at least half of what their stated errors have grown by: some are
  /// near the reference by chance, as an extreme that a coarse sampling happens to meet. Infinite if it was not measured.
  double error_at(const std::string& setting) const;
};

/// Measures all values of a knob, so many times each for the cost. The error of a row is |value - reference| and the
/// reference's own error together. That is 0 for a number that is known; for the finest value what Richardson's
/// extrapolation of the two finest leaves, by the order that the three finest show (at least 1, at most the
/// knob's); of a default and of bits 0. Throws std::logic_error if a measurement does not repeat itself.
Ladder climb(const AccuracySubject& subject, const Knob& knob, int repetitions);

/// The cheapest values of the knobs that were measured, those with the finest value for a reference, that meet a wanted error
/// together.
struct Recommendation {
  std::string subject;
  double wanted = 0;
  KnobChoice choice;
  std::vector<std::pair<std::string, std::string>> settings;  ///< knob, value
  double error = 0;      ///< greatest of all numbers, of all knobs together, as measured
  std::string quantity;  ///< that has it
  Cost cost;
  bool met() const { return error <= wanted; }
};

/// Takes the cheapest value of each knob whose error is small enough, measures them together, and goes back
/// to a dearer value of the knob with the greatest error until the wanted one is met.
Recommendation recommend(const AccuracySubject& subject, std::span<const Ladder> ladders, double wanted);

/// The same without a reference, before or instead of a measurement: from the cheapest value of one knob on to dearer ones,
/// until both the errors that the numbers state and the change from the value before are small enough.
/// Throws InputError if not even the dearest can be measured.
Recommendation choose(const AccuracySubject& subject, const Knob& knob, double wanted);

/// The subject with some of its numbers only. Throws InputError, when it is measured, if it has none of them.
AccuracySubject judged_by(AccuracySubject subject, std::vector<std::string> numbers);

/// The row of what is fixed: no number, no error.
AccuracyRow fixed_row(const AccuracySubject& subject, const FixedChoice& fixed);

/// Columns input, subject, knob, setting, number, quantity, curve (of a figure: the names before), value,
/// error, stated, order, seconds, spread, memory: a row a row.
Table accuracy_table(std::span<const AccuracyRow> rows);

}  // namespace mdana
