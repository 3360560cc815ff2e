// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// A blank of a line: everything up to the space.
constexpr bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

/// Without blanks before and behind.
std::string_view trimmed(std::string_view text);

/// What stands between blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// What is between the brackets of "[ ... ]"; nothing if the text is no such thing.
std::optional<std::string_view> bracketed(std::string_view text);

/// What is behind "- " of an item of a list; nothing if the text is none.
std::optional<std::string_view> list_item(std::string_view text);

/// The words of "[ a, 'b', "c", ]", without their quotes; nothing if the text is no such list, or
/// a value is empty or more than one word.
std::optional<std::vector<std::string>> flow_list(std::string_view text);

}  // namespace mdana
