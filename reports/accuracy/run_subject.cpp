// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/accuracy/dump_subject.hpp"

namespace mdana {
namespace {

std::vector<DumpKnob> run_knobs(bool hertz) {
  std::vector<DumpKnob> knobs{stride_knob()};
  if (hertz)
    knobs.push_back({{"method", "least squares in F (force) or in F^(2/3) (linear)", Reference::standard, 0,
                      {{"method force"}, {"method linear"}}},
                     [](Measuring& m, std::size_t k) { m.hertz.method = k == 0 ? HertzMethod::force : HertzMethod::linear; }});
  return knobs;
}

}  // namespace

AccuracyPasses accuracy_passes(bool hertz) {
  AccuracyPasses sum;
  for (const DumpKnob& knob : run_knobs(hertz))
    for (const KnobValue& value : knob.knob.values) {
      sum.passes += report_repetitions;
      sum.all_frames += report_repetitions / (knob.knob.name == "stride" ? value.number : 1);
    }
  return sum;
}

AccuracySubject run_subject(const Run& run, const AnalysedRun& full, const SweepOptions& sweeping) {
  const RunWishes same = same_numbers(full);
  DumpQuestion question{run, {}, sweeping};
  return dump_subject("report", question, run_knobs(full.hertz.has_value()), [same](const DumpQuestion& q, const Measuring& m) {
    RunWishes wishes = same;
    wishes.hertz_settings = m.hertz;
    std::vector<JudgedNumber> numbers;
    for (const PublishedValue& n : analyse_run(q.run, wishes, m.sweeping).numbers()) numbers.push_back({n.name, n.value});
    return numbers;
  });
}

}  // namespace mdana
