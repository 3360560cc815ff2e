// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyses/restitution.hpp"
#include "analyses/value.hpp"
#include "reports/contact_numbers.hpp"
#include "reports/defect_numbers.hpp"
#include "reports/fitted.hpp"
#include "reports/measured.hpp"
#include "reports/measured_energy.hpp"
#include "reports/plan.hpp"
#include "reports/run.hpp"

namespace mdana {

/// What is wanted of one pass over a collision, and what the dump does not say.
struct RunWishes {
  Plan plan;
  std::optional<Radii> radii;  ///< place delta; without them the fitted R if it is fitted, else find_radii
  ContactOptions contact;
  PotentialOptions potential;
  HertzSettings hertz_settings = {};
};

/// Everything that is known of a collision from one pass over the dump.
struct AnalysedRun {
  Plan plan;                ///< with what turned out not to be possible left out
  MeasuredMotion measured;  ///< tables: motion, those of the contact radius, far_side and energy if wanted
  ForceSource source = ForceSource::velocities;
  Radii radii;
  ForceCurve curve;
  Restitution restitution;
  std::optional<ContactSetup> contact_setup;  ///< nothing: the contact radius cannot be measured
  std::size_t contact_tables = 0;
  ContactNumbers contact;                     ///< with a set-up
  std::optional<HertzResult> hertz;
  std::optional<MeasuredEnergy> energy;
  std::optional<DefectHistory> defects;
  double seconds = 0;                         ///< reading, analyses and fits

  bool touch() const { return contact_setup && contact.touch(); }
  const Table& contact_table() const { return measured.swept.tables[1]; }
  const Table& far_side() const { return measured.swept.tables[contact_tables + 1]; }  ///< with energies
  std::vector<PublishedValue> numbers() const;  ///< published ones of force, contact radius and fit
};

/// The wishes that give the published numbers of a run anew, and nothing else.
RunWishes same_numbers(const AnalysedRun& analysed);

/// Throws InputError.
AnalysedRun analyse_run(const Run& run, const RunWishes& wishes, const SweepOptions& options);

/// All that is told of a collision besides the Hertz fit, under the names that other programs rely on, and
/// a table with a row a frame: force, contact radius, far sides, energies, as far as they were measured, and
/// laws beside them. `contact` has R*, and E* and gamma or 0. `final_clusters`: look for exchanged atoms
/// however many atoms there are; this reads frames again.
Table add_collision(Document& document, const Run& run, const AnalysedRun& analysed, const ElasticContact& contact,
                    const SweepOptions& sweeping, bool final_clusters);

}  // namespace mdana
