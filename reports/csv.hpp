// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analyses/table.hpp"

namespace mdana {

/// The table as CSV (RFC 4180): a line of names, then a line a row. Numbers are the shortest that
/// read back to the same bits; missing values are empty; labelled values are their labels.
std::string to_csv(const Table& table);

}  // namespace mdana
