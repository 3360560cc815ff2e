// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "reports/accuracy_subjects.hpp"

namespace mdana {

/// What the knobs of dumps set.
struct Measuring {
  SweepOptions sweeping;
  std::optional<ForceSource> source = {};  ///< default: the best
  ForceDerivative derivative = {};
  ContactOptions contact = {};
  std::string definition = "gyration";  ///< of the contact radius
  HertzSettings hertz = {};
  Split split = Split::sign;
  NetworkOptions network = {};
  const ForceLaw* law = nullptr;
  ForceFitSettings force_fit = {};
  DefectSettings defects = {};
  std::size_t gamma_radius = 0;         ///< of the radii that gamma is given with
};

/// A knob, and what its value sets.
struct DumpKnob {
  Knob knob;
  std::function<void(Measuring& measuring, std::size_t value)> set;
};

using DumpMeasure = std::function<std::vector<JudgedNumber>(const DumpQuestion& question, const Measuring& measuring)>;

AccuracySubject dump_subject(std::string name, const DumpQuestion& question, std::vector<DumpKnob> knobs, DumpMeasure measure);

/// Knobs that all analyses of dumps have: stride, digits, threads, memory.
std::vector<DumpKnob> sweep_knobs();

DumpKnob stride_knob();
/// Knobs of the force: source (what the dump has, the best first), window and degree of derivatives.
std::vector<DumpKnob> derivative_knobs(const Run& run);

/// Motion and force curve of one pass.
struct MeasuredForce {
  ForceSource source;
  MeasuredMotion measured;
  Radii radii;
  ForceCurve curve;
};
MeasuredForce measure_force(const DumpQuestion& question, const Measuring& measuring);

/// The numbers that are published, with the scales of their errors. Definition after definition.
std::vector<JudgedNumber> judged_force(const RelativeMotion& motion, const ForceCurve& curve, const Restitution& restitution,
                                       Units units);
std::vector<JudgedNumber> judged_energy(const EnergyBudget& budget);
std::vector<JudgedNumber> judged_contact(const ContactNumbers& contact);

/// A number of every stride-th frame from `first` on, of all frames; its error is the greatest difference to the same of
/// every second one. Not known of less than two frames.
template <class Number>
Value by_frames(std::size_t frames, Dimension dimension, Number&& number) {
  Value value{number(std::size_t{0}, std::size_t{1}), {}, dimension};
  if (frames >= 2)
    value.error = std::max(std::abs(number(std::size_t{0}, std::size_t{2}) - value.value),
                           std::abs(number(std::size_t{1}, std::size_t{2}) - value.value));
  return value;
}

/// Several lists as one.
std::vector<DumpKnob> together(std::vector<DumpKnob> first, std::vector<DumpKnob> more);

/// A knob without a finest value, of names or numbers.
template <class Elements, class Text, class Set>
DumpKnob choice_knob(std::string name, std::string meaning, const Elements& elements, Text&& text, Set&& set) {
  Knob knob{std::move(name), std::move(meaning), Reference::standard, 0, {}};
  for (std::size_t k = 0; k < elements.size(); ++k) knob.values.push_back({std::string(text(k))});
  return {std::move(knob), set};
}

}  // namespace mdana
