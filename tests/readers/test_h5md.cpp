// SPDX-License-Identifier: GPL-3.0-or-later
// H5MD files that mdana writes and reads again; files of others are in tests/oracles/test_h5md.py.
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "readers/hdf5.hpp"
#include "readers/trajectory.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::read_all;
using test::TemporaryFolder;

const Format& h5md() {
  for (const Format* format : formats())
    if (format->name == "h5md") return *format;
  throw std::logic_error("this build has no h5md");
}

const std::vector<std::string> columns{"id", "type", "x",  "y",  "z",       "ix",  "iy",
                                       "iz", "vx",   "vy", "vz", "c_pe[1]", "mol", "element"};

FrameHeader made_up_header(std::size_t atoms, int frame) {
  FrameHeader header;
  header.index = static_cast<std::uint64_t>(frame);
  header.step = 5'000'000'000 + 7 * frame;
  header.time = 0.1 * frame;
  header.units = Units::metal;
  header.atoms = atoms;
  header.box.origin = {-4, -2, 0.1 * frame};
  header.box.edges << 8, 2, -1, 0, 4 + 0.3 * frame, 1, 0, 0, 16;
  header.box.periodic = {true, false, true};
  header.columns = columns;
  header.place = "made up";
  return header;
}

/// Any bits that are a number, tiny and huge ones too.
double any_number(std::mt19937_64& random) {
  for (;;)
    if (const double value = std::bit_cast<double>(random()); std::isfinite(value)) return value;
}

AtomBlock made_up_block(std::uint64_t number, std::size_t atoms, std::uint64_t seed) {
  std::mt19937_64 random(seed * 1000 + number);
  AtomBlock block;
  block.reset(number, atoms);
  for (const std::string& name : columns) {
    const ColumnKind kind = kind_of_column(name);
    if (kind == ColumnKind::real)
      for (double& value : block.make_real(name)) value = any_number(random);
    if (kind == ColumnKind::integer)
      for (std::int64_t& value : block.make_integer(name))
        value = static_cast<std::int64_t>(random() >> 1);  // most are beyond 2^53
    if (kind == ColumnKind::text)
      for (std::string& value : block.make_text(name)) value = random() % 2 ? "Ag" : "He";
  }
  return block;
}

/// Writes frames of so many atoms each.
void write_frames(const std::filesystem::path& path, const std::vector<std::size_t>& atoms) {
  const auto writer = h5md().create(path);
  for (std::size_t frame = 0; frame < atoms.size(); ++frame) {
    writer->begin(made_up_header(atoms[frame], static_cast<int>(frame)));
    for (std::size_t first = 0; first < atoms[frame]; first += AtomBlock::capacity)
      writer->add(made_up_block(first / AtomBlock::capacity,
                                std::min(AtomBlock::capacity, atoms[frame] - first), frame));
  }
  writer->finish();
}

template <class T>
void expect_same_bits(std::span<const T> a, std::span<const T> b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i]))
        << what << " " << i;
}

void expect_same(const AtomBlock& a, const AtomBlock& b) {
  for (const std::string& name : columns) switch (kind_of_column(name)) {
      case ColumnKind::real: expect_same_bits(a.real(name), b.real(name), name); break;
      case ColumnKind::integer: expect_same_bits(a.integer(name), b.integer(name), name); break;
      case ColumnKind::text: EXPECT_TRUE(std::ranges::equal(a.text(name), b.text(name))) << name;
    }
}

void expect_header(const FrameHeader& found, const FrameHeader& wanted) {
  EXPECT_EQ(found.step, wanted.step);
  EXPECT_EQ(found.time, wanted.time);
  EXPECT_EQ(found.units, wanted.units);
  EXPECT_EQ(found.atoms, wanted.atoms);
  EXPECT_EQ(found.box.origin, wanted.box.origin);
  EXPECT_EQ(found.box.edges, wanted.box.edges);
  EXPECT_EQ(found.box.periodic, wanted.box.periodic);
  for (const std::string& name : wanted.columns) EXPECT_TRUE(found.has_column(name)) << name;
  EXPECT_EQ(found.columns.size(), wanted.columns.size());
}

// More than two blocks, fewer atoms, none, more than ever before.
TEST(H5md, WhatIsWrittenIsReadToTheLastBit) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.h5";
  const std::vector<std::size_t> atoms{2 * AtomBlock::capacity + 77, 1000, 0,
                                       3 * AtomBlock::capacity + 1};
  write_frames(path, atoms);
  const auto source = open_trajectory(path, ColumnSet::all_as_they_stand());
  FrameHeader header;
  Chunk chunk;
  AtomBlock block;
  for (std::size_t frame = 0; frame < atoms.size(); ++frame) {
    ASSERT_TRUE(source->next(header)) << frame;
    expect_header(header, made_up_header(atoms[frame], static_cast<int>(frame)));
    std::size_t seen = 0;
    while (source->cut(chunk)) {
      convert(chunk, block);
      expect_same(block, made_up_block(block.number(), block.atoms(), frame));
      seen += block.atoms();
    }
    EXPECT_EQ(seen, atoms[frame]);
  }
  EXPECT_FALSE(source->next(header));
}

