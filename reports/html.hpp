// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana::html {

std::string base64(std::string_view bytes);

/// Text with everything that HTML would interpret escaped.
std::string escape(std::string_view text);

/// <name attributes>content</name>; the content is HTML.
std::string element(std::string_view name, std::string_view content,
                    std::string_view attributes = {});

/// A paragraph, a heading of plain text.
std::string paragraph(std::string_view text);
std::string heading(int level, std::string_view text, std::string_view id = {});

/// A table of plain-text cells; all columns but the first `text_columns` are set as numbers.
std::string table(const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows, std::size_t text_columns = 1);

/// A list of plain-text items.
std::string list(const std::vector<std::string>& items);

/// An SVG picture within the page; `alt` tells what it shows. Empty without SVG.
std::string picture(std::string_view svg, std::string_view alt);

/// A section on one run, which the page's script links with its figures and tables.
std::string section_of(std::string_view run, std::string_view content);

/// Text for a JSON block of the page, which its script reads by its id.
std::string data_block(std::string_view id, std::string_view json);

/// A style sheet or a script, and its SHA-256 (hexadecimal) by which the page's policy lets it pass.
struct Trusted {
  std::string_view text, sha256;
};

/// A whole page: title, style sheet, body (HTML), and a script if its text is not empty. Its content
/// security policy lets only these pass, and nothing is loaded from elsewhere.
std::string page(std::string_view title, const Trusted& style, std::string_view body,
                 const Trusted& script = {});

}  // namespace mdana::html
