// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace mdana::html {
namespace {

/// The source expression of CSP for a text known by its hash.
std::string policy_source(const Trusted& trusted) {
  if (trusted.text.empty()) return "'none'";
  std::string bytes;
  for (std::size_t i = 0; i + 1 < trusted.sha256.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(trusted.sha256.substr(i, 2)), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63u];
  }
  return text;
}

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string element(std::string_view name, std::string_view content, std::string_view attributes) {
  return fmt::format("<{0}{1}{2}>{3}</{0}>\n", name, attributes.empty() ? "" : " ", attributes,
                     content);
}

std::string paragraph(std::string_view text) { return element("p", escape(text)); }

std::string heading(int level, std::string_view text, std::string_view id) {
  return element(fmt::format("h{}", level), escape(text),
                 id.empty() ? "" : fmt::format("id=\"{}\"", escape(id)));
}

std::string table(const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows, std::size_t text_columns) {
  std::string cells;
  for (const std::string& h : head) cells += element("th", escape(h), "scope=\"col\"");
  std::string body;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k)
      line += element("td", escape(row[k]), k < text_columns ? "" : "class=\"number\"");
    body += element("tr", line);
  }
  const std::string content = element("thead", element("tr", cells)) + element("tbody", body);
  return element("div", element("table", content), "class=\"scroll\" tabindex=\"0\"");
}

std::string list(const std::vector<std::string>& items) {
  std::string content;
  for (const std::string& item : items) content += element("li", escape(item));
  return element("ul", content);
}

std::string picture(std::string_view svg, std::string_view alt) {
  if (svg.empty()) return {};
  return fmt::format("<img alt=\"{}\" loading=\"lazy\" src=\"data:image/svg+xml;base64,{}\">", escape(alt),
                     base64(svg));
}

std::string section_of(std::string_view run, std::string_view content) {
  return element("section", content, fmt::format("class=\"run\" data-run=\"{}\"", escape(run)));
}

std::string data_block(std::string_view id, std::string_view json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return element("script", text, fmt::format("type=\"application/json\" id=\"{}\"", escape(id)));
}

std::string page(std::string_view title, const Trusted& style, std::string_view body, const Trusted& script) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src {}; script-src {}; base-uri 'none'; form-action 'none'\">\n<title>{}</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n{}</body>\n</html>\n",
      policy_source(style), policy_source(script), escape(title), style.text, body,
      script.text.empty() ? "" : fmt::format("<script>{}</script>\n", script.text));
}

}  // namespace mdana::html
