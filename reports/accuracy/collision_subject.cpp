// SPDX-License-Identifier: GPL-3.0-or-later
// All of a collision in one pass, as mdana collision has it.
#include "reports/accuracy/dump_subject.hpp"

namespace mdana {
namespace {

RunWishes wishes_of(const DumpQuestion& q) {
  PlanWishes asked;
  asked.potential = q.potential;
  asked.layer = q.contact.layer;
  RunWishes wishes;
  wishes.plan = plan_command(q.run, "collision", asked);
  wishes.radii = find_radii(q.run, q.options);
  wishes.contact = q.contact;
  wishes.potential = q.potential;
  return wishes;
}

std::vector<JudgedNumber> collision_numbers(const DumpQuestion& q, const Measuring& m) {
  const AnalysedRun run = analyse_run(q.run, wishes_of(q), m.sweeping);
  std::vector<JudgedNumber> numbers = judged_force(run.measured.motion, run.curve, run.restitution, q.run.units);
  if (run.touch())
    for (JudgedNumber& number : judged_contact(run.contact)) {
      number.name.insert(0, "contact_radius.");
      numbers.push_back(std::move(number));
    }
  if (run.energy && run.energy->budget)
    for (JudgedNumber& number : judged_energy(*run.energy->budget)) numbers.push_back(std::move(number));
  return numbers;
}

}  // namespace

AccuracySubject collision_subject(const DumpQuestion& question) {
  return dump_subject("collision", question, sweep_knobs(), collision_numbers);
}

}  // namespace mdana
