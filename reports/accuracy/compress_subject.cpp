// SPDX-License-Identifier: GPL-3.0-or-later
// Compression of aggregates, apart from the others: a build without its analyses links those alone.
#include "reports/accuracy/dump_subject.hpp"

namespace mdana {
namespace {

std::vector<JudgedNumber> compression_numbers(const DumpQuestion& q, const Measuring& m) {
  const CompressedRun run = measure_compression(q.run, q.options, m.sweeping);
  const Compressing c = compressing(run, q.offset);
  const MaximumCompression& most = c.by[static_cast<std::size_t>(m.split)];
  return {{"delta_max", most.delta}, {"t_max", most.time}};
}

}  // namespace

AccuracySubject compress_subject(const DumpQuestion& question) {
  const auto split = choice_knob("split", "what an atom counts for: its side or its body", split_names,
                                 [](std::size_t k) { return split_names[k]; },
                                 [](Measuring& m, std::size_t k) { m.split = static_cast<Split>(k); });
  return dump_subject("compress", question, together(sweep_knobs(), {split}), compression_numbers);
}

}  // namespace mdana