TEST(H5md, CutsOfAnySizeAndSecondReadingsAreTheSame) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.h5";
  write_frames(path, {700, 300});
  const auto source = open_trajectory(path, ColumnSet::all_as_they_stand());
  FrameHeader header;
  ASSERT_TRUE(source->next(header));
  ASSERT_TRUE(source->next(header));  // its rows after the 300th have no atoms
  const AtomBlock wanted = made_up_block(0, 300, 1);
  for (const std::size_t most : {1, 7, 299, 300, 1000}) {
    source->restart_frame();
    AtomBlock whole, part;
    whole.reset(0, 300);
    Chunk chunk;
    for (std::size_t at = 0; source->cut(chunk, most); at += part.atoms()) {
      convert(chunk, part);
      whole.put(part, at);
    }
    expect_same(whole, wanted);
  }
}

TEST(H5md, SameFramesMakeTheSameBytes) {
  const TemporaryFolder folder;
  std::vector<std::string> hashes;
  for (const char* name : {"a.h5", "b.h5"}) {
    write_frames(folder.path() / name, {100, 90});
    hashes.push_back(open_trajectory(folder.path() / name, {})->records().front().hash);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(H5md, UnwrappedPositionsKeepTheirNames) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.h5";
  FrameHeader header = made_up_header(1, 0);
  header.columns = {"xu", "yu", "zu", "ix", "iy", "iz"};
  AtomBlock block;
  block.reset(0, 1);
  for (const char* name : {"xu", "yu", "zu"}) block.make_real(name)[0] = 20;
  for (const char* name : {"ix", "iy", "iz"}) block.make_integer(name)[0] = 2;
  const auto writer = h5md().create(path);
  writer->begin(header);
  writer->add(block);
  writer->finish();
  const auto whole = read_all(path, {"x", "y", "z"});
  ASSERT_EQ(whole.frames.size(), 1u) << whole.error;
  EXPECT_EQ(whole.frames[0].real.at("x")[0], 20);  // no images are added
  EXPECT_TRUE(whole.frames[0].header.has_column("xu"));
}

TEST(H5md, TellsWhatItCannotHold) {
  const TemporaryFolder folder;
  const auto refused = [&](std::vector<std::string> names, const char* says) {
    FrameHeader header = made_up_header(1, 0);
    header.columns = std::move(names);
    EXPECT_INPUT_ERROR(h5md().create(folder.path() / "a.h5")->begin(header), says);
  };
  refused({"id", "xs", "ys", "zs"}, "scaled");
  refused({"id", "type"}, "no positions");
  refused({"x", "y", "z", "a/b"}, "'a/b'");
  refused({"x", "y", "z", "box"}, "'box'");

  const auto second = [&](auto&& change, const char* says) {
    const auto writer = h5md().create(folder.path() / "a.h5");
    FrameHeader header = made_up_header(0, 0);
    header.columns = {"x", "y", "z"};
    writer->begin(header);
    change(header);
    EXPECT_INPUT_ERROR(writer->begin(header), says);
  };
  second([](FrameHeader& h) { h.atoms = 5; }, "column id");
  second([](FrameHeader& h) { h.time.reset(); }, "time");
  second([](FrameHeader& h) { h.units = Units::lj; }, "units");
  second([](FrameHeader& h) { h.box.periodic[1] = true; }, "periodic");
  second([](FrameHeader& h) { h.columns.pop_back(); }, "columns");
}

TEST(H5md, TellsWhatIsNotH5md) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.h5";
  hdf5::create_file(path).make_group("other");
  EXPECT_INPUT_ERROR(open_trajectory(path, {}), "H5MD");
  const auto broken = folder.write("b.h5", "\x89HDF\r\n\x1a\n and nothing else");
  EXPECT_INPUT_ERROR(open_trajectory(broken, {}), "b.h5", "cannot open");
}

TEST(H5md, CutFilesAreTruncatedInput) {
  const TemporaryFolder folder;
  write_frames(folder.path() / "a.h5", {1000, 1000});
  std::ifstream file(folder.path() / "a.h5", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (const std::size_t size : {bytes.size() / 4, bytes.size() / 2, bytes.size() - 1}) {
    const auto whole = read_all(folder.write("cut.h5", bytes.substr(0, size)), {"x", "y", "z"});
    EXPECT_TRUE(whole.truncated) << size << ": " << whole.error;
  }
}

// A frame whose step was not written, as after a writer that was killed.
TEST(H5md, AFrameWithoutItsStepIsNotWhole) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.h5";
  {
    const auto writer = h5md().create(path);
    for (const int frame : {0, 1}) {
      FrameHeader header = made_up_header(10, frame);
      writer->begin(header);
      writer->add(made_up_block(0, 10, 0));
    }
  }
  const auto whole = read_all(path, {"x", "y", "z"});
  EXPECT_EQ(whole.frames.size(), 1u);
  EXPECT_TRUE(whole.truncated) << whole.error;
}

}  // namespace
}  // namespace mdana
