// SPDX-License-Identifier: GPL-3.0-or-later
// Surface energy of a relaxed particle, with its knobs.
#include <array>

#include "reports/accuracy/dump_subject.hpp"
#include "reports/particle.hpp"

namespace mdana {
namespace {

constexpr std::size_t body = 1;

std::vector<JudgedNumber> gamma_of(const DumpQuestion& q, const Measuring& m) {
  const LennardJones potential = lennard_jones(q.run, {});
  const Particle particle = measure_particle(q.run, body, energy_column(q.run, q.potential.column), m.sweeping);
  const ColdEnergy cold = cold_energy(*particle.potential, particle, potential.epsilon);
  const auto by = gamma_by_radius(relaxed_fcc(potential), particle, cold, cut_radius(q.run, q.options, body));
  std::vector<JudgedNumber> numbers{{"gamma", by.at(m.gamma_radius).gamma}};
  for (const GammaByRadius& g : by) numbers.push_back({"gamma." + g.radius_name, g.gamma});
  return numbers;
}

}  // namespace

AccuracySubject surface_energy_subject(const DumpQuestion& question) {
  lennard_jones(question.run, {});
  energy_column(question.run, question.potential.column);
  std::vector<std::string> radii{"cut", "volume", "gyration"};
  if (!cut_radius(question.run, question.options, body)) radii.erase(radii.begin());
  const auto radius = choice_knob("radius", "of the particle", radii, [radii](std::size_t k) { return radii[k]; },
                                  [](Measuring& m, std::size_t k) { m.gamma_radius = k; });
  std::vector<DumpKnob> knobs = together(sweep_knobs(), {radius});
  std::erase_if(knobs, [](const DumpKnob& k) { return k.knob.name == "stride"; });
  AccuracySubject subject = dump_subject("surface-energy", question, std::move(knobs), gamma_of);
  subject.fixed.push_back({"frames", "one", "all of its atoms are read: nothing is left that --error could choose"});
  subject.fixed.push_back({"moved-digits", "8 passes", "they give the error, known to 25 %, not the number"});
  return subject;
}

}  // namespace mdana
