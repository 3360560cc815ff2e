// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/accuracy/dump_subject.hpp"

#include <array>

#include <fmt/format.h>

#include "analyses/force_series.hpp"
#include "readers/block.hpp"

namespace mdana {
namespace {

constexpr std::array<std::uint64_t, 5> strides{1, 2, 4, 8, 16};
constexpr std::array<int, 3> degrees{4, 2, 6};
constexpr std::array<int, 6> dropped{0, 1, 2, 3, 4, 5};
constexpr std::array<std::size_t, 3> threads{1, 2, 4};
constexpr std::array<std::size_t, 3> memories{std::size_t{128} << 20, std::size_t{1} << 20, std::size_t{1} << 10};

/// A value for each element.
template <class Elements, class Value>
std::vector<KnobValue> values_of(const Elements& elements, Value&& value) {
  std::vector<KnobValue> values;
  for (const auto& element : elements) values.push_back(value(element));
  return values;
}

DumpKnob digits_knob() {
  const auto text = [](int d) {
    return KnobValue{d == 0 ? "as printed" : fmt::format("{} fewer", d), std::pow(10.0, d)};
  };
  return {{"digits", "round the numbers of the dump to fewer decimal digits than it prints", Reference::finest, 1,
           values_of(dropped, text)},
          [](Measuring& m, std::size_t k) { m.sweeping.dropped_digits = dropped[k]; }};
}

DumpKnob threads_knob() {
  const auto text = [](std::size_t n) { return KnobValue{fmt::format("{}", n), static_cast<double>(n)}; };
  return {{"threads", "threads for the blocks of frames", Reference::bits, 0, values_of(threads, text)},
          [](Measuring& m, std::size_t k) { m.sweeping.threads = threads[k]; }};
}

DumpKnob memory_knob() {
  const auto text = [](std::size_t n) { return KnobValue{n >> 20 ? fmt::format("{}M", n >> 20) : fmt::format("{}K", n >> 10), static_cast<double>(n)}; };
  return {{"memory", "memory for atoms that are looked at twice", Reference::bits, 0, values_of(memories, text)},
          [](Measuring& m, std::size_t k) { m.sweeping.memory = memories[k]; }};
}

std::vector<ForceSource> sources_of(const Run& run) {
  const auto has = [&](const char* column) { return run.first.has_column(column); };
  std::vector<ForceSource> sources;
  if (has("fx") && has("fy") && has("fz")) sources.push_back(ForceSource::forces);
  if (!run.first.time && !run.timestep) return sources;
  if (has("vx") && has("vy") && has("vz")) sources.push_back(ForceSource::velocities);
  sources.push_back(ForceSource::positions);
  return sources;
}

DumpKnob source_knob(const Run& run) {
  const std::vector<ForceSource> sources = sources_of(run);
  const auto text = [](ForceSource s) { return KnobValue{std::string(name(s))}; };
  return {{"source", "where the force comes from", Reference::standard, 0, values_of(sources, text)},
          [sources](Measuring& m, std::size_t k) { m.source = sources.at(k); }};
}

DumpKnob window_knob() {
  std::vector<KnobValue> values{{"by the noise"}};
  for (const int window : derivative_windows) values.push_back({fmt::format("{} frames", window), static_cast<double>(window)});
  return {{"window", "frames that a derivative is made from", Reference::standard, 0, values},
          [](Measuring& m, std::size_t k) { m.derivative.window = k == 0 ? 0 : derivative_windows[k - 1]; }};
}

DumpKnob degree_knob() {
  const auto text = [](int degree) { return KnobValue{fmt::format("degree {}", degree), static_cast<double>(degree)}; };
  return {{"degree", "of the polynomials that are differentiated", Reference::standard, 0, values_of(degrees, text)},
          [](Measuring& m, std::size_t k) { m.derivative.degree = degrees[k]; }};
}

}  // namespace

DumpKnob stride_knob() {
  const auto text = [](std::uint64_t n) {
    return KnobValue{n == 1 ? "all frames" : fmt::format("1 of {} frames", n), static_cast<double>(n)};
  };
  return {{"stride", "use every K-th frame only", Reference::finest, 4, values_of(strides, text)},
          [](Measuring& m, std::size_t k) { m.sweeping.choice.stride *= strides[k]; }};
}

std::vector<DumpKnob> derivative_knobs(const Run& run) { return {source_knob(run), window_knob(), degree_knob()}; }

std::vector<DumpKnob> sweep_knobs() { return {stride_knob(), digits_knob(), threads_knob(), memory_knob()}; }

std::vector<DumpKnob> together(std::vector<DumpKnob> first, std::vector<DumpKnob> more) {
  for (DumpKnob& knob : more) first.push_back(std::move(knob));
  return first;
}

MeasuredForce measure_force(const DumpQuestion& q, const Measuring& m) {
  const ForceSource source = m.source ? *m.source : best_force_source(q.run);
  MeasuredForce force{source, measure_motion(q.run, parts_for(source), {}, m.sweeping), find_radii(q.run, q.options), {}};
  force.curve = touching_force_curve(q.run, force.measured.motion, source, force.radii, m.derivative);
  return force;
}

AccuracySubject dump_subject(std::string name, const DumpQuestion& question, std::vector<DumpKnob> knobs, DumpMeasure measure) {
  AccuracySubject subject{std::move(name), {}, {}};
  subject.fixed.push_back({"block-size", fmt::format("{} atoms", AtomBlock::capacity), "sums over blocks have the same bits on any machine"});
  for (const DumpKnob& k : knobs)
    if (!k.knob.values.empty()) subject.knobs.push_back(k.knob);
  subject.measure = [question, knobs = std::move(knobs), measure = std::move(measure)](const KnobChoice& choice) {
    Measuring measuring{question.sweeping, question.source, {}, question.contact};
    measuring.hertz = question.hertz;
    measuring.split = question.split;
    measuring.network = question.network;
    measuring.law = question.law;
    measuring.force_fit = question.force_fit;
    measuring.defects = question.defects;
    for (const DumpKnob& k : knobs)
      if (const auto at = choice.values.find(k.knob.name); at != choice.values.end()) k.set(measuring, at->second);
    return measure(question, measuring);
  };
  return subject;
}

}  // namespace mdana
