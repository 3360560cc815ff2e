// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_page.hpp"

#include <map>

#include <fmt/format.h>

#include "page_style.hpp"
#include "reports/html.hpp"
#include "reports/live_figure.hpp"
#include "reports/page_script.hpp"
#include "reports/study_figures.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

using html::element;
using html::escape;
using html::heading;
using html::paragraph;

std::string sentence(const StudyRun& entry) {
  const ForceCurve& curve = entry.result->curve;
  const Units units = entry.run->units;
  const std::string how = curve.outcome == Outcome::bounce ? "The bodies met and separated."
                          : curve.outcome == Outcome::stick
                              ? "The bodies met and stuck."
                              : "The dump ends before it is clear whether the bodies stick.";
  return fmt::format("{} Greatest force {}, greatest mutual approach {}, loop area of the first "
                     "cycle {}. Errors come from halving the number of frames{}.",
                     how, to_text(curve.force_max, units), to_text(curve.delta_max, units),
                     to_text(curve.hysteresis_area, units),
                     entry.result->radii.sum_error > 0 ? ", that of the approach from the radius besides"
                                                       : "");
}

std::string summary_table(const Study& study) {
  std::vector<std::vector<std::string>> rows;
  for (const StudyRun& entry : study.runs) {
    if (!entry.result) {
      rows.push_back({entry.name, "failed: " + entry.failure});
      continue;
    }
    const AnalysedRun& r = *entry.result;
    const Units units = entry.run->units;
    rows.push_back({entry.name, std::string(name(entry.run->scene.interaction)),
                    std::string(name(r.curve.outcome)), to_text(r.curve.force_max, units),
                    to_text(r.curve.delta_max, units), to_text(r.curve.hysteresis_area, units),
                    to_text(r.contact.gyration().max, units),
                    r.hertz ? to_text(r.hertz->modulus, units) : "left out",
                    r.hertz ? to_text(r.hertz->radius, units) : "left out"});
  }
  return html::table({"run", "interaction", "outcome", "F_max", "delta_max", "loop area",
                      "contact radius, max", "E*", "R"}, rows, 3);
}

std::string overlay_sentence(const StudyRun& entry) {
  if (!entry.overlay) return {};
  return paragraph(fmt::format("Dashed: {}; {}.",
                               entry.overlay->law->name == "jkr" ? "JKR, stable branch" : "Hertz",
                               entry.overlay->source));
}

std::string fit_sentence(const StudyRun& entry) {
  if (!entry.result->hertz) return {};
  const HertzResult& h = *entry.result->hertz;
  const Units units = entry.run->units;
  return paragraph(fmt::format(
      "Hertz fit: E* = {}, R = {}. The errors are the spread over {} choices of method, force range "
      "and phase (E* {:.4g} to {:.4g}, R {:.5g} to {:.5g}); the standard errors of this one fit, "
      "{:.2g} and {:.2g}, say nothing of it. {} points, residual {:.2g} of F_max (rms), optimum to "
      "{:.0f} digits. Another crystal orientation moves E* by 30 to 50 %.{}",
      to_text(h.modulus, units), to_text(h.radius, units), h.spread.variants.size(),
      h.spread.modulus.least, h.spread.modulus.greatest, h.spread.radius.least,
      h.spread.radius.greatest, *h.fit.modulus.error, *h.fit.radius.error, h.fit.points.size(),
      h.fit.rms_residual, h.fit.fit.digits,
      h.fit.fit.usable ? "" : " The fit is not usable: " + h.fit.fit.reason + "."));
}

std::string drawn(std::vector<Figure> figures, const std::filesystem::path& directory, const std::string& run) {
  std::string content;
  for (Figure& figure : figures) {
    for (Series& s : figure.series) s.run = run;
    draw(figure, directory);
    content += live_figure(figure);
  }
  return element("div", content, "class=\"figures\"");
}

std::string inputs_text(const std::vector<InputRecord>& inputs) {
  if (inputs.size() == 1) return fmt::format("{} bytes, {}", inputs[0].size, inputs[0].hash);
  std::uint64_t bytes = 0;
  for (const InputRecord& input : inputs) bytes += input.size;
  return fmt::format("{} files, {} bytes; their hashes are in results.json", inputs.size(), bytes);
}

std::string run_section(const StudyRun& entry, const std::filesystem::path& directory) {
  std::string text = heading(2, entry.name, file_name(entry.name));
  if (!entry.result) return text + element("p", escape(entry.failure), "class=\"warning\"");
  const AnalysedRun& r = *entry.result;
  text += element("p", escape(fmt::format("{} · {} frames, {} + {} atoms · units {} · force from {} · "
                                          "radius from {}", entry.dump.string(),
                                          r.measured.swept.steps.size(),
                                          r.measured.swept.tables[0].column("atoms1")[0],
                                          r.measured.swept.tables[0].column("atoms2")[0],
                                          name(entry.run->units), name(r.source), r.radii.source)),
                  "class=\"quiet\"");
  text += paragraph(sentence(entry));
  for (const std::string& w : entry.warnings)
    text += element("p", escape("Warning: " + w), "class=\"warning\"");
  text += fit_sentence(entry) + overlay_sentence(entry);
  text += drawn(run_figures(entry), directory, entry.name);
  return text + element("p", element("code", escape(inputs_text(r.measured.swept.inputs))),
                        "class=\"quiet\"");
}

