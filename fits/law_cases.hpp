// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fits/collision_law.hpp"
#include "fits/law_catalogue.hpp"

namespace mdana {

/// Of a collision, by name.
using CaseParameters = std::map<std::string, double>;

/// Some of them changed.
CaseParameters with(CaseParameters p,
                    std::initializer_list<std::pair<const std::string, double>> changes);

/// The sphere of P1 with R = 147 for every law that the catalogue knows.
const std::map<std::string_view, CaseParameters>& base_cases();

/// Collects the cases of one build.
class Catalogue {
 public:
  std::vector<LawCase> cases;

  /// The collision, whose price goes to the next case; nothing known if the build has no such law.
  Collision run(std::string_view law, const CaseParameters& p, double tolerance = 1e-10);

  void add(std::string_view law, std::string what, double computed, double exact, double needed);

  /// That the spheres stick; to tell that it is not known counts as right, a wrong e does not.
  void add_stick(std::string_view law, std::string what, const Collision& c);

 private:
  long evaluations_ = 0;
  double seconds_ = 0;
  bool unresolved_ = false;
};

/// The same collision in other units, between other spheres, of another size.
void add_scaling_cases(Catalogue& c);
/// JKR and the laws whose crack takes time, and their limits.
void add_adhesive_cases(Catalogue& c);
/// Laws of which something is known without adhesion: hertz, viscous-hertz, power, dmt and the
/// plastic.
void add_plain_cases(Catalogue& c);

}  // namespace mdana
