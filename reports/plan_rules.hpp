// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "reports/plan.hpp"

namespace mdana {

/// A run and what is asked of it.
struct Asked {
  const Run& run;
  const PlanWishes& wishes;

  Interaction interaction() const { return run.scene.interaction; }
  ForceSource source() const { return wishes.source ? *wishes.source : best_force_source(run); }  ///< throws InputError
  bool has_gamma() const { return wishes.surface_energy.value_or(run.scene.surface_energy.value_or(0)) > 0; }
};

/// When a part is computed, and from what.
struct Rule {
  Part part;
  std::string_view name;                     ///< as documents have it
  std::string (*not_needed)(const Asked&);   ///< why the scene does not call for it; else empty
  std::string (*obstacle)(const Asked&);     ///< why dump or build do not allow it; else empty
  std::string (*reason)(const Asked&);       ///< why it is computed as it is; only without the others
  ColumnSet (*columns)(const Asked&);        ///< that it reads; likewise
  std::string_view command = {};             ///< that tells it, if a report does not
};

/// In the order in which parts are told.
std::span<const Rule> plan_rules();

}  // namespace mdana
