// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_aggregates.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/study_figures.hpp"

namespace mdana {
namespace {

constexpr Split split = Split::sign;  ///< as Arakawa et al. 2024 have it

Figure over_time(const AggregateRun& entry, const Table& table, const char* column, const std::string& what,
                 Dimension dimension) {
  const auto times = table.column("time"), values = table.column(column);
  const Units units = entry.run.units;
  Figure figure;
  figure.name = fmt::format("{}-{}", file_name(entry.name), column);
  figure.title = entry.name + ": " + what;
  figure.x_label = fmt::format("time [{}]", symbol(units, dimension::time));
  figure.y_label = fmt::format("{} [{}]", what, symbol(units, dimension));
  figure.alt = fmt::format("{} against time, {:.4g} at most.", what, *std::ranges::max_element(values));
  figure.series = {{"by the sign of x", {times.begin(), times.end()}, {values.begin(), values.end()}, Series::Style::line}};
  return figure;
}

}  // namespace

void analyse_aggregates(std::vector<AggregateRun>& runs, const SweepOptions& options,
                        const std::function<void(const std::string&)>& progress) {
  for (AggregateRun& entry : runs) {
    progress(entry.name + ": compression");
    try {
      entry.result = measure_compression(entry.run, {}, options);
    } catch (const InputError& error) {
      entry.failure = error.what();
    }
  }
}

AggregatesTogether aggregates_together(const std::vector<AggregateRun>& runs) try {
  std::vector<CompressedRun> measured;
  for (const AggregateRun& entry : runs)
    if (entry.result) measured.push_back(*entry.result);
  if (measured.size() < 2) return {};
  return {study_compression(std::move(measured), split, {}), {}};
} catch (const InputError& error) {
  return {std::nullopt, error.what()};
}

Document aggregate_document(const AggregateRun& entry) {
  Document document("report", entry.run);
  document.json("name", entry.name);
  document.sweep(entry.result->measured.swept, entry.run.format);
  add_compression(document, *entry.result, split, {});
  document.left_out(std::string(aggregate_left_out), std::string(aggregate_reason));
  return document;
}

std::vector<Figure> aggregate_figures(const AggregateRun& entry) {
  const Table table = compression_table(*entry.result, split);
  std::vector<Figure> figures{over_time(entry, table, "delta", "mutual approach δ", dimension::length)};
  if (table.has("v_rel")) figures.push_back(over_time(entry, table, "v_rel", "relative velocity", dimension::velocity));
  return figures;
}

}  // namespace mdana
