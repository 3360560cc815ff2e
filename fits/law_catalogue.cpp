// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/law_catalogue.hpp"

#include "fits/law_cases.hpp"

namespace mdana {

std::vector<LawCase> law_catalogue() {
  Catalogue c;
  add_scaling_cases(c);
  add_plain_cases(c);
  add_adhesive_cases(c);
  return std::move(c.cases);
}

}  // namespace mdana
