// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/contact_fit.hpp"
#include "reports/accuracy.hpp"
#include "reports/accuracy_document.hpp"
#include "reports/cli/command.hpp"

namespace mdana::cli {

/// --error of commands that choose their knobs by it.
void add_error_option(Options& options, const char* knobs);

/// Greater than 0; nothing if it is not given. Throws UsageError.
std::optional<double> wanted_error(const Values& values);

/// With --error: the stride that gives it, which is set. Throws UsageError if a stride is given, too.
std::optional<Recommendation> choose_stride(const Values& values, const AccuracySubject& subject, SweepOptions& sweeping);

/// With --error: as many starts as give it, which are set. Nothing if no fit is usable. Throws UsageError if starts are given,
/// too.
std::optional<Recommendation> choose_starts(const Values& values, const AccuracySubject& subject, ContactFitSettings& settings);

/// Tells what was chosen, if anything was; `code`, or that the wanted error cannot be met.
void tell_choice(Document& document, const std::optional<Recommendation>& chosen);
int choice_code(const std::optional<Recommendation>& chosen, int code);

}  // namespace mdana::cli
