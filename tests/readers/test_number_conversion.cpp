// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

/// Numbers as LAMMPS may print them: any format, any length, the whole range of doubles.
std::vector<std::string> random_tokens(std::size_t count) {
  std::mt19937_64 random(7);
  const char* formats[] = {"%g", "%.8g",  "%.15g", "%.17g", "%-1.16e",
                           "%f", "%.20g", "%.40e", "%12.3e"};
  std::vector<std::string> tokens;
  while (tokens.size() < count) {
    double value = std::bit_cast<double>(random());
    if (tokens.size() % 2) value = std::ldexp(static_cast<double>(random()), -64);  // 0 to 1
    char text[512];
    if (!std::isfinite(value)) continue;
    std::snprintf(text, sizeof text, formats[random() % std::size(formats)], value);
    tokens.emplace_back(text);
  }
  return tokens;
}

// strtod of glibc is correctly rounded, and so is what the dump reader gives: the same bits.
TEST(NumberConversion, IsCorrectlyRounded) {
  const auto tokens = random_tokens(100'000);
  std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(tokens.size()) +
                     "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS q\n";
  for (const std::string& token : tokens) text += token + "\n";
  const test::TemporaryFolder folder;
  const auto whole = test::read_all(folder.write("dump", text), {"q"});
  ASSERT_EQ(whole.error, "");
  const auto& q = whole.frames[0].real.at("q");
  ASSERT_EQ(q.size(), tokens.size());
  for (std::size_t i = 0; i < q.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(q[i]),
              std::bit_cast<std::uint64_t>(std::strtod(tokens[i].c_str(), nullptr)))
        << tokens[i];
}

}  // namespace
}  // namespace mdana
