// SPDX-License-Identifier: GPL-3.0-or-later
// netCDF trajectories that end early, and such that lie about how much there is.
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "tests/readers/netcdf_bytes.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;
using test::NetcdfBytes;
using enum test::NetcdfBytes::Type;
using Bytes = NetcdfBytes;

const ColumnSet wanted{"id", "x", "y", "z", "c_q"};

/// Three frames; no number is zero, so that made-up ones would be seen.
NetcdfBytes trajectory(int version) {
  NetcdfBytes file;
  file.version = version;
  file.records = 3;
  file.axes.push_back({"odd", 5});
  auto& fixed = file.add({"label", {3}, char_, {"abcde"}});
  fixed.attributes.push_back(Bytes::text("units", "none"));
  Bytes::Variable time{"time", {0}, float_, {}, {}}, x{"coordinates", {0, 1, 2}, double_, {}, {}},
      q{"c_q", {0, 1}, byte_, {}, {}};
  for (const float k : {1.F, 2.F, 3.F}) {
    time.records.push_back(Bytes::floats({k}));
    x.records.push_back(Bytes::doubles({k, 1, 2, 3, 4, k / 8}));
    q.records.push_back(Bytes::integers({7, static_cast<std::int64_t>(k)}, 1));
  }
  for (const auto& v : {x, q, time}) file.add(v);
  return file;
}

void expect_beginning(const test::WholeTrajectory& cut, const test::WholeTrajectory& whole) {
  ASSERT_LE(cut.frames.size(), whole.frames.size());
  for (std::size_t i = 0; i < cut.frames.size(); ++i) {
    EXPECT_EQ(cut.frames[i].header.time, whole.frames[i].header.time);
    EXPECT_EQ(cut.frames[i].real, whole.frames[i].real);
    EXPECT_EQ(cut.frames[i].integer, whole.frames[i].integer);
  }
}

/// One byte of a file, of which some bits are flipped meanwhile. (A file that is written anew for
/// every byte costs milliseconds each time.)
class OneByte {
 public:
  OneByte(const std::filesystem::path& file, std::size_t at, char right, int flip)
      : stream_(file, std::ios::in | std::ios::out | std::ios::binary), at_(at), right_(right) {
    put(static_cast<char>(right ^ flip));
  }
  ~OneByte() { put(right_); }

 private:
  void put(char byte) {
    stream_.seekp(static_cast<std::streamoff>(at_));
    stream_.put(byte).flush();
    EXPECT_TRUE(stream_.good());
  }

  std::fstream stream_;
  std::size_t at_;
  char right_;
};

TEST(AmberNetcdfCut, AtEveryByteGivesWholeFramesAndSaysSo) {
  const test::TemporaryFolder folder;
  for (const int version : {2, 5}) {
    const std::string bytes = trajectory(version).bytes();
    const auto whole = test::read_all(folder.write("whole.nc", bytes), wanted);
    ASSERT_EQ(whole.error, "");
    ASSERT_EQ(whole.frames.size(), 3u);
    const std::size_t record = 48 + 4 + 4, first = bytes.size() - 3 * record;
    const auto path = folder.write("cut.nc", bytes);
    for (std::size_t count = bytes.size() - 1; count >= 4; --count) {
      SCOPED_TRACE(count);
      std::filesystem::resize_file(path, count);
      const auto cut = test::read_all(path, wanted);
      expect_beginning(cut, whole);
      EXPECT_EQ(cut.frames.size(), count < first ? 0 : (count - first) / record);
      EXPECT_TRUE(cut.truncated) << cut.error;
    }
  }
}

