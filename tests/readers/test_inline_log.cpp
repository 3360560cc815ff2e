// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include <gtest/gtest.h>

#include "readers/inline_log.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

const std::string title = "# mdana-inline 1 units=metal interaction=adhesive radii=5,6.5 radius_definition=cut bodies=type 1, 2\n";
const std::string of_body_1 = "n1 m1 x1 y1 z1 vx1 vy1 vz1 fx1 fy1 fz1 Kt1 Lx1 Ly1 Lz1 Ixx1 Iyy1 Izz1 Ixy1 Iyz1 Ixz1";
const std::string of_body_2 = "n2 m2 x2 y2 z2 vx2 vy2 vz2 fx2 fy2 fz2 Kt2 Lx2 Ly2 Lz2 Ixx2 Iyy2 Izz2 Ixy2 Iyz2 Ixz2";
const std::string columns = "# TimeStep time dt " + of_body_1 + " " + of_body_2 + "\n";
constexpr int numbers = 44;  ///< in a row besides the step

/// A row whose k-th number is `k + 0.25`, k from 1 (of atoms, which are whole, k), but for one of them.
std::string row(int step, int changed = 0, const std::string& text = {}) {
  std::ostringstream line;
  line << step;
  for (int k = 1; k <= numbers; ++k) line << ' ' << (k == changed ? text : std::to_string(k) + (k == 3 || k == 24 ? "" : ".25"));
  return line.str() + "\n";
}

class InlineLogs : public ::testing::Test {
 protected:
  InlineLog read(const std::string& text) { return read_inline_log(folder_.write("inline.txt", text)); }
  test::TemporaryFolder folder_;
};

TEST_F(InlineLogs, HeadAndRows) {
  const InlineLog log = read(title + columns + row(0) + row(32, 5, "1e-3") + row(40));
  EXPECT_EQ(log.units, Units::metal);
  EXPECT_EQ(log.interaction, Interaction::adhesive);
  EXPECT_EQ(log.radii, (std::vector<double>{5, 6.5}));
  EXPECT_EQ(log.radius_definition, "cut");
  EXPECT_EQ(log.bodies, "type 1, 2");
  EXPECT_EQ(log.steps, (std::vector<std::int64_t>{0, 32, 40}));
  EXPECT_EQ(*log.find("time"), (std::vector<double>{1.25, 1.25, 1.25}));
  EXPECT_EQ(*log.find("n1"), (std::vector<double>{3, 3, 3}));
  EXPECT_EQ(*log.find("x1"), (std::vector<double>{5.25, 1e-3, 5.25}));
  EXPECT_EQ(log.find("Ixz2")->front(), numbers + 0.25);
  EXPECT_FALSE(log.has("W1"));
  EXPECT_DOUBLE_EQ(log.last_digit[4], 1e-3);
  EXPECT_EQ(log.cut, "");
  const std::string with_potentials = row(0, 25, "25");  // where n2 is behind W1
  EXPECT_EQ(read(title + "# TimeStep time dt " + of_body_1 + " W1 " + of_body_2 + " W2\n" +
                 with_potentials.substr(0, with_potentials.size() - 1) + " 45 46\n").find("W2")->front(), 46);
}

TEST_F(InlineLogs, Recognised) {
  EXPECT_TRUE(is_inline_log(folder_.write("a", title)));
  EXPECT_FALSE(is_inline_log(folder_.write("b", "# mdana-inline 2 units=lj")));
  EXPECT_FALSE(is_inline_log(folder_.write("c", "#")));
  EXPECT_FALSE(is_inline_log("/no/such/file"));
  EXPECT_TRUE(is_inline_log(folder_.write("d.gz", test::gzipped(title + columns + row(0)))));
}

TEST_F(InlineLogs, CutAnywhereGivesTheWholeRows) {
  const std::string whole = title + columns + row(0) + row(10);
  const std::size_t first = title.size() + columns.size() + row(0).size();
  for (std::size_t at = first + 1; at < whole.size(); at += 7) {
    const InlineLog log = read(whole.substr(0, at));
    EXPECT_EQ(log.steps.size(), 1u) << at;
    EXPECT_NE(log.cut.find("line 4"), std::string::npos) << log.cut;
  }
  for (std::size_t at = 0; at < first; at += 5)
    EXPECT_THROW(read(whole.substr(0, at)), InputError) << at;
}

TEST_F(InlineLogs, FaultsAreToldWithTheirLines) {
  const std::string head = title + columns;
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 interaction=hertz bodies=x\n" + columns + row(0)), "inline.txt:1:", "units");
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 units=si weather=good\n" + columns), ":1:", "weather");
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 units=foot\n" + columns), ":1:", "foot");
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 units=lj radii=5\n" + columns), ":1:", "R1,R2");
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 units=lj radii=5,-1\n" + columns), ":1:", "greater than zero");
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 units=lj word\n" + columns), ":1:", "NAME=VALUE");
  EXPECT_INPUT_ERROR(read("# mdana-inline 1 units=lj interaction=love\n" + columns), ":1:", "love");
  EXPECT_INPUT_ERROR(read(title + "# TimeStep time x1 x2\n"), ":2:", "columns");
  EXPECT_INPUT_ERROR(read(title + row(0)), ":2:", "TimeStep");
  EXPECT_INPUT_ERROR(read(head), "no rows");
  EXPECT_INPUT_ERROR(read(head + row(0) + "1 2 3\n"), ":4:", "3 values", "45");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 5, "x")), ":4:", "'x'", "x1");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 11, "nan")), ":4:", "fx1", "went wrong");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 11, "-inf")), ":4:", "fx1");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 11, "1e999")), ":4:", "fx1");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 3, "0")), ":4:", "n1", "no atoms");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 24, "1e300")), ":4:", "n2", "number of atoms");
  EXPECT_INPUT_ERROR(read(head + row(0) + row(10, 24, "2.5")), ":4:", "n2", "number of atoms");
  EXPECT_INPUT_ERROR(read(head + row(20) + row(20)), ":4:", "20 does not come after 20");
  EXPECT_INPUT_ERROR(read(head + row(20) + row(10)), ":4:", "10 does not come after 20");
  EXPECT_INPUT_ERROR(read(head + row(0) + head + row(10)), ":4:", "second head");
  EXPECT_INPUT_ERROR(read(head + row(0) + "\n"), ":4:", "empty");
  EXPECT_INPUT_ERROR(read(head + "99999999999999999999" + row(0).substr(1)), ":3:", "time step");
}

TEST_F(InlineLogs, CompressedAndCut) {
  std::string text = title + columns;
  for (int step = 0; step < 20000; ++step) text += row(step, 1 + step % numbers, std::to_string(1 + 7919 * step % 99991));
  const std::string packed = test::gzipped(text);
  const InlineLog whole = read_inline_log(folder_.write("whole.gz", packed));
  EXPECT_EQ(whole.steps.size(), 20000u);
  EXPECT_EQ(whole.cut, "");
  const InlineLog cut = read_inline_log(folder_.write("cut.gz", packed.substr(0, packed.size() / 2)));
  EXPECT_GT(cut.steps.size(), 1000u);
  EXPECT_LT(cut.steps.size(), 19000u);
  EXPECT_NE(cut.cut, "");
}

}  // namespace
}  // namespace mdana
