// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of the grains of two aggregates, with their knobs.
#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "reports/accuracy/dump_subject.hpp"

namespace mdana {
namespace {

constexpr std::array<double, 3> strong_shares{default_strong_share, 0.05, 0.2};
constexpr std::array<double, 3> fillings{1, 0.95, 1.05};  ///< of the default threshold

/// Of the frame of the greatest delta.
Value at_greatest_delta(const Table& table, std::string_view column, Dimension dimension) {
  const auto delta = table.column("delta"), values = table.column(column);
  return by_frames(delta.size(), dimension, [&](std::size_t first, std::size_t stride) {
    std::size_t most = first;
    for (std::size_t k = first; k < delta.size(); k += stride)
      if (delta[k] > delta[most]) most = k;
    return values[most];
  });
}

Value first_coordination(const Table& table, const std::string& column) {
  return {table.column(column)[0], table.column(column + "_error")[0], dimension::none};
}

/// Errors of numbers of contacts are parts of all contacts, of volumes those of the bodies.
std::vector<JudgedNumber> network_numbers(const DumpQuestion& q, const Measuring& m) {
  const Radii radii = find_radii(q.run, q.options);
  const NetworkSetup setup = network_setup(q.run, radii, m.network);
  const Table table = measure_network(q.run, radii, setup, m.sweeping).table;
  const Value contacts = at_greatest_delta(table, "contacts", dimension::none);
  std::vector<JudgedNumber> numbers{{"coordination", first_coordination(table, "coordination")}, {"contacts", contacts}};
  if (table.column("core_grains")[0] > 1) numbers.push_back({"coordination_core", first_coordination(table, "coordination_core")});
  for (const char* column : {"contacts12", "made", "broken", "tension", "compression", "strong_tension", "strong_compression"})
    if (table.has(column)) numbers.push_back({column, at_greatest_delta(table, column, dimension::none), contacts.value});
  const auto ball = [](double r) { return 4 * std::numbers::pi / 3 * r * r * r; };
  numbers.push_back({"compacted_volume", at_greatest_delta(table, "compacted_volume", {0, 3, 0}),
                     ball(radii.value[0]) + ball(radii.value[1])});
  return numbers;
}

/// Thresholds of what counts as strong and as compacted.
std::vector<DumpKnob> network_knobs(const DumpQuestion& q) {
  const NetworkSetup setup = network_setup(q.run, find_radii(q.run, q.options), q.network);
  const double filling = *setup.settings.compacted;
  std::vector<DumpKnob> knobs{
      choice_knob("compacted", "local filling factor above which a grain is compacted", fillings,
                  [filling](std::size_t k) { return fmt::format("{:.4g}", fillings[k] * filling); },
                  [filling](Measuring& m, std::size_t k) { m.network.compacted = fillings[k] * filling; })};
  if (setup.contact)
    knobs.push_back(choice_knob("strong", "forces above this share of the pull-off force are strong", strong_shares,
                                [](std::size_t k) { return fmt::format("{:g}", strong_shares[k]); },
                                [](Measuring& m, std::size_t k) { m.network.strong_share = strong_shares[k]; }));
  return knobs;
}

}  // namespace

AccuracySubject network_subject(const DumpQuestion& question) {
  AccuracySubject subject = dump_subject("network", question, together(sweep_knobs(), network_knobs(question)), network_numbers);
  subject.fixed.push_back({"contact-criterion", "overlap >= 0", "between -0.825 delta0 and 0 a frame does not tell: undecided counts them"});
  return subject;
}

}  // namespace mdana
