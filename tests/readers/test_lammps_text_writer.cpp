// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

const Format& text_format() {
  for (const Format* format : formats())
    if (format->name == "lammps_text") return *format;
  throw std::runtime_error("this build does not have lammps_text");
}

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

FrameHeader header(std::vector<std::string> columns, std::uint64_t atoms, std::int64_t step = 0) {
  FrameHeader h;
  h.step = step;
  h.atoms = atoms;
  h.columns = std::move(columns);
  h.place = "made up";
  return h;
}

/// Random bits are doubles of all sizes, and some denormals, infinities and NaN among them.
std::vector<double> values() {
  using limits = std::numeric_limits<double>;
  std::vector<double> all{0.0, -0.0, 1.0, -1.0, 0.1, 0.2 + 0.1, 1.0 / 3, 1e15, 1e16, 1e17, 1e22,
                          123456789012345678.0, 5e-324, -5e-324, limits::min(),
                          std::nextafter(limits::min(), 0.0), limits::max(), limits::lowest(),
                          limits::infinity(), -limits::infinity(), limits::quiet_NaN(),
                          9007199254740993.0, 0x1p-1022, 2.2250738585072011e-308, 1e23};
  std::mt19937_64 random(11);
  for (int i = 0; i < 100'000; ++i) {
    all.push_back(std::bit_cast<double>(random()));
    all.push_back(std::ldexp(static_cast<double>(random()), -64));
    all.push_back(std::bit_cast<double>(random() & 0x000fffffffffffff));  // denormals
    all.push_back(std::round(1e6 * static_cast<double>(random() % 1000)) / 1e6);
  }
  return all;
}

class TextWriter : public ::testing::Test {
 protected:
  /// Writes one frame of values of one real column, in blocks.
  std::filesystem::path write(const std::string& name, const std::vector<double>& q) {
    const auto path = folder_.path() / name;
    const auto writer = text_format().create(path);
    writer->begin(header({"q"}, q.size()));
    for (std::size_t first = 0; first < q.size(); first += AtomBlock::capacity) {
      AtomBlock block;
      block.reset(first / AtomBlock::capacity, std::min(AtomBlock::capacity, q.size() - first));
      std::copy_n(q.begin() + static_cast<long>(first), block.atoms(), block.make_real("q").begin());
      writer->add(block);
    }
    writer->finish();
    return path;
  }

  std::string written_header(const FrameHeader& h) {
    const auto path = folder_.path() / "header.dump";
    const auto writer = text_format().create(path);
    writer->begin(h);
    writer->finish();
    return content(path);
  }

  Box written_box(const Box& box) {
    FrameHeader h = header({"q"}, 0);
    h.box = box;
    written_header(h);
    return first_header(folder_.path() / "header.dump").box;
  }

  test::TemporaryFolder folder_;
};

TEST_F(TextWriter, RealNumbersComeBackToTheBit) {
  const std::vector<double> q = values();
  for (const char* name : {"plain.dump", "packed.dump.gz"}) {
    const auto whole = test::read_all(write(name, q), {"q"});
    ASSERT_EQ(whole.error, "");
    const auto& read = whole.frames.at(0).real.at("q");
    ASSERT_EQ(read.size(), q.size());
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (std::isnan(q[i]))
        ASSERT_TRUE(std::isnan(read[i]));
      else
        ASSERT_EQ(std::bit_cast<std::uint64_t>(read[i]), std::bit_cast<std::uint64_t>(q[i])) << q[i];
    }
  }
}

TEST_F(TextWriter, NumbersAreShort) {
  const std::string text = content(write("short.dump", {1, -38.4, 0.1, 1000000, 1e300, -0.0}));
  EXPECT_TRUE(text.ends_with("ITEM: ATOMS q\n1\n-38.4\n0.1\n1000000\n1e+300\n-0\n")) << text;
}

