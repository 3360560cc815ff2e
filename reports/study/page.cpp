// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/page.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "page_style.hpp"
#include "reports/html.hpp"
#include "reports/live_figure.hpp"
#include "reports/page_script.hpp"
#include "reports/stability.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

using html::element;
using html::escape;
using html::heading;
using html::paragraph;
using Json = nlohmann::ordered_json;

std::string quiet(const std::string& text) { return element("p", escape(text), "class=\"quiet\""); }
std::string warning(const std::string& text) { return element("p", escape(text), "class=\"warning\""); }

/// A published number as text; "left out" if there is none.
/// With a flag where the dump fixes few of its digits.
std::string number(const ReportedRun& run, const char* name) {
  const Value* value = run.number(name);
  if (!value) return "left out";
  return to_text(*value, run.units()) + (run.weak(name) ? " (weak: fewer than 3 digits are stable)" : "");
}

std::vector<std::string> summary_row(const ReportedRun& run) {
  std::vector<std::string> row{run.name, run.group, run.measured() ? run.text("outcome") : "failed: " + run.failure};
  if (!run.measured()) return row;
  for (const char* name : {"F_max", "delta_max", "hysteresis_area", "e", "contact_radius.gyration.max", "E_star", "R"})
    row.push_back(number(run, name));
  return row;
}

std::string summary_table(const PageContent& content) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& section : content.sections) rows.push_back(summary_row(*section.run));
  return html::table({"run", "group", "outcome", "F_max", "delta_max", "loop area", "e", "contact radius, max", "E*", "R"},
                     rows, 3);
}

std::string sentence(const ReportedRun& run) {
  const std::string outcome = run.text("outcome");
  const std::string how = outcome == "bounce"  ? "The bodies met and separated."
                          : outcome == "stick" ? "The bodies met and stuck."
                                               : "The dump ends before it is clear whether the bodies stick.";
  return fmt::format("{} Greatest force {}, greatest mutual approach {}, loop area of the first cycle {}. Errors come "
                     "from halving the number of frames{}.",
                     how, number(run, "F_max"), number(run, "delta_max"), number(run, "hysteresis_area"),
                     run.text("radius_source").starts_with("Hertz fit") ? ", that of the approach from the radius besides" : "");
}

std::string overlay_sentence(const ReportedRun& run) {
  const auto overlay = run.document.find("overlay");
  if (overlay == run.document.end()) return {};
  return paragraph(fmt::format("Dashed: {}; {}.", overlay->value("law", "") == "jkr" ? "JKR, stable branch" : "Hertz",
                               overlay->value("source", "")));
}

std::string fit_sentence(const ReportedRun& run) {
  if (!run.number("E_star")) return {};
  const Json &modulus = run.document["E_star"], &radius = run.document["R"];
  const auto spread = [](const Json& json, const char* end) { return json["spread"].value(end, 0.0); };
  return paragraph(fmt::format(
      "Hertz fit: E* = {}, R = {}. The errors are the spread over choices of method, force range and phase (E* {:.4g} to "
      "{:.4g}, R {:.5g} to {:.5g}); the standard errors of this one fit, {:.2g} and {:.2g}, say nothing of it. {} points, "
      "residual {:.2g} of F_max (rms), optimum to {:.0f} digits. Another crystal orientation moves E* by 30 to 50 %.{}",
      number(run, "E_star"), number(run, "R"), spread(modulus, "min"), spread(modulus, "max"), spread(radius, "min"),
      spread(radius, "max"), modulus.value("standard_error", 0.0), radius.value("standard_error", 0.0),
      run.document.value("points", 0), run.document.value("rms_residual", 0.0), run.document.value("digits", 0.0),
      run.document.value("usable", false) ? "" : " The fit is not usable: " + run.text("reason") + "."));
}

std::string drawn(const std::vector<PageFigure>& figures, bool accuracy) {
  std::string content;
  for (const PageFigure& figure : figures)
    if ((figure.name == "accuracy") == accuracy) content += figure.html;
  return element("div", content, "class=\"figures\"");
}

std::string inputs_text(const Json& inputs) {
  if (inputs.size() == 1)
    return fmt::format("{} bytes, {}", inputs[0].value("size", 0), inputs[0].value("hash", ""));
  std::uint64_t bytes = 0;
  for (const Json& input : inputs) bytes += input.value("size", std::uint64_t{0});
  return fmt::format("{} files, {} bytes; their hashes are in results.json", inputs.size(), bytes);
}

/// All published numbers of a run.
std::string numbers_table(const ReportedRun& run) {
  std::vector<std::vector<std::string>> rows;
  for (const PublishedValue& n : run.numbers) rows.push_back({n.name, number(run, n.name.c_str())});
  return html::table({"number", "value"}, rows);
}

