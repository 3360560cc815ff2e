// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/defects.hpp"
#include "fits/contact_fit.hpp"
#include "fits/force_fit.hpp"
#include "reports/accuracy.hpp"
#include "reports/analysed_run.hpp"
#include "reports/compared_laws.hpp"
#include "reports/compressed.hpp"
#include "reports/network.hpp"
#include "reports/run.hpp"

namespace mdana {

/// A dump, and what is the same of it whatever is looked at. The run must outlive the subjects.
struct DumpQuestion {
  const Run& run;
  RunOptions options;
  SweepOptions sweeping;
  ContactOptions contact = {};
  PotentialOptions potential = {};
  std::optional<ForceSource> source = {};  ///< default: the best
  HertzSettings hertz = {};
  Split split = Split::sign;               ///< of aggregates
  SurfaceOffset offset = {};
  NetworkOptions network = {};             ///< likewise
  const ForceLaw* law = nullptr;           ///< of fit-force
  ForceFitSettings force_fit = {};
  DefectSettings defects = {};
};

/// The analyses of a dump of two bodies with their knobs. Each judges the numbers that its command publishes;
/// errors of differences (least force, loop area, losses) are parts of F_max and of the kinetic energy. Some throw InputError
/// where their command would.
AccuracySubject force_subject(const DumpQuestion& question);
AccuracySubject contact_radius_subject(const DumpQuestion& question);
AccuracySubject energy_subject(const DumpQuestion& question);
AccuracySubject fit_hertz_subject(const DumpQuestion& question);
/// Of the question's law. Stated errors are also the differences to fits of every second frame.
AccuracySubject fit_force_subject(const DumpQuestion& question);
AccuracySubject collision_subject(const DumpQuestion& question);
AccuracySubject surface_energy_subject(const DumpQuestion& question);  ///< of body 1 by the scene's potential
AccuracySubject compress_subject(const DumpQuestion& question);
AccuracySubject network_subject(const DumpQuestion& question);
AccuracySubject defects_subject(const DumpQuestion& question);  ///< measure throws if this build has none

/// Those that apply to a scene; what they cannot tell is left out, with the reason.
struct DumpSubjects {
  std::vector<AccuracySubject> subjects;
  std::vector<std::pair<std::string, std::string>> left_out;
};
DumpSubjects dump_subjects(const DumpQuestion& question);

/// All published numbers of a run from one pass, for a report. Knobs: stride and, of a Hertz fit, method.
AccuracySubject run_subject(const Run& run, const AnalysedRun& full, const SweepOptions& sweeping);

/// How many times a report measures each of its settings.
inline constexpr int report_repetitions = 3;

/// Passes over the dump that this takes, and how many times the number of its frames are analysed in them.
struct AccuracyPasses {
  double passes = 0, all_frames = 0;
};
AccuracyPasses accuracy_passes(bool hertz);

/// A collision by a law; knob: tolerance.
AccuracySubject predict_subject(const CollisionLaw& law, const CollisionInput& input, const CollisionSettings& settings);

/// Parameters of a law from collisions that were seen; knobs: starts, loss, draws of the bootstrap.
AccuracySubject fit_contact_subject(const CollisionLaw& law, std::vector<ObservedCollision> seen,
                                    const ContactFitSettings& settings);

/// All laws on collisions that were seen, by what their AIC follows from; knobs: starts, loss.
AccuracySubject compare_laws_subject(const Observations& observations, const ContactFitSettings& settings);

}  // namespace mdana