TEST_F(TextWriter, CompressedByTheName) {
  const std::vector<double> q = values();
  const std::string plain = content(write("q.dump", q)), gzip = content(write("q.dump.gz", q));
  EXPECT_TRUE(plain.starts_with("ITEM: TIMESTEP\n"));
  EXPECT_TRUE(gzip.starts_with("\x1f\x8b"));
  EXPECT_LT(gzip.size(), plain.size());
  const auto bytes = open_bytes(folder_.path() / "q.dump.gz");
  std::string unpacked(plain.size() + 1, '\0');
  unpacked.resize(bytes->read(unpacked));
  EXPECT_TRUE(unpacked == plain);
  EXPECT_EQ(bytes->damage(), "");
}

#ifdef MDANA_WITH_ZSTD
TEST_F(TextWriter, CompressedByZstd) {
  const std::vector<double> q = values();
  const std::string plain = content(write("q.dump", q));
  EXPECT_TRUE(content(write("q.dump.zst", q)).starts_with("\x28\xb5\x2f\xfd"));
  const auto bytes = open_bytes(folder_.path() / "q.dump.zst");
  std::string unpacked(plain.size() + 1, '\0');
  unpacked.resize(bytes->read(unpacked));
  EXPECT_TRUE(unpacked == plain);
  EXPECT_EQ(bytes->damage(), "");
}
#else
TEST_F(TextWriter, WithoutZstdItIsRefused) {
  EXPECT_THROW(text_format().create(folder_.path() / "q.dump.zst"), std::runtime_error);
}
#endif

TEST_F(TextWriter, WholeNumbersAndWords) {
  using limits = std::numeric_limits<std::int64_t>;
  const auto path = folder_.path() / "words.dump";
  const auto writer = text_format().create(path);
  writer->begin(header({"element", "id", "typelabel"}, 3));
  AtomBlock block;
  block.reset(0, 3);
  const std::int64_t ids[] = {limits::min(), limits::max(), 0};
  const std::string elements[] = {"Ar", "H2O#\xc3\xa9", "nan"};
  std::ranges::copy(ids, block.make_integer("id").begin());
  std::ranges::copy(elements, block.make_text("element").begin());
  std::ranges::copy(elements, block.make_text("typelabel").begin());
  writer->add(block);
  writer->finish();
  std::vector<std::int64_t> read_ids;
  std::vector<std::string> read_elements;
  for_first_frame(path, {"id", "element"}, [&](const AtomBlock& b) {
    read_ids.assign(b.integer("id").begin(), b.integer("id").end());
    read_elements.assign(b.text("element").begin(), b.text("element").end());
  });
  EXPECT_TRUE(std::ranges::equal(read_ids, ids));
  EXPECT_TRUE(std::ranges::equal(read_elements, elements));
}

TEST_F(TextWriter, HeaderAsLammpsWritesIt) {
  FrameHeader first = header({"id", "x"}, 0, 5'000'000'000), second = first;
  first.units = second.units = Units::metal;
  first.time = 0.1;
  second.columns = {"q"};
  first.box.edges = Eigen::Vector3d(76.8, 50, 50).asDiagonal();
  first.box.origin = {-38.4, -25, 0.125};
  first.box.periodic = {true, false, true};
  second.box = first.box;
  const auto path = folder_.path() / "two.dump";
  const auto writer = text_format().create(path);
  writer->begin(first);
  writer->begin(second);
  writer->finish();
  const std::string rest =
      "ITEM: TIMESTEP\n5000000000\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS pp ff pp\n-38.4 38.4\n"
      "-25 25\n0.125 50.125\n";
  EXPECT_EQ(content(path), "ITEM: UNITS\nmetal\nITEM: TIME\n0.1\n" + rest + "ITEM: ATOMS id x\n" +
                               rest + "ITEM: ATOMS q\n");
}

// With the bounds that a dump stated, and without them: from the edges alone.
TEST_F(TextWriter, BoundsOfADumpComeBackAsTheSameBox) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> side(-1, 1);
  for (int i = 0; i < 3000; ++i) {
    const double scale = std::pow(10, 12 * side(random));
    const auto number = [&] { return i % 2 ? side(random) * scale : std::round(1e3 * side(random)); };
    Eigen::Vector3d lo(number(), number(), number() * 1e-3), hi;
    for (int k = 0; k < 3; ++k) hi[k] = std::max(number() * 1e3, std::nextafter(lo[k], 1e300));
    const bool tilts = i % 3;
    const double xy = tilts ? 0.3 * number() : 0, xz = tilts ? -0.2 * number() : 0, yz = 0.1 * xy;
    Box box = box_from_bounds(lo, hi, xy, xz, yz);
    if (!(box.edges.diagonal().minCoeff() > 0)) continue;
    const Box again = written_box(box);
    EXPECT_EQ(again.stated->lo, lo) << i;
    EXPECT_EQ(again.stated->hi, hi) << i;
    box.stated.reset();
    const Box read = written_box(box);
    EXPECT_EQ(read.origin, box.origin) << i;
    EXPECT_EQ(read.edges, box.edges) << i;
  }
}

