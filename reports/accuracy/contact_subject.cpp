// SPDX-License-Identifier: GPL-3.0-or-later
// Contact radius of a dump, with its knobs.
#include <array>

#include <fmt/format.h>

#include "analyses/contact_patch.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy/dump_subject.hpp"

namespace mdana {
namespace {

constexpr std::array<double, 6> layer_factors{1, 0.5, 0.75, 1.25, 1.5, 2};      ///< of the default thickness
constexpr std::array<double, 5> cutoff_factors{1, 0.8, 0.9, 1.1, 1.2};  ///< of the default cutoff
constexpr std::array<std::string_view, 3> definitions{"gyration", "alpha", "neighbours"};

/// Lengths about a default one.
std::vector<KnobValue> multiples(std::span<const double> factors, double length) {
  std::vector<KnobValue> values;
  for (const double f : factors) values.push_back({fmt::format("{:.4g}", f * length), f * length});
  return values;
}

template <class Names>
std::vector<KnobValue> named(const Names& names) {
  std::vector<KnobValue> values;
  for (const std::string_view n : names) values.push_back({std::string(n)});
  return values;
}

std::vector<JudgedNumber> contact_numbers_of(const DumpQuestion& q, const Measuring& m) {
  const Radii radii = find_radii(q.run, q.options);
  const ContactSetup setup = contact_setup(q.run, m.contact);
  const MeasuredMotion measured = measure_motion(q.run, {}, contact_analyses(radii, setup), m.sweeping);
  const ContactNumbers contact = contact_numbers(measured, radii.sum());
  if (!contact.touch()) throw InputError(q.run.dump.string() + ": the layer never holds atoms of both bodies");
  std::vector<JudgedNumber> numbers = judged_contact(contact);
  for (const ContactRadiusNumbers& n : contact.definitions)
    if (n.definition == m.definition) numbers.insert(numbers.begin(), {"contact_radius", n.at_delta_max});
  return numbers;
}

/// Knobs of what the scene allows to be measured.
std::vector<DumpKnob> contact_knobs(const DumpQuestion& q) {
  const ContactSetup setup = contact_setup(q.run, q.contact);
  const double layer = 2 * setup.half_layer, cutoff = setup.cutoff;
  std::vector<DumpKnob> knobs{
      {{"layer", "thickness of the layer about the contact plane", Reference::standard, 0, multiples(layer_factors, layer)},
       [layer](Measuring& m, std::size_t k) { m.contact.layer = layer_factors[k] * layer; }}};
  if (!(cutoff > 0)) return knobs;  // this build has no contact_patch
  knobs.push_back({{"neighbour-cutoff", "atoms nearer than this are neighbours", Reference::standard, 0,
                    multiples(cutoff_factors, cutoff)},
                   [cutoff](Measuring& m, std::size_t k) { m.contact.cutoff = cutoff_factors[k] * cutoff; }});
  knobs.push_back({{"definition", "of the contact radius", Reference::standard, 0, named(definitions)},
                   [](Measuring& m, std::size_t k) { m.definition = definitions[k]; }});
  return knobs;
}

}  // namespace

std::vector<JudgedNumber> judged_contact(const ContactNumbers& contact) {
  std::vector<JudgedNumber> numbers;
  for (const ContactRadiusNumbers& n : contact.definitions) {
    numbers.push_back({fmt::format("{}.max", n.definition), n.max});
    numbers.push_back({fmt::format("{}.at_delta_max", n.definition), n.at_delta_max});
  }
  return numbers;
}

AccuracySubject contact_radius_subject(const DumpQuestion& question) {
  return dump_subject("contact-radius", question, together(sweep_knobs(), contact_knobs(question)), contact_numbers_of);
}

}  // namespace mdana
