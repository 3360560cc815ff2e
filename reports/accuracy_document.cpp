// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/accuracy_document.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

std::string part(double error) { return std::isnan(error) ? "not known" : error == 0 ? "0" : fmt::format("{:.1e}", error); }

/// The row with the greatest error at a value of the knob, of equal ones that with the greatest stated one; null if
/// the value was not measured.
const AccuracyRow* worst_row(const Ladder& ladder, const std::string& setting) {
  const auto size = [](const AccuracyRow& row) {
    return std::pair(std::isnan(row.error) ? -1 : row.error, std::isnan(row.stated) ? -1 : row.stated);
  };
  const AccuracyRow* worst = nullptr;
  for (const AccuracyRow& row : ladder.rows)
    if (row.setting == setting && (!worst || size(row) > size(*worst))) worst = &row;
  return worst;
}

std::string line_of(const AccuracyRow& row, const Knob& knob) {
  const bool reference = row.setting == knob.values[0].text && knob.reference != Reference::finest;
  std::string text = fmt::format("{:<16} {}", row.setting, reference ? "reference" : "error " + part(row.error));
  if (row.error > 0) text += fmt::format(" ({})", row.quantity);
  if (!std::isnan(row.stated)) text += fmt::format(", stated {}", part(row.stated));
  if (std::isfinite(row.order)) text += fmt::format(", order {:.1f}", row.order);
  return text + fmt::format(", in {:.4f} s", row.cost.seconds);
}

Json to_json(const AccuracyRow& row) {
  return {{"setting", row.setting},       {"number", row.number},        {"quantity", row.quantity}, {"value", row.value},
          {"error", row.error},           {"stated", row.stated},        {"order", row.order},       {"seconds", row.cost.seconds},
          {"spread", row.cost.spread},    {"memory", row.cost.memory}};
}

std::string settings_text(const Recommendation& r) {
  std::string text;
  for (const auto& [knob, setting] : r.settings) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", knob, setting);
  return text;
}

}  // namespace

void add_ladder_lines(Document& document, const Ladder& ladder) {
  const std::string label = fmt::format("{}, {}", ladder.subject, ladder.knob.name);
  for (const KnobValue& value : ladder.knob.values)
    if (const AccuracyRow* row = worst_row(ladder, value.text)) document.line(label, line_of(*row, ladder.knob));
  if (!ladder.left_out.empty()) document.left_out(label, ladder.left_out);
}

void add_fixed_line(Document& document, const std::string& subject, const FixedChoice& fixed) {
  document.line(fmt::format("{}, {}", subject, fixed.name), fmt::format("{:<16} fixed: {}", fixed.value, fixed.reason));
}

Json to_json(const FixedChoice& fixed) { return {{"knob", fixed.name}, {"value", fixed.value}, {"reason", fixed.reason}}; }

Json to_json(const Ladder& ladder) {
  Json json{{"knob", ladder.knob.name}, {"meaning", ladder.knob.meaning}, {"reference", name(ladder.knob.reference)}};
  json["order"] = ladder.knob.order > 0 ? Json(ladder.knob.order) : Json(nullptr);
  json["draws"] = ladder.knob.draws;
  json["rows"] = Json::array();
  for (const AccuracyRow& row : ladder.rows) json["rows"].push_back(to_json(row));
  if (!ladder.left_out.empty()) json["left_out"] = ladder.left_out;
  return json;
}

Json to_json(const Recommendation& r) {
  Json json{{"wanted", r.wanted}, {"met", r.met()}, {"error", r.error}, {"quantity", r.quantity}, {"exceeds", r.error / r.wanted}};
  json["settings"] = Json::object();
  for (const auto& [knob, setting] : r.settings) json["settings"][knob] = setting;
  json["seconds"] = r.cost.seconds;
  return json;
}

std::string to_text(const Recommendation& r) {
  const std::string what = fmt::format("{}: error {}{}", settings_text(r), part(r.error), r.quantity.empty() ? "" : " (" + r.quantity + ")");
  if (r.met()) return fmt::format("{}, wanted {:g}", what, r.wanted);
  return fmt::format("{}, {:.3g} times the wanted {:g}", what, r.error / r.wanted, r.wanted);
}

void add_choice(Document& document, const Recommendation& r) {
  document.json("accuracy", to_json(r));
  document.line("chosen", to_text(r));
  if (!r.met()) document.warn(fmt::format("the wanted error cannot be met: {}", to_text(r)));
}

}  // namespace mdana
