// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/run_checks.hpp"

#include <sstream>

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

Json accuracy_json(const std::vector<AccuracyRow>& accuracy) {
  Json rows = Json::array();
  for (const AccuracyRow& r : accuracy)
    rows.push_back({{"knob", r.knob},
                    {"setting", r.setting},
                    {"quantity", r.quantity},
                    {"value", r.value},
                    {"relative_error", r.error},
                    {"stated", r.stated},
                    {"seconds", r.cost.seconds},
                    {"spread", r.cost.spread},
                    {"memory", r.cost.memory}});
  return rows;
}

Json stability_json(const std::vector<StabilityRow>& stability) {
  Json rows = Json::array();
  for (const StabilityRow& r : stability)
    rows.push_back({{"quantity", r.quantity}, {"value", r.value}, {"change", r.change}, {"digits", r.digits}, {"weak", r.weak()}});
  return rows;
}

/// The object of a number with dots in its name; nothing if the document has none.
Json* find_number(Json& document, const std::string& name) {
  Json* at = &document;
  std::istringstream parts(name);
  for (std::string part; std::getline(parts, part, '.');) {
    const auto next = at->is_object() ? at->find(part) : at->end();
    if (next == at->end()) return nullptr;
    at = &*next;
  }
  return at->is_object() && at->contains("value") ? at : nullptr;
}

}  // namespace

std::vector<AccuracyRow> accuracy_rows(const AccuracySubject& subject, std::span<const Knob> knobs) {
  std::vector<AccuracyRow> rows;
  for (const Knob& knob : knobs)
    for (AccuracyRow& row : climb(subject, knob, report_repetitions).rows) rows.push_back(std::move(row));
  return rows;
}

void add_checks(RunRecord& record, const std::vector<AccuracyRow>& accuracy, const std::vector<StabilityRow>& stability) {
  record.document["accuracy"] = accuracy_json(accuracy);
  record.document["stability"] = stability_json(stability);
  for (const StabilityRow& row : stability)
    if (Json* number = find_number(record.document, row.quantity)) {
      (*number)["stable_digits"] = row.digits;
      (*number)["weak"] = row.weak();
    }
}

}  // namespace mdana
