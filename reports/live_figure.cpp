// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/live_figure.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "reports/page_picture.hpp"
#include "reports/page_script.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

/// Six digits, as many as the script shows of a value.
Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values)
    if (std::isfinite(v))
      list.push_back(std::strtod(fmt::format("{:.6g}", v).c_str(), nullptr));
    else
      list.push_back(nullptr);
  return list;
}

const char* style_name(Series::Style style) {
  switch (style) {
    case Series::Style::line: return "line";
    case Series::Style::dashed: return "dashed";
    case Series::Style::points: return "points";
    case Series::Style::dotted: return "dotted";
    case Series::Style::dash_dotted: return "dash-dotted";
  }
  return "";
}

Json series_json(const Series& series) {
  Json json{{"label", series.part.empty() ? series.label : series.part}};
  if (!series.run.empty()) json["run"] = series.run;
  json["style"] = style_name(series.style);
  json["x"] = numbers(series.x);
  json["y"] = numbers(series.y);
  if (!series.y_error.empty()) json["y_error"] = numbers(series.y_error);
  if (!series.names.empty()) json["names"] = series.names;
  return json;
}

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json figure_json(const Figure& figure) {
  Json json{{"title", figure.title},
            {"alt", figure.alt},
            {"x", {{"label", figure.x_label}, {"log", figure.log_x}}},
            {"y", {{"label", figure.y_label}, {"log", figure.log_y}}},
            {"series", Json::array()}};
  for (const Series& series : figure.series) json["series"].push_back(series_json(series));
  return json;
}

std::string live_figure(const Figure& figure) {
  const std::string content = html::picture(page_picture(figure), figure.alt) +
                              html::element("figcaption", html::escape(figure.alt));
  if (page_script.text.empty()) return html::element("figure", content);
  return html::element("figure", content, fmt::format("data-figure=\"{}\"", html::escape(figure.name))) +
         html::data_block("figure-" + figure.name, text(figure_json(figure)));
}

std::string page_data(const std::vector<std::string>& runs) {
  if (page_script.text.empty()) return {};
  return html::data_block("page-data", text({{"runs", runs}}));
}

}  // namespace mdana
