// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/file_set.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view signs = "*%";

struct Match {
  std::uint64_t step = 0;
  std::uint64_t piece = 0;
  fs::path file;

  std::pair<std::uint64_t, std::uint64_t> numbers() const { return {step, piece}; }
};

void check_pattern(const fs::path& pattern) {
  const std::string name = pattern.filename().string();
  for (const char sign : signs)
    if (std::count(name.begin(), name.end(), sign) > 1)
      throw InputError(fmt::format("{}: '{}' may stand once in the name of a file set",
                                   pattern.string(), sign));
  for (std::size_t k = 0; k + 1 < name.size(); ++k)
    if (signs.find(name[k]) != signs.npos && (signs.find(name[k + 1]) != signs.npos ||
                                              (name[k + 1] >= '0' && name[k + 1] <= '9')))
      throw InputError(fmt::format("{}: the number that '{}' stands for has no end: something "
                                   "other than a digit must follow it", pattern.string(), name[k]));
}

/// Takes a whole number off the front of the text.
bool take_number(std::string_view& text, std::uint64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

std::optional<Match> match(std::string_view pattern, const fs::path& file) {
  const std::string name = file.filename().string();
  std::string_view rest = name;
  Match found{0, 0, file};
  for (const char c : pattern) {
    if (signs.find(c) != signs.npos) {
      if (!take_number(rest, c == '*' ? found.step : found.piece)) return std::nullopt;
    } else if (rest.starts_with(c)) {
      rest.remove_prefix(1);
    } else {
      return std::nullopt;
    }
  }
  if (!rest.empty()) return std::nullopt;
  return found;
}

std::vector<Match> matches(const fs::path& pattern) {
  const std::string name = pattern.filename().string();
  const fs::path folder = pattern.parent_path();
  std::error_code error;
  std::vector<Match> found;
  for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end;
       it.increment(error))
    if (auto m = match(name, folder / it->path().filename())) found.push_back(std::move(*m));
  if (error)
    throw InputError(fmt::format("{}: cannot list {}: {}", pattern.string(),
                                 folder.empty() ? "this folder" : folder.string(),
                                 error.message()));
  if (found.empty())
    throw InputError(fmt::format("{}: no file of this name, nor any with whole numbers for {}",
                                 pattern.string(),
                                 name.find('%') == name.npos   ? "'*'"
                                 : name.find('*') == name.npos ? "'%'"
                                                               : "'*' and '%'"));
  std::sort(found.begin(), found.end(),
            [](const Match& a, const Match& b) { return a.numbers() < b.numbers(); });
  return found;
}

void check_twins(const std::vector<Match>& found) {
  const auto twin = std::adjacent_find(
      found.begin(), found.end(),
      [](const Match& a, const Match& b) { return a.numbers() == b.numbers(); });
  if (twin != found.end())
    throw InputError(fmt::format("{} and {} have the same number; one of them must go",
                                 twin->file.string(), std::next(twin)->file.string()));
}

/// The pieces of every step must be 0, 1 ... up to the highest that any step has.
void check_pieces(const fs::path& pattern, const std::vector<Match>& found) {
  std::uint64_t last = 0;
  for (const Match& m : found) last = std::max(last, m.piece);
  std::uint64_t expected = 0;
  const Match* before = nullptr;
  const auto missing = [&](const Match& at) {
    return InputError(fmt::format("{}: piece {} is missing beside {} (there are pieces 0 to {})",
                                  pattern.string(), expected, at.file.string(), last));
  };
  for (const Match& m : found) {
    if (before && before->step != m.step) {
      if (expected <= last) throw missing(*before);
      expected = 0;
    }
    if (m.piece != expected) throw missing(m);
    ++expected;
    before = &m;
  }
  if (expected <= last) throw missing(*before);
}

}  // namespace

std::optional<FileSet> find_file_set(const fs::path& name) {
  std::error_code ignored;
  const std::string file_name = name.filename().string();
  if (file_name.find_first_of(signs) == file_name.npos || fs::exists(name, ignored))
    return std::nullopt;
  check_pattern(name);
  const std::vector<Match> found = matches(name);
  check_twins(found);
  if (file_name.find('%') != file_name.npos) check_pieces(name, found);
  FileSet set;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (k == 0 || found[k].step != found[k - 1].step) set.emplace_back();
    set.back().push_back(found[k].file);
  }
  return set;
}

std::optional<std::uint64_t> step_in_name(const fs::path& set, const fs::path& file) {
  const std::string pattern = set.filename().string();
  if (pattern.find('*') == pattern.npos) return std::nullopt;
  const auto found = match(pattern, file);
  if (!found) return std::nullopt;
  return found->step;
}

}  // namespace mdana