TEST_F(TextWriter, BoundsOfAnotherBoxAreNotWritten) {
  Box box = box_from_bounds({0, 0, 0}, {1, 2, 3}, 0, 0, 0);
  box.edges(1, 1) = 2.5;
  EXPECT_EQ(written_box(box).edges, box.edges);
}

TEST_F(TextWriter, GeneralBoxesComeBack) {
  Box box;
  box.origin = {0.1, -1e-9, 3};
  box.edges << 1.1, 0.2, 0.3, 0.4, -2.5, 0.7, -0.1, 0.8, 1.0 / 3;
  box.periodic = {false, true, false};
  FrameHeader h = header({"q"}, 0);
  h.box = box;
  EXPECT_TRUE(test::contains(written_header(h), "ITEM: BOX BOUNDS abc origin ff pp ff\n1.1 0.4 -0.1 0.1\n"));
  const Box read = written_box(box);
  EXPECT_EQ(read.origin, box.origin);
  EXPECT_EQ(read.edges, box.edges);
  EXPECT_EQ(read.periodic, box.periodic);
}

TEST_F(TextWriter, ATiltedBoxStatesTheBoundsOfItsCorners) {
  FrameHeader h = header({"q"}, 0);
  h.box.origin = {-4, -2, 0};
  h.box.edges << 8, 2, -1, 0, 4, 1, 0, 0, 16;
  EXPECT_TRUE(test::contains(written_header(h),
                             "ITEM: BOX BOUNDS xy xz yz ff ff ff\n-5 6 2\n-2 3 -1\n0 16 1\n"));
}

TEST_F(TextWriter, WhatATextDumpCannotHoldIsRefused) {
  const auto writer = text_format().create(folder_.path() / "bad.dump");
  EXPECT_INPUT_ERROR(writer->begin(header({}, 0)), "no columns", "made up");
  EXPECT_INPUT_ERROR(writer->begin(header({"a b"}, 0)), "'a b'", "made up");
  FrameHeader flat = header({"q"}, 0);
  flat.box.edges.col(2) = flat.box.edges.col(1);
  EXPECT_INPUT_ERROR(writer->begin(flat), "no volume", "made up");
  flat.box.edges(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_INPUT_ERROR(writer->begin(flat), "not finite", "made up");
  writer->begin(header({"element"}, 1));
  AtomBlock block;
  block.reset(0, 1);
  block.make_text("element")[0] = "A r";
  EXPECT_INPUT_ERROR(writer->add(block), "'A r'", "made up");
}

TEST_F(TextWriter, FramesMustHaveTheAtomsOfTheirHeader) {
  AtomBlock block;
  block.reset(0, 2);
  block.make_real("q")[1] = 1;
  const auto writer = text_format().create(folder_.path() / "bad.dump");
  writer->begin(header({"q"}, 1));
  EXPECT_THROW(writer->add(block), std::logic_error);
  EXPECT_THROW(writer->finish(), std::logic_error);
}

TEST_F(TextWriter, AFullDiskIsTold) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  for (const char* name : {"full", "full.gz"}) {
    const auto link = folder_.path() / name;
    std::filesystem::create_symlink("/dev/full", link);
    const auto writer = text_format().create(link);
    writer->begin(header({"q"}, 0));
    try {
      writer->finish();
      FAIL() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(test::contains(error.what(), link.string())) << error.what();
      EXPECT_TRUE(test::contains(error.what(), "No space left")) << error.what();
    }
  }
  EXPECT_THROW(text_format().create(folder_.path() / "missing" / "x.dump"), std::runtime_error);
}

}  // namespace
}  // namespace mdana
