// SPDX-License-Identifier: GPL-3.0-or-later
// What applies to a scene.
#include <functional>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"

namespace mdana {
namespace {

using Subject = std::function<AccuracySubject(const DumpQuestion&)>;

/// Adds a subject, or why it does not apply.
void add(DumpSubjects& all, const DumpQuestion& question, const char* name, const Subject& subject) {
  try {
    all.subjects.push_back(subject(question));
  } catch (const InputError& error) {
    all.left_out.emplace_back(name, error.what());
  }
}

void add_hertz(DumpSubjects& all, const DumpQuestion& question) {
  if (question.run.scene.interaction == Interaction::hertz)
    all.subjects.push_back(fit_hertz_subject(question));
  else
    all.left_out.emplace_back("fit-hertz", "the scene does not say that the bodies only repel each other");
}

/// Of spheres that only repel each other Hertz' law, of those that attract each other JKR's.
void add_force_law(DumpSubjects& all, DumpQuestion question) {
  const Interaction interaction = question.run.scene.interaction;
  if (!question.law && interaction == Interaction::hertz) question.law = find_force_law("hertz");
  if (!question.law && interaction == Interaction::adhesive) question.law = find_force_law("jkr");
  if (!question.law) {
    all.left_out.emplace_back("fit-force", "the scene does not say whether the bodies attract each other (interaction)");
    return;
  }
  if (question.force_fit.free.empty()) question.force_fit.free = usual_free_parameters(*question.law);
  all.subjects.push_back(fit_force_subject(question));
}

}  // namespace

DumpSubjects dump_subjects(const DumpQuestion& question) {
  DumpSubjects all;
  if (question.run.scene.interaction == Interaction::aggregate) {
    add(all, question, "compress", compress_subject);
    add(all, question, "network", network_subject);
    return all;
  }
  add(all, question, "force", force_subject);
  add(all, question, "contact-radius", contact_radius_subject);
  if (question.run.first.has_column("vx"))
    all.subjects.push_back(energy_subject(question));
  else
    all.left_out.emplace_back("energy", "the dump has no velocities");
  add_hertz(all, question);
  add_force_law(all, question);
  add(all, question, "surface-energy", surface_energy_subject);
  add(all, question, "collision", collision_subject);
  all.subjects.push_back(defects_subject(question));
  return all;
}

}  // namespace mdana