std::string run_section(const PageContent::Section& section) {
  const ReportedRun& run = *section.run;
  const std::string text = heading(2, run.name, run.file);
  if (run.left_out) return text + quiet(run.failure);
  if (!run.measured()) return text + warning(run.failure);
  std::string body = quiet(fmt::format("{} · {} frames · units {} · radius from {}", run.document["inputs"][0].value("path", ""),
                                       run.document.value("frames", 0), run.text("units"), run.text("radius_source")));
  if (!run.aggregate()) body += paragraph(sentence(run));
  for (const Json& w : run.document["warnings"]) body += warning("Warning: " + w.get<std::string>());
  body += fit_sentence(run) + overlay_sentence(run) + drawn(section.figures, false) + section.structure;
  if (run.aggregate()) body += numbers_table(run);
  return text + body + element("p", element("code", escape(inputs_text(run.document["inputs"]))), "class=\"quiet\"");
}

std::string pooled_section(const PageContent& content) {
  if (content.pooled.empty()) return {};
  return heading(2, "Runs together", "together") + drawn(content.pooled, false);
}

/// E* against R: a row a size.
std::string sizes_table(const Json& sizes) {
  std::vector<std::vector<std::string>> rows;
  const auto text = [](const Json& pooled) {
    return fmt::format("{:.5g} ± {:.2g}", pooled.value("value", 0.0), pooled.value("error", 0.0));
  };
  for (const Json& size : sizes["sizes"])
    rows.push_back({fmt::format("{:.6g}", size.value("N", 0.0)), fmt::format("{}", size.value("runs", 0)), text(size["R"]),
                    text(size["E_star"])});
  return html::table({"N", "runs", "R", "E*"}, rows, 0);
}

/// A fitted law: its parameters, or why there are none.
std::vector<std::string> law_row(const Json& fit) {
  std::string parameters;
  for (const auto& [name, p] : fit["parameters"].items())
    parameters += fmt::format("{}{} = {:.5g}", parameters.empty() ? "" : ", ", name,
                              p["value"].is_number() ? p["value"].get<double>() : 0.0) +
                  (p["error"].is_number() ? fmt::format(" ± {:.2g}", p["error"].get<double>()) : "");
  const bool usable = fit.value("usable", false);
  return {fit.value("group", ""), fit.value("law", ""), usable ? parameters : "not usable: " + fit.value("reason", "")};
}

std::string aggregate_text(const Json& fit) {
  const std::string of = fit.contains("phi") ? fmt::format("Filling factor {:g}: ", fit["phi"].get<double>()) : "";
  std::string values;
  for (const char* name : {"E_star", "Y"})
    if (fit.value("usable", false) && fit.contains(name) && fit[name]["value"].is_number())
      values += fmt::format("{}{} = {:.5g}", values.empty() ? "" : ", ", name, fit[name]["value"].get<double>());
  if (!values.empty()) return paragraph(of + values + ".");
  std::string reason;
  if (fit.contains("left_out"))
    for (const Json& l : fit["left_out"])
      if (l.value("what", "") == "E_star, Y") reason = l.value("reason", "");
  return paragraph(of + "E* and Y are not determined: " + reason);
}

std::string fits_section(const StudyFits& fits) {
  std::string text;
  if (!fits.sizes.is_null()) text += heading(3, "E* against R") + sizes_table(fits.sizes);
  if (!fits.laws.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const Json& fit : fits.laws) rows.push_back(law_row(fit));
    text += heading(3, "Laws of collisions") + html::table({"group", "law", "parameters"}, rows, 3);
  }
  if (!fits.aggregates.empty()) {
    text += heading(3, "Aggregates together", "aggregates") +
            paragraph("E* and Y of the aggregates by delta_max and t_max, from the laws of elastoplastic spheres.");
    for (const Json& fit : fits.aggregates) text += aggregate_text(fit);
  }
  return text.empty() ? text : heading(2, "Fits", "fits") + text;
}

/// A row a number, a column a setting: errors as parts of the number.
std::string accuracy_table(const Json& accuracy) {
  std::vector<std::string> head{"number"}, seconds{"seconds"}, order;
  std::map<std::string, std::map<std::string, std::string>> cells;
  for (const Json& r : accuracy) {
    const std::string setting = r["setting"], quantity = r["quantity"];
    if (std::ranges::find(head, setting) == head.end()) {
      head.push_back(setting);
      seconds.push_back(fmt::format("{:.3f}", r.value("seconds", 0.0)));
    }
    if (!cells.count(quantity)) order.push_back(quantity);
    const bool known = r["value"].is_number() && r["relative_error"].is_number();
    const std::string error = known ? fmt::format("{:.1e}", r["relative_error"].get<double>()) : "";
    cells[quantity][setting] = !known               ? "not determined"
                               : setting == head[1] ? fmt::format("{:.6g} (error {})", r["value"].get<double>(), error)
                                                    : error;
  }
  std::vector<std::vector<std::string>> rows;
  for (const std::string& quantity : order) {
    rows.push_back({quantity});
    for (std::size_t k = 1; k < head.size(); ++k) rows.back().push_back(cells[quantity][head[k]]);
  }
  rows.push_back(seconds);
  return html::table(head, rows);
}

