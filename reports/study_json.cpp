// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_json.hpp"

#include "reports/version.hpp"

namespace mdana {
namespace {

nlohmann::ordered_json accuracy_json(const StudyRun& entry) {
  auto rows = nlohmann::ordered_json::array();
  for (const AccuracyRow& r : entry.accuracy)
    rows.push_back({{"setting", r.setting},
                    {"quantity", r.quantity},
                    {"value", r.value},
                    {"relative_difference", r.error},
                    {"seconds", r.seconds}});
  return rows;
}

nlohmann::ordered_json stability_json(const StudyRun& entry) {
  auto rows = nlohmann::ordered_json::array();
  for (const StabilityRow& r : entry.stability)
    rows.push_back({{"quantity", r.quantity},
                    {"value", r.value},
                    {"change", r.change},
                    {"digits", r.digits}});
  return rows;
}

nlohmann::ordered_json run_json(const StudyRun& entry) {
  if (!entry.result)
    return {{"name", entry.name}, {"dump", entry.dump.string()}, {"failure", entry.failure}};
  const AnalysedRun& result = *entry.result;
  Document document("report", *entry.run);
  document.json("name", entry.name);
  document.sweep(result.measured.swept, entry.run->format);
  add_force(document, result.curve, result.source, result.radii);
  add_contact_radius(document, result.contact, result.contact_setup);
  if (result.hertz) add_hertz(document, *entry.run, *result.hertz);
  if (entry.overlay)
    document.json("overlay", {{"law", entry.overlay->law->name}, {"source", entry.overlay->source}});
  document.json("accuracy", accuracy_json(entry));
  document.json("stability", stability_json(entry));
  for (const LeftOut& l : entry.left_out) document.left_out(l.what, l.reason);
  return document.content();
}

}  // namespace

nlohmann::ordered_json study_json(const Study& study) {
  nlohmann::ordered_json json;
  json["command"] = "report";
  json["mdana_version"] = version;
  json["directory"] = study.directory.string();
  json["runs"] = nlohmann::ordered_json::array();
  for (const StudyRun& entry : study.runs) json["runs"].push_back(run_json(entry));
  for (const AggregateRun& entry : study.aggregates)
    json["runs"].push_back(entry.result ? aggregate_document(entry).content()
                                        : nlohmann::ordered_json{{"name", entry.name},
                                                                 {"dump", entry.dump.string()},
                                                                 {"failure", entry.failure}});
  if (!study.together.failure.empty()) json["aggregates"] = {{"failure", study.together.failure}};
  if (study.together.study) {
    Document document("compress");
    add_compression_study(document, *study.together.study);
    json["aggregates"] = document.content();
  }
  return json;
}

}  // namespace mdana