// A single variable of records has no padding between them (file format specification, note on
// padding): 3 frames of 5 bytes.
TEST(AmberNetcdfCut, ASingleVariableIsNotPadded) {
  const test::TemporaryFolder folder;
  NetcdfBytes file;
  file.records = 3;
  file.axes[1].length = 5;
  file.add({"c_q", {0, 1}, byte_, {}});
  const std::string head = file.bytes();
  const std::string bytes = head + "\1\2\3\4\5\6\7\10\11\12\13\14\15\16\17";
  const auto whole = test::read_all(folder.write("t.nc", bytes), {"c_q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames.at(2).real.at("c_q"), (std::vector<double>{11, 12, 13, 14, 15}));
  const auto cut = test::read_all(folder.write("t.nc", bytes.substr(0, head.size() + 14)), {"c_q"});
  EXPECT_EQ(cut.frames.size(), 2u);
  EXPECT_TRUE(cut.truncated);
}

TEST(AmberNetcdfCut, FramesThatTheHeaderDoesNotCountAreTold) {
  const test::TemporaryFolder folder;
  NetcdfBytes file = trajectory(2);
  file.records = 2;
  const auto whole = test::read_all(folder.write("t.nc", file.bytes()), wanted);
  EXPECT_EQ(whole.frames.size(), 2u);
  EXPECT_TRUE(whole.truncated);
  EXPECT_TRUE(contains(whole.error, "the header counts 2 frames, but 56 bytes follow"))
      << whole.error;
}

// Any one byte may be wrong: an answer or an InputError.
TEST(AmberNetcdfCut, AnyWrongByteIsSurvived) {
  const test::TemporaryFolder folder;
  for (const int version : {1, 5}) {
    const std::size_t data = trajectory(version).header({0, 0, 0, 0}).size() + 8;
    const std::string right = trajectory(version).bytes();
    const auto path = folder.write("wrong.nc", right);
    for (std::size_t byte = 0; byte < right.size(); ++byte)
      for (const int flip : {0x01, 0xc0}) {
        SCOPED_TRACE(byte);
        const OneByte wrong(path, byte, right[byte], flip);
        const auto read = test::read_all(path, wanted);
        EXPECT_LE(read.frames.size(), 3u);
        if (byte >= data && read.frames.size() < 3) {  // times may become infinite
          EXPECT_TRUE(contains(read.error, "the time is ")) << read.error;
        }
      }
  }
}

/// Memory held by this process at its greatest so far [bytes].
long greatest_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

TEST(AmberNetcdfLies, CostNoMemory) {
  const test::TemporaryFolder folder;
  const long before = greatest_memory();
  const auto error = [&](const NetcdfBytes& file) {
    const auto whole = test::read_all(folder.write("lie.nc", file.bytes()), wanted);
    EXPECT_EQ(whole.frames.size(), 0u);
    EXPECT_FALSE(whole.error.empty());
    return whole.error;
  };
  for (const std::uint64_t atoms : {std::uint64_t{1'000'000'000'000'000}, std::uint64_t{1} << 62}) {
    NetcdfBytes file = trajectory(5);
    file.axes[1].length = atoms;
    EXPECT_TRUE(contains(error(file), "ends within frame 0: "));
  }
  NetcdfBytes file = trajectory(1);
  file.axes[1].length = 2'000'000'000;
  EXPECT_TRUE(contains(error(file), "ends within frame 0: "));
  file = trajectory(5);
  file.axes[1].length = std::uint64_t{1} << 63;
  EXPECT_TRUE(contains(error(file), "the dimension atom is negative"));
  file = trajectory(5);
  file.axes[3].length = 1'000'000'000'000'000;
  EXPECT_TRUE(contains(error(file), "ends within frame 0: "));
  EXPECT_LT(greatest_memory() - before, 50'000'000);
}

TEST(AmberNetcdfLies, AboutFramesAreTold) {
  const test::TemporaryFolder folder;
  for (const int version : {1, 2, 5}) {
    NetcdfBytes file = trajectory(version);
    file.records = version == 5 ? ~std::uint64_t{0} : 0xffffffff;
    EXPECT_TRUE(
        contains(test::read_all(folder.write("t.nc", file.bytes()), wanted).error, "a stream"));
    file.records = 0x7ffffffe;
    const auto whole = test::read_all(folder.write("t.nc", file.bytes()), wanted);
    EXPECT_EQ(whole.frames.size(), 3u);
    EXPECT_TRUE(contains(whole.error, "the file ends within frame 3: ")) << whole.error;
    file.records = 0;
    EXPECT_TRUE(test::read_all(folder.write("t.nc", file.bytes()), wanted).truncated);
  }
  NetcdfBytes file;
  file.records = 1'000'000'000;
  EXPECT_TRUE(contains(test::read_all(folder.write("t.nc", file.bytes()), {}).error,
                       "the frames hold no numbers"));
}

TEST(AmberNetcdfLies, AboutTheHeaderAreTold) {
  const test::TemporaryFolder folder;
  const auto error = [&](const std::string& bytes) {
    return test::read_all(folder.write("t.nc", bytes), wanted).error;
  };
  std::string bytes = trajectory(1).bytes();
  bytes.replace(12, 4, Bytes::number(1'000'000'000, 4));
  EXPECT_TRUE(contains(error(bytes), "1000000000 dimensions (at most 8192)")) << error(bytes);
  bytes = trajectory(1).bytes();
  bytes.replace(16, 4, Bytes::number(2'000'000'000, 4));
  EXPECT_TRUE(contains(error(bytes), "a name in 2000000000 bytes")) << error(bytes);
  NetcdfBytes file = trajectory(1);
  file.axes[2].length = 0;
  EXPECT_TRUE(contains(error(file.bytes()), "two dimensions are unlimited"));
  file = trajectory(1);
  file.variables[1].axes = {1, 0, 2};
  EXPECT_TRUE(contains(error(file.bytes()), "the unlimited dimension is not a variable's first"));
  file = trajectory(1);
  file.variables[1].axes = {0, 1, 77};
  EXPECT_FALSE(error(file.header({0, 0, 0, 0})).empty());
  file = trajectory(1);
  EXPECT_TRUE(contains(error(file.header({0, 0, 0, 0})), "begins within the header"));
}

}  // namespace
}  // namespace mdana
