// SPDX-License-Identifier: GPL-3.0-or-later
// In the place of the bundled script in a build without npm.
#include "reports/page_script.hpp"

namespace mdana {

const Trusted page_script{"", ""};

}  // namespace mdana
