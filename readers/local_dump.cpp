// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/local_dump.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "readers/flow_list.hpp"
#include "readers/input_error.hpp"
#include "readers/shown.hpp"

namespace mdana {
namespace {

template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

auto ids(const ListedContact& contact) { return std::pair(contact.id1, contact.id2); }

}  // namespace

LocalDump::LocalDump(const std::filesystem::path& path, Columns columns)
    : path_(path.string()), lines_(open_bytes(path)), columns_(std::move(columns)) {}

void LocalDump::fail(const std::string& what) const {
  throw InputError(fmt::format("{}:{}: {}", path_, lines_.number(), what));
}

std::string_view LocalDump::needed_line() {
  const auto line = lines_.line();
  if (line) return *line;
  const std::string damage = lines_.bytes().damage();
  throw TruncatedInput(fmt::format("{}: ends within a frame, behind line {}{}", path_,
                                   lines_.number(), damage.empty() ? "" : " (" + damage + ")"));
}

std::int64_t LocalDump::whole(std::string_view text) const {
  const auto value = number_of<std::int64_t>(trimmed(text));
  if (!value) fail(fmt::format("a whole number is expected, not '{}'", shown(text)));
  return *value;
}

void LocalDump::find_columns(std::string_view names) {
  const auto words = words_of(names);
  width_ = words.size();
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const auto it = std::ranges::find(words, columns_[k]);
    if (it == words.end())
      fail(fmt::format("no column '{}' (there are: {}); name id, id and force by --contact-columns",
                       columns_[k], shown(trimmed(names), 300)));
    place_[k] = static_cast<std::size_t>(it - words.begin());
  }
}

ListedContact LocalDump::entry(std::string_view line) const {
  const auto words = words_of(line);
  if (words.size() != width_)
    fail(fmt::format("{} columns (the header names {})", words.size(), width_));
  const auto id1 = number_of<std::int64_t>(words[place_[0]]),
             id2 = number_of<std::int64_t>(words[place_[1]]);
  const auto force = number_of<double>(words[place_[2]]);
  if (!id1 || !id2 || *id1 == *id2) fail("the two ids are not two different whole numbers");
  if (!force || !std::isfinite(*force)) fail("the force is not a finite number");
  return {std::min(*id1, *id2), std::max(*id1, *id2), *force};
}

void LocalDump::entries(std::int64_t count, LocalFrame& frame) {
  for (std::int64_t k = 0; k < count; ++k) frame.contacts.push_back(entry(needed_line()));
  std::ranges::sort(frame.contacts, {}, ids);
  const auto twice = std::ranges::adjacent_find(frame.contacts, {}, ids);
  if (twice != frame.contacts.end())
    fail(
        fmt::format("the frame that ends here lists the pair {} {} twice", twice->id1, twice->id2));
}

bool LocalDump::pass_blank_lines() {
  auto line = lines_.peek();
  for (; line && trimmed(*line).empty(); line = lines_.peek()) lines_.line();
  if (line) return true;
  lines_.line();  // tells whether the file ends within a line
  if (lines_.unfinished() || !lines_.bytes().damage().empty()) needed_line();
  return false;
}

std::optional<LocalFrame> LocalDump::next() {
  LocalFrame frame;
  std::optional<std::int64_t> step, count;
  if (!pass_blank_lines()) return std::nullopt;
  while (true) {
    const std::string item(trimmed(needed_line()));
    if (item == "ITEM: TIMESTEP") {
      step = whole(needed_line());
    } else if (item.starts_with("ITEM: NUMBER OF")) {
      count = whole(needed_line());
      if (*count < 0) fail("a negative number of entries");
    } else if (item.starts_with("ITEM: BOX BOUNDS")) {
      for (int k = 0; k < 3; ++k) needed_line();
    } else if (item == "ITEM: UNITS" || item == "ITEM: TIME") {
      needed_line();
    } else if (item.starts_with("ITEM: ENTRIES") && step && count) {
      if (step_ && *step <= *step_) fail("the step does not come after that of the frame before");
      frame.step = *(step_ = step);
      find_columns(std::string_view(item).substr(13));
      entries(*count, frame);
      return frame;
    } else {
      fail(fmt::format(
          "'{}' is no part of a local dump (ITEM: TIMESTEP, NUMBER OF ENTRIES, ENTRIES ...)",
          shown(item)));
    }
  }
}

}  // namespace mdana
