// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyses/value.hpp"
#include "reports/contact_numbers.hpp"
#include "reports/fitted.hpp"
#include "reports/measured.hpp"
#include "reports/run.hpp"

namespace mdana {

/// A published number and its name.
struct PublishedValue {
  std::string name;
  Value value;
};

/// Everything that a report says of one pass over one run.
struct AnalysedRun {
  MeasuredMotion measured;
  ForceSource source = ForceSource::velocities;
  Radii radii;
  ForceCurve curve;
  ContactSetup contact_setup;
  ContactNumbers contact;
  std::optional<HertzResult> hertz;  ///< of Hertz scenes
  double seconds = 0;                ///< reading, analyses and fits

  const Table& contact_table() const { return measured.swept.tables[1]; }
  std::vector<PublishedValue> numbers() const;  ///< all published numbers
};

/// Force, contact radius and, for a Hertz scene, the fit, in one pass over the dump. `radii` places
/// delta; without them it is the fitted R of a Hertz scene, else find_radii.
AnalysedRun analyse_run(const Run& run, const std::optional<Radii>& radii,
                        const SweepOptions& options);

}  // namespace mdana
