// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/shown.hpp"

#include <algorithm>

namespace mdana {

std::string shown(std::string_view text, std::size_t longest) {
  std::string result(text.substr(0, longest));
  const auto obeyed = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::ranges::replace_if(result, obeyed, '?');
  return text.size() > longest ? result + "..." : result;
}

}  // namespace mdana
