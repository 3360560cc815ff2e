// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "analyses/force_curve.hpp"
#include "analyses/table.hpp"
#include "analyses/value.hpp"
#include "reports/document.hpp"

namespace mdana {

/// A share of trials and the interval that covers it at 95 %.
struct BinomialShare {
  double value, low, high;
};

/// Score interval of Wilson, J. Am. Stat. Assoc. 22 (1927) 209. NaN without trials.
BinomialShare wilson(std::size_t successes, std::size_t trials);

/// What a run of a series ended with.
struct SeriesOutcome {
  std::string dump;
  std::string failure;              ///< why there is nothing else; else empty
  std::optional<Outcome> outcome;
  Value e, e_total, speed_before;   ///< NaN where not determined
};

/// Root of the mean square of numbers, its error (by that of the mean square), and their spread, the
/// sample standard deviation about their mean; NaN without numbers, the last two for one.
struct RootMeanSquare {
  Value value;
  double spread;
  std::size_t count;
};
RootMeanSquare root_mean_square(std::span<const double> values);

/// `summary`: counts, sticking probability, RMS e and its spread over runs (Yoshida, Kokubo & Tanaka
/// 2024, Figs. 7, 8: of all runs, e = 0 for those that stick) and over those that bounce.
void add_summary(Document& document, std::span<const SeriesOutcome> outcomes);

/// Columns dump, outcome, e, e_error, e_total, speed_before: a row a run.
Table outcome_table(std::span<const SeriesOutcome> outcomes);

}  // namespace mdana
