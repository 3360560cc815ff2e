// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/flow_list.hpp"

#include <algorithm>

namespace mdana {
namespace {

bool is_word(std::string_view text) {
  return !text.empty() && std::none_of(text.begin(), text.end(), is_blank);
}

std::string_view unquoted(std::string_view value) {
  const bool quoted = value.size() >= 2 && (value.front() == '\'' || value.front() == '"') &&
                      value.back() == value.front();
  return quoted ? value.substr(1, value.size() - 2) : value;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view rest = trimmed(line); !rest.empty(); rest = trimmed(rest)) {
    const auto end = std::find_if(rest.begin(), rest.end(), is_blank);
    words.emplace_back(rest.data(), static_cast<std::size_t>(end - rest.begin()));
    rest.remove_prefix(words.back().size());
  }
  return words;
}

std::optional<std::string_view> bracketed(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  return text.substr(1, text.size() - 2);
}

std::optional<std::string_view> list_item(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 2 || text.front() != '-' || !is_blank(text[1])) return std::nullopt;
  return trimmed(text.substr(1));
}

std::optional<std::vector<std::string>> flow_list(std::string_view text) {
  const auto inside = bracketed(text);
  if (!inside) return std::nullopt;
  std::vector<std::string> words;
  std::string_view rest = trimmed(*inside);  // the last comma may be missing
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view word = unquoted(trimmed(rest.substr(0, comma)));
    if (!is_word(word)) return std::nullopt;
    words.emplace_back(word);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    rest = trimmed(rest);
  }
  return words;
}

}  // namespace mdana
