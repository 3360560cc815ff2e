// SPDX-License-Identifier: GPL-3.0-or-later
// Crystal structure and dislocation lines, with their knobs.
#include <algorithm>
#include <array>
#include <cmath>

#include "analyses/defects.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy/dump_subject.hpp"

namespace mdana {
namespace {

#ifdef MDANA_WITH_DEFECTS

constexpr std::array<std::string_view, 2> searches{"cells", "cgal"};
constexpr std::array<std::string_view, 2> zones{"near defects", "everywhere"};

Table defect_table_of(const DumpQuestion& q, const Measuring& m) {
  DefectSettings settings = m.defects;
  settings.ids = q.run.first.has_column("id");
  SweepOptions sweeping = m.sweeping;
  sweeping.selection = q.run.selection;
  std::vector<std::unique_ptr<Analysis>> analyses;
  if (q.run.bodies.count() == 2) analyses.push_back(make_motion({}));
  analyses.push_back(make_defects(std::move(settings)));
  return std::move(sweep(q.run.dump, q.run.bodies, q.run.masses, analyses, sweeping).tables.back());
}

/// The greatest of all frames; its error is that of the frame, too, if it has one.
Value greatest(const Table& table, const std::string& column, Dimension dimension) {
  const auto values = table.column(column);
  const auto most = [&](std::size_t first, std::size_t stride) {
    std::size_t best = first;
    for (std::size_t k = first; k < values.size(); k += stride)
      if (values[k] > values[best]) best = k;
    return best;
  };
  Value value = by_frames(values.size(), dimension, [&](std::size_t first, std::size_t stride) { return values[most(first, stride)]; });
  if (value.error && table.has(column + "_error")) value.error = std::hypot(*value.error, table.column(column + "_error")[most(0, 1)]);
  return value;
}

double atoms_of(const Table& table) {
  double atoms = 0;
  for (const char* structure : {"fcc", "hcp", "bcc", "ico", "other"}) atoms += table.column(structure)[0];
  return atoms;
}

/// Errors are parts of the atoms, of areas and lengths at least of a section and a diameter of all atoms as one cube.
std::vector<JudgedNumber> defect_numbers(const DumpQuestion& q, const Measuring& m) {
  const Table table = defect_table_of(q, m);
  const double atoms = atoms_of(table), diameter = std::cbrt(atoms) * table.column("spacing")[0];
  std::vector<JudgedNumber> numbers;
  const auto add = [&](const char* column, Dimension dimension, double scale) {
    if (!table.has(column)) return;
    const Value value = greatest(table, column, dimension);
    numbers.push_back({column, value, std::max(scale, value.value)});
  };
  for (const char* structure : {"fcc", "hcp", "bulk_defect"}) add(structure, dimension::none, atoms);
  add("fault_area", dimension::area, diameter * diameter);
  add("line_length", dimension::length, diameter);
  return numbers;
}

std::vector<DumpKnob> defect_knobs() {
  return {{choice_knob("neighbours", "how they are looked for", searches, [](std::size_t k) { return searches[k]; },
                       [](Measuring& m, std::size_t k) { m.defects.by_cgal = k == 1; })},
          {choice_knob("zone", "where lines are looked for", zones, [](std::size_t k) { return zones[k]; },
                       [](Measuring& m, std::size_t k) { m.defects.lines_everywhere = k == 1; })}};
}

#else

std::vector<JudgedNumber> defect_numbers(const DumpQuestion&, const Measuring&) {
  throw InputError("this build has no analysis of defects");
}

std::vector<DumpKnob> defect_knobs() { return {}; }

#endif

}  // namespace

AccuracySubject defects_subject(const DumpQuestion& question) {
  std::vector<DumpKnob> knobs = defect_knobs();
  for (DumpKnob& knob : knobs) knob.knob.reference = Reference::bits;
  AccuracySubject subject = dump_subject("defects", question, together(sweep_knobs(), std::move(knobs)), defect_numbers);
  subject.fixed.push_back({"neighbour-criterion", "local cutoff", "of each atom from its own neighbours: nothing to choose"});
  subject.fixed.push_back({"zone-shell", "1.94 spacings", "as far as a tetrahedron that is filled reaches: tested by the knob zone"});
  return subject;
}

}  // namespace mdana
