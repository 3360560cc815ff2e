// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "readers/input_error.hpp"

namespace mdana::test {

/// Runs `work`, which must throw InputError; gives its text.
template <class Work>
std::string input_error_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace mdana::test

/// The work throws InputError whose text holds every one of the parts.
#define EXPECT_INPUT_ERROR(work, ...)                                          \
  do {                                                                         \
    const std::string mdana_text = mdana::test::input_error_of([&] { work; }); \
    for (const std::string& part : std::vector<std::string>{__VA_ARGS__})      \
      EXPECT_TRUE(mdana::test::contains(mdana_text, part))                     \
          << "'" << part << "' is missing in: " << mdana_text;                 \
  } while (false)