std::string aggregate_section(const AggregateRun& entry, const std::filesystem::path& directory) {
  const std::string text = heading(2, entry.name, file_name(entry.name));
  if (!entry.result) return text + element("p", escape(entry.failure), "class=\"warning\"");
  return text + element("pre", escape(aggregate_document(entry).to_terminal()), "tabindex=\"0\"") +
         drawn(aggregate_figures(entry), directory, entry.name);
}

/// What the aggregates say together.
std::string aggregates_section(const Study& study) {
  const std::string head = heading(2, "Aggregates together", "aggregates");
  if (!study.together.failure.empty()) return head + element("p", escape(study.together.failure), "class=\"warning\"");
  if (!study.together.study) return {};
  Document document("compress");
  add_compression_study(document, *study.together.study);
  return head + paragraph("E* and Y of the aggregates by delta_max and t_max, from the laws of elastoplastic spheres.") +
         element("pre", escape(document.to_terminal()), "tabindex=\"0\"");
}

/// A row a number, a column a setting: relative difference from the first setting.
std::string accuracy_table(const StudyRun& entry) {
  std::vector<std::string> head{"number"}, seconds{"seconds"}, order;
  std::map<std::string, std::map<std::string, std::string>> cells;
  for (const AccuracyRow& r : entry.accuracy) {
    if (head.back() != r.setting) {
      head.push_back(r.setting);
      seconds.push_back(fmt::format("{:.3f}", r.seconds));
    }
    if (!cells.count(r.quantity)) order.push_back(r.quantity);
    cells[r.quantity][r.setting] =
        r.error == 0 ? fmt::format("{:.6g}", r.value) : fmt::format("{:.1e}", r.error);
  }
  std::vector<std::vector<std::string>> rows;
  for (const std::string& quantity : order) {
    rows.push_back({quantity});
    for (std::size_t k = 1; k < head.size(); ++k) rows.back().push_back(cells[quantity][head[k]]);
  }
  rows.push_back(seconds);
  return html::table(head, rows);
}

std::string accuracy_section(const Study& study, const std::filesystem::path& directory) {
  std::string text = heading(2, "Error against run time", "accuracy");
  text += paragraph("Every published number with fewer frames and other fit methods, against "
                    "the time of reading and analysis (median of three). The first column is the "
                    "reference, all frames and the default method; the others tell the relative "
                    "difference from it.");
  for (const StudyRun& entry : study.runs) {
    if (!entry.result) continue;
    text += heading(3, entry.name) + drawn({accuracy_figure(entry)}, directory, entry.name) +
            accuracy_table(entry);
  }
  return text;
}

std::string stability_section(const Study& study) {
  std::string text = heading(2, "Numerical stability", "stability");
  text += paragraph(fmt::format("Digits of each published number that survive when every number in "
                                "the dump is moved at random within its last printed digit (the "
                                "worst of {} repetitions). Fewer than {} digits are flagged.",
                                stability_repetitions,
                                static_cast<int>(StabilityRow::least_stable_digits)));
  for (const StudyRun& entry : study.runs) {
    if (!entry.result) continue;
    std::vector<std::vector<std::string>> rows;
    for (const StabilityRow& r : entry.stability)
      rows.push_back({r.quantity, fmt::format("{:.6g}", r.value), fmt::format("{:.1e}", r.change),
                      fmt::format("{:.1f}", r.digits), r.weak() ? "few digits" : "stable"});
    text += heading(3, entry.name) +
            html::table({"number", "value", "greatest change", "digits kept", "verdict"}, rows, 1);
  }
  return text;
}

std::string left_out_section(const Study& study) {
  std::string text = heading(2, "What was left out and why", "left-out");
  text += paragraph("Not read, not computed, because the scene does not need it or the dump does not "
                    "hold it.");
  std::vector<std::vector<std::string>> rows;
  for (const StudyRun& entry : study.runs)
    for (const LeftOut& l : entry.left_out) rows.push_back({entry.name, l.what, l.reason});
  for (const AggregateRun& entry : study.aggregates) {
    rows.push_back({entry.name, std::string(aggregate_left_out), std::string(aggregate_reason)});
    rows.push_back({entry.name, "error against run time, numerical stability", "not measured for aggregates yet"});
  }
  return text + html::table({"run", "left out", "because"}, rows, 3);
}

std::vector<std::string> run_names(const Study& study) {
  std::vector<std::string> names;
  for (const StudyRun& entry : study.runs) names.push_back(entry.name);
  for (const AggregateRun& entry : study.aggregates) names.push_back(entry.name);
  return names;
}

}  // namespace

std::string study_page(const Study& study, const std::filesystem::path& figures) {
  const std::size_t count = study.runs.size() + study.aggregates.size();
  std::string body = heading(1, "Contact mechanics of " + std::to_string(count) + (count == 1 ? " run" : " runs"));
  body += element("p", escape(fmt::format("{} · mdana {}", study.directory.string(), version)),
                  "class=\"quiet\"");
  if (!study.runs.empty()) body += summary_table(study);
  for (const StudyRun& entry : study.runs)
    body += html::section_of(entry.name, run_section(entry, figures));
  for (const AggregateRun& entry : study.aggregates)
    body += html::section_of(entry.name, aggregate_section(entry, figures));
  body += aggregates_section(study);
  body += accuracy_section(study, figures) + stability_section(study) + left_out_section(study);
  return html::page("Contact mechanics", page_style, body + page_data(run_names(study)), page_script);
}

}  // namespace mdana
