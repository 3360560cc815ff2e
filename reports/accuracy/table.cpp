// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "reports/accuracy.hpp"
#include "reports/row_columns.hpp"

namespace mdana {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string curve_of(const AccuracyRow& row) {
  return fmt::format("{}{}{}: {}: {}", row.input, row.input.empty() ? "" : ": ", row.subject, row.knob, row.quantity);
}

}  // namespace

AccuracyRow fixed_row(const AccuracySubject& subject, const FixedChoice& fixed) {
  return {{}, subject.name, fixed.name, fixed.value + " (fixed)", {}, none, none, none, none, none, {none, none, none}};
}

Table accuracy_table(std::span<const AccuracyRow> rows) {
  Table table;
  add_words(table, "input", rows, [](const AccuracyRow& r) { return r.input; });
  add_words(table, "subject", rows, [](const AccuracyRow& r) { return r.subject; });
  add_words(table, "knob", rows, [](const AccuracyRow& r) { return r.knob; });
  add_words(table, "setting", rows, [](const AccuracyRow& r) { return r.setting; });
  add_numbers(table, "number", rows, [](const AccuracyRow& r) { return r.number; });
  add_words(table, "quantity", rows, [](const AccuracyRow& r) { return r.quantity; });
  add_words(table, "curve", rows, curve_of);
  add_numbers(table, "value", rows, [](const AccuracyRow& r) { return r.value; });
  add_numbers(table, "error", rows, [](const AccuracyRow& r) { return r.error; });
  add_numbers(table, "stated", rows, [](const AccuracyRow& r) { return r.stated; });
  add_numbers(table, "order", rows, [](const AccuracyRow& r) { return r.order; });
  add_numbers(table, "seconds", rows, [](const AccuracyRow& r) { return r.cost.seconds; });
  add_numbers(table, "spread", rows, [](const AccuracyRow& r) { return r.cost.spread; });
  add_numbers(table, "memory", rows, [](const AccuracyRow& r) { return r.cost.memory; });
  return table;
}

}  // namespace mdana
