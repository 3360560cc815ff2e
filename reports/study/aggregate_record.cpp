// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/aggregate_record.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "fits/andrews_limits.hpp"
#include "readers/input_error.hpp"
#include "reports/compression_study.hpp"
#include "reports/network.hpp"
#include "reports/study/run_checks.hpp"
#include "reports/study/chosen_frames.hpp"

namespace mdana {
namespace {

Figure over_time(const std::string& run, Units units, const Table& table, const char* column, const std::string& what,
                 Dimension dimension) {
  const auto times = table.column("time"), values = table.column(column);
  Figure figure;
  figure.name = column;
  figure.title = run + ": " + what;
  figure.x_label = fmt::format("time [{}]", symbol(units, dimension::time));
  figure.y_label = fmt::format("{} [{}]", what, symbol(units, dimension));
  figure.x_name = "time";
  figure.y_name = column;
  figure.alt = fmt::format("{} against time, {:.4g} at most.", what, *std::ranges::max_element(values));
  figure.series = {{"by the sign of x", {times.begin(), times.end()}, {values.begin(), values.end()}, Series::Style::line, {}}};
  return figure;
}

/// The table of mdana compress, and X of both splits to the last bit.
Table approach_table(const CompressedRun& measured) {
  Table table = compression_table(measured, study_split);
  for (const Split split : {Split::sign, Split::membership}) {
    const auto k = static_cast<std::size_t>(split);
    table.add_column({fmt::format("X_{}", split_names[k]), dimension::length}, measured.series[k].distance);
  }
  return table;
}

/// Pairs E*, Y that delta_max allows; none if it is not known.
Table pair_table(const Impact& impact, const Value& delta_max) {
  constexpr std::size_t count = 60;
  Table table({{"E_star", dimension::pressure}, {"Y", dimension::pressure}});
  if (!(delta_max.value > 0) || !(impact.velocity > 0)) return table;
  for (const DegeneratePair& pair : degenerate_pairs(impact, delta_max.value, count))
    table.add_row(std::array{pair.modulus, pair.yield_strength});
  return table;
}

/// JKR's force of two grains, stable branch to twice the equilibrium; no rows without the grains' constants.
Table grain_table(const Run& run, const Radii& radii) {
  constexpr int count = 200;
  Table table({{"delta", dimension::length}, {"F", dimension::force}});
  const ForceLaw* law = find_force_law("jkr");
  try {
    const auto contact = network_setup(run, radii, {}).contact;
    if (!law || !contact) return table;
    const double least = law->least_delta(*contact);
    for (int i = 0; i <= count; ++i) {
      const double delta = least * (1 - 4.0 * i / count);
      table.add_row(std::array{delta, law->force(delta, *contact)});
    }
  } catch (const InputError&) {  // the coordination, which needs the same, is left out with the reason
  }
  return table;
}

/// Numbers by their names; NaN is unknown.
std::vector<PublishedValue> parts_of(const CompressedRun& m) {
  const auto number = [](double value, Dimension d = {}) { return Value{value, {}, d}; };
  return {{"radius1", number(m.radii.value[0])},
          {"radius2", number(m.radii.value[1])},
          {"radius_error", number(m.radii.sum_error)},
          {"mass1", number(m.mass[0])},
          {"mass2", number(m.mass[1])},
          {"distance_noise_sign", number(m.series[0].distance_noise)},
          {"speed_noise_sign", number(m.series[0].speed_noise)},
          {"distance_noise_membership", number(m.series[1].distance_noise)},
          {"speed_noise_membership", number(m.series[1].speed_noise)},
          {"filling_factor", number(m.filling_factor.value_or(std::numeric_limits<double>::quiet_NaN()))},
          {"speed_before", m.restitution.speed_before},
          {"e", m.restitution.e},
          {"outcome", number(static_cast<double>(m.curve.outcome))}};
}

Value part(const RunRecord& record, const std::string& name) {
  const auto at = std::ranges::find(record.parts, name, &PublishedValue::name);
  if (at == record.parts.end()) throw InputError(fmt::format("a result without '{}': run it anew", name));
  return at->value;
}

std::vector<double> column(const Table& table, const std::string& name) {
  if (!table.has(name)) return {};
  const auto values = table.column(name);
  return {values.begin(), values.end()};
}

/// Error against run time over the stride, and digits that the printed ones fix.
void check(RunRecord& record, const Plan& plan, const Run& run, const SweepOptions& sweeping) {
  std::vector<AccuracyRow> accuracy;
  std::vector<StabilityRow> stability;
  if (plan.has(Part::accuracy)) {
    DumpQuestion question{run, {}, sweeping};
    question.split = study_split;
    const AccuracySubject subject = compress_subject(question);
    accuracy = accuracy_rows(subject, std::array{subject.knob("stride")});
  }
  const auto again = [&](const SweepOptions& moved) {
    Document document("report", run);
    add_compression(document, measure_compression(run, {}, moved), study_split, {});
    return document.numbers();
  };
  if (plan.has(Part::stability)) stability = stability_rows(record.numbers, again, sweeping);
  add_checks(record, accuracy, stability);
}

}  // namespace

RunRecord aggregate_record(const RunTask& task, const Run& run, const SweepOptions& sweeping) {
  Plan plan = plan_run(run, plan_wishes(task));
  const CompressedRun measured = measure_compression(run, {}, sweeping);
  const Compressing c = compressing(measured, {});
  const Value& delta_max = c.by[static_cast<std::size_t>(study_split)].delta;
  Document document("report", run);
  document.sweep(measured.measured.swept, run.format);
  settle(plan, measured);
  add_plan(document, plan);
  add_compression(document, measured, study_split, {});
  add_degeneracy(document, c.impact, delta_max);
  RunRecord record;
  record.document = document.content();
  record.numbers = document.numbers();
  check(record, plan, run, sweeping);
  record.parts = parts_of(measured);
  record.tables = {{"approach", approach_table(measured)}, {"pairs", pair_table(c.impact, delta_max)},
                   {"grain_law", grain_table(run, measured.radii)}};
  const Table& table = record.tables[0].table;
  record.figures.push_back(over_time(task.name, run.units, table, "delta", "mutual approach δ", dimension::length));
  if (table.has("v_rel"))
    record.figures.push_back(over_time(task.name, run.units, table, "v_rel", "relative velocity", dimension::velocity));
  add_chosen_frames(record, task, run, table, measured.radii, nullptr, sweeping);
  return record;
}

CompressedRun compressed_of(const std::string& name, const RunRecord& record) {
  CompressedRun run;
  run.dump = name;
  run.units = parse_units(record.document.at("units").get<std::string>()).value();
  run.interaction = Interaction::aggregate;
  const double filling = part(record, "filling_factor").value;
  if (filling == filling) run.filling_factor = filling;
  run.radii = {{part(record, "radius1").value, part(record, "radius2").value}, "", part(record, "radius_error").value};
  run.mass = {part(record, "mass1").value, part(record, "mass2").value};
  run.restitution.speed_before = part(record, "speed_before");
  run.restitution.e = part(record, "e");
  run.curve.outcome = static_cast<Outcome>(static_cast<int>(part(record, "outcome").value));
  const Table& table = *record.table("approach");
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string split(split_names[k]);
    run.series[k] = {column(table, "time"), column(table, "X_" + split), column(table, "v_rel_" + split),
                     part(record, "distance_noise_" + split).value, part(record, "speed_noise_" + split).value};
  }
  return run;
}

}  // namespace mdana
