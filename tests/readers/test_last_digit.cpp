// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "readers/last_digit.hpp"
#include "readers/trajectory.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

/// One column of a one-frame dump, moved with a seed; without a seed as it is.
class LastDigit : public ::testing::Test {
 protected:
  std::vector<double> read(const std::string& head, const std::vector<std::string>& lines,
                           const std::string& column, std::optional<std::uint64_t> seed) {
    std::string text = "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n" + std::to_string(lines.size()) +
                       "\nITEM: BOX BOUNDS pp pp pp\n0 100\n0 100\n0 100\nITEM: ATOMS " + head +
                       "\n";
    for (const std::string& line : lines) text += line + "\n";
    const ColumnSet wanted = column == "x" ? ColumnSet{"x", "y", "z"} : ColumnSet{column};
    const auto source = open_trajectory(folder_.write("dump", text), wanted);
    FrameHeader header;
    source->next(header);
    Chunk chunk;
    AtomBlock block;
    std::vector<double> values;
    while (source->cut(chunk)) {
      convert(chunk, block);
      if (seed) move_last_digits(chunk, header, wanted, *seed, block);
      const auto part = std::as_const(block).real(column);
      values.insert(values.end(), part.begin(), part.end());
    }
    return values;
  }
  test::TemporaryFolder folder_;
};

// Printed with %.6e: every value has 7 significant digits.
std::vector<std::string> printed(std::size_t count) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < count; ++i) {
    char text[40];
    const double sign = i % 2 ? -1 : 1;
    std::snprintf(text, sizeof text, "%.6e",
                  sign * (1.000001 + 0.1 * static_cast<double>(i % 80)) *
                      std::pow(10.0, static_cast<double>(i % 40) - 20));
    lines.emplace_back(text);
  }
  return lines;
}

double unit_of(const std::string& text) {  // of d.dddddde+XX
  return std::pow(10.0, std::stod(text.substr(text.find('e') + 1)) - 6);
}

TEST_F(LastDigit, MovesStayWithinHalfAUnit) {
  const auto lines = printed(4000);
  const auto plain = read("q", lines, "q", {}), moved = read("q", lines, "q", 1);
  double sum = 0, square = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double part = (moved[i] - plain[i]) / unit_of(lines[i]);
    ASSERT_LE(std::abs(part), 0.5 + 1e-9) << lines[i];  // 1e-9: rounding of the sum at 7 digits
    sum += part;
    square += part * part;
  }
  // Uniform in (-1/2, 1/2): mean 0, mean square 1/12; 5 standard errors of 4000 samples.
  EXPECT_NEAR(sum / 4000, 0, 5 * std::sqrt(1 / 12.0 / 4000));
  EXPECT_NEAR(square / 4000, 1 / 12.0, 5 * std::sqrt(1 / 180.0 / 4000));
}

TEST_F(LastDigit, SameSeedSameMovesOtherSeedOthers) {
  const auto lines = printed(2000);
  const auto first = read("q", lines, "q", 1);
  EXPECT_EQ(first, read("q", lines, "q", 1));
  const auto other = read("q", lines, "q", 2);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_NE(first[i], other[i]) << lines[i];
}

TEST_F(LastDigit, AtomsOfAllBlocksMoveDifferently) {
  const std::vector<std::string> lines(AtomBlock::capacity + 2000, "1.234567");
  auto moved = read("q", lines, "q", 3);
  std::sort(moved.begin(), moved.end());
  EXPECT_EQ(std::adjacent_find(moved.begin(), moved.end()), moved.end());
}

// Trailing zeros are not printed by %g: the digits are those of the longest value of the column.
TEST_F(LastDigit, DigitsAreThoseOfTheColumn) {
  const auto moved = read("q", {"2", "0.25", "1.23456789"}, "q", 1);
  EXPECT_LE(std::abs(moved[0] - 2), 0.5e-8);
  EXPECT_NE(moved[0], 2);
  EXPECT_LE(std::abs(moved[1] - 0.25), 0.5e-9);
}

TEST_F(LastDigit, ScaledPositionsMoveByTheirOwnDigits) {
  // three digits of a fraction of an edge of 100: +-0.0005 * 100
  const auto moved = read("xs ys zs", {"0.512 0.25 0.125", "0.513 0.5 0.5"}, "x", 4);
  EXPECT_NE(moved[0], 51.2);
  EXPECT_LE(std::abs(moved[0] - 51.2), 0.05 + 1e-12);
  EXPECT_LE(std::abs(moved[1] - 51.3), 0.05 + 1e-12);
  double square = 0;
  for (const double x :
       read("xs ys zs", std::vector<std::string>(1000, "0.512 0.25 0.125"), "x", 4))
    square += (x - 51.2) * (x - 51.2) / 1000;
  EXPECT_NEAR(square / (0.1 * 0.1), 1 / 12.0, 5 * std::sqrt(1 / 180.0 / 1000));  // uniform
}

TEST_F(LastDigit, ImagesDoNotWidenTheMoves) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto moved = read("x y z ix iy iz", {"0.512 1 1 7 0 0", "0.513 1 1 0 0 0"}, "x", seed);
    EXPECT_LE(std::abs(moved[0] - 700.512), 0.0005 + 1e-12) << seed;
    EXPECT_LE(std::abs(moved[1] - 0.513), 0.0005 + 1e-12) << seed;
  }
}

TEST_F(LastDigit, FixedDecimals) {
  std::vector<std::string> lines(1000, "1.234");
  lines.push_back("1234.567");
  lines.push_back("0.001");
  const auto moved = read("q", lines, "q", 5);
  EXPECT_LE(std::abs(moved[1000] - 1234.567), 0.0005);
  EXPECT_LE(std::abs(moved[1001] - 0.001), 0.0005);
}

TEST_F(LastDigit, ZeroAndWholeNumberColumnsStay) {
  const auto moved = read("q", {"0", "1.5", "nan", "inf"}, "q", 6);
  EXPECT_EQ(moved[0], 0);
  EXPECT_TRUE(std::isnan(moved[2]));
  EXPECT_TRUE(std::isinf(moved[3]));
}

}  // namespace
}  // namespace mdana
