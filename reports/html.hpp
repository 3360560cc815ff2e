// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana::html {

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

/// An SVG picture within the page, with its caption; `alt` tells what it shows.
std::string picture(std::string_view svg, std::string_view alt, std::string_view caption);

/// A whole page: title, style sheet, body (HTML). No scripts, nothing loaded from elsewhere.
std::string page(std::string_view title, std::string_view style, std::string_view body);

}  // namespace mdana::html
