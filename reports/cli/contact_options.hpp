// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/contact_fit.hpp"
#include "reports/cli/command.hpp"
#include "reports/observations.hpp"

namespace mdana::cli {

/// The numbers of -p NAME=VALUE. Throws UsageError.
std::vector<NamedNumber> constants_option(const Values& values);

/// Options of every command that fits collision laws to tables: -p, --table2, --loss, --starts, --json, -o.
void add_contact_fit_options(Options& options);

/// The tables, with what --table2 knows; `free` stays free; `wanted` of what was measured, unless
/// --motion asks for all of it.
Observations observations_option(const Values& values, std::span<const std::string> free,
                                 Wanted wanted = Wanted::restitution);

/// Constants, loss and starts; nothing is free yet.
ContactFitSettings contact_settings(const Values& values);

/// The inputs of the tables.
void add_inputs(Document& document, const Observations& observations);

}  // namespace mdana::cli
