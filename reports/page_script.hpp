// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/html.hpp"

namespace mdana {

using html::Trusted;

/// What makes figures, tables and 3-D views of a page interactive, out of reports/page; empty in a build
/// without npm, whose pages are static.
extern const Trusted page_script;

}  // namespace mdana