bool has_rows(const ReportedRun& run, const char* name) {
  return run.measured() && run.document.contains(name) && !run.document[name].empty();
}

std::string accuracy_section(const PageContent& content) {
  std::string text = heading(2, "Error against run time", "accuracy");
  text += paragraph("Every published number with fewer frames and other fit methods, against the time of reading and "
                    "analysis (median of three): its value with all frames, and errors as parts of it, the remaining one of all "
                    "frames by Richardson's extrapolation; of a method the change from the default. mdana accuracy looks at "
                    "more knobs.");
  for (const auto& section : content.sections)
    if (has_rows(*section.run, "accuracy"))
      text += heading(3, section.run->name) + drawn(section.figures, true) + accuracy_table(section.run->document["accuracy"]);
  return text;
}

std::string stability_table(const Json& stability) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& r : stability) {
    const double digits = r["digits"].is_number() ? r["digits"].get<double>() : 0;
    const auto cell = [&](const char* name, const char* format) {
      return r[name].is_number() ? fmt::format(fmt::runtime(format), r[name].get<double>()) : "not determined";
    };
    rows.push_back({r["quantity"], cell("value", "{:.6g}"), cell("change", "{:.1e}"), cell("digits", "{:.1f}"),
                    digits < StabilityRow::least_stable_digits ? "weak" : "stable"});
  }
  return html::table({"number", "value", "greatest change", "digits kept", "verdict"}, rows, 1);
}

std::string stability_section(const PageContent& content) {
  std::string text = heading(2, "Numerical stability", "stability");
  text += paragraph(fmt::format("Digits of each published number that survive when every number in the dump is moved at "
                                "random within its last printed digit (the worst of {} repetitions). Fewer than {} digits "
                                "are flagged as weak wherever the number stands.", stability_repetitions, static_cast<int>(StabilityRow::least_stable_digits)));
  for (const auto& section : content.sections)
    if (has_rows(*section.run, "stability"))
      text += heading(3, section.run->name) + stability_table(section.run->document["stability"]);
  return text;
}

/// What the plans of the runs had computed: parts that several runs have alike stand once.
std::string computed_table(const PageContent& content) {
  std::map<std::vector<std::string>, std::string> runs;
  std::vector<std::vector<std::string>> rows;
  for (const auto& section : content.sections) {
    if (!section.run->measured()) continue;
    for (const Json& part : section.run->document.value("computed", Json::array())) {
      std::string columns;
      for (const Json& column : part["columns"]) columns += (columns.empty() ? "" : " ") + column.get<std::string>();
      const std::vector<std::string> row{part["what"], columns, part["reason"]};
      std::string& names = runs[row];
      if (names.empty()) rows.push_back(row);
      names += (names.empty() ? "" : ", ") + section.run->name;
    }
  }
  for (auto& row : rows) row.push_back(runs[row]);
  return rows.empty() ? std::string() : paragraph("Computed:") + html::table({"what", "from columns", "because", "in runs"}, rows, 4);
}

std::string left_out_section(const PageContent& content) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& section : content.sections) {
    if (section.run->left_out) rows.push_back({section.run->name, "the run", section.run->failure});
    if (!section.run->measured() || !section.run->document.contains("left_out")) continue;
    for (const Json& l : section.run->document["left_out"]) rows.push_back({section.run->name, l["what"], l["reason"]});
  }
  for (const std::vector<LeftOut>& list : {content.fits.left_out, content.left_out})
    for (const LeftOut& l : list) rows.push_back({"the study", l.what, l.reason});
  return heading(2, "What was left out and why", "left-out") +
         paragraph("Not read, not computed, because the scene does not need it or the dump does not hold it.") +
         html::table({"run", "left out", "because"}, rows, 3) + computed_table(content);
}

std::vector<std::string> run_names(const PageContent& content) {
  std::vector<std::string> names;
  for (const auto& section : content.sections) names.push_back(section.run->name);
  return names;
}

}  // namespace

std::string study_page(const PageContent& content) {
  const std::size_t count = content.sections.size();
  std::string body = heading(1, fmt::format("{} of {} run{}", content.title, count, count == 1 ? "" : "s"));
  body += quiet(fmt::format("{} · mdana {}", content.place, version));
  body += summary_table(content) + pooled_section(content);
  for (const auto& section : content.sections) body += html::section_of(section.run->name, run_section(section));
  body += fits_section(content.fits) + accuracy_section(content) + stability_section(content) + left_out_section(content);
  return html::page(content.title, page_style, body + page_data(run_names(content)), page_script);
}

}  // namespace mdana
