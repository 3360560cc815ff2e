// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/accuracy_subjects.hpp"

namespace mdana {

/// What the knobs of dumps set.
struct Measuring {
  SweepOptions sweeping;
  ForceSource source = ForceSource::velocities;
  int window = 0;                      ///< 0: chosen by the noise
  ContactOptions contact = {};
  std::string definition = "gyration";  ///< of the contact radius
  HertzSettings hertz = {};
  Split split = Split::sign;
  bool by_cgal = false, everywhere = false;  ///< how defects and their lines are looked for
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
DumpKnob source_knob(const Run& run);  ///< what the dump has, the best first
DumpKnob window_knob();

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
