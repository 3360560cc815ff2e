// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "readers/byte_source.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

std::string rest_of(ByteSource& source, std::size_t step = 10'007) {
  std::string text, piece(step, '\0');
  while (const std::size_t got = source.read(piece)) text.append(piece, 0, got);
  return text;
}

/// Text that does not compress to nothing: several fillings of every buffer on the way.
std::string long_text() {
  std::mt19937_64 random(1);
  std::string text;
  while (text.size() < 3'000'000) text += std::to_string(random()) + "\n";
  return text;
}

class Gzip : public ::testing::Test {
 protected:
  std::unique_ptr<ByteSource> open(const std::string& bytes) {
    return open_bytes(folder_.write("data.gz", bytes));
  }
  test::TemporaryFolder folder_;
};

TEST_F(Gzip, GivesTheBytes) {
  const std::string text = long_text();
  for (const int level : {0, 1, 9}) {
    const auto source = open(test::gzipped(text, level));
    EXPECT_EQ(rest_of(*source), text);
    EXPECT_TRUE(source->damage().empty());
  }
}

TEST_F(Gzip, SeveralMembersAreOneText) {
  const std::string text = long_text();
  const auto source = open(test::gzipped(text) + test::gzipped("") + test::gzipped("end\n"));
  EXPECT_EQ(rest_of(*source), text + "end\n");
  EXPECT_TRUE(source->damage().empty()) << source->damage();
}

TEST_F(Gzip, PlainFileIsReadAsItIs) {
  const auto source = open("\x1fplain");
  EXPECT_EQ(rest_of(*source), "\x1fplain");
}

TEST_F(Gzip, TruncatedDataGiveABeginningAndSaySo) {
  const std::string text = long_text(), packed = test::gzipped(text);
  for (const std::size_t cut :
       {std::size_t{2}, std::size_t{9}, packed.size() / 3, packed.size() / 2, packed.size() - 9,
        packed.size() - 8, packed.size() - 1}) {
    const auto source = open(packed.substr(0, cut));
    const std::string got = rest_of(*source);
    EXPECT_EQ(got, text.substr(0, got.size())) << cut;
    EXPECT_TRUE(test::contains(source->damage(), "early")) << cut << " " << source->damage();
  }
}

TEST_F(Gzip, CutBetweenMembersIsACleanEnd) {
  const auto source = open(test::gzipped("one\n") + test::gzipped("two\n"));
  EXPECT_EQ(rest_of(*source), "one\ntwo\n");
  const auto shorter = open(test::gzipped("one\n"));
  EXPECT_EQ(rest_of(*shorter), "one\n");
  EXPECT_TRUE(shorter->damage().empty());
}

// Any flipped bit of the data or the checksum is noticed by the end of the text.
TEST_F(Gzip, CorruptDataSaySo) {
  const std::string packed = test::gzipped(long_text());
  for (const std::size_t at : {packed.size() / 4, packed.size() / 2, packed.size() - 6}) {
    std::string broken = packed;
    broken[at] = static_cast<char>(broken[at] ^ 0x10);
    const auto source = open(broken);
    rest_of(*source);
    EXPECT_TRUE(test::contains(source->damage(), "corrupt")) << at << " " << source->damage();
  }
}

TEST_F(Gzip, MarkAndResetInTheMiddle) {
  const std::string text = long_text();
  const std::string packed =
      test::gzipped(text.substr(0, 2'000'000)) + test::gzipped(text.substr(2'000'000));
  for (const std::size_t at : {std::size_t{0}, std::size_t{1}, std::size_t{777'777},
                               std::size_t{1'999'999}, std::size_t{2'000'000}, text.size()}) {
    const auto source = open(packed);
    std::string head(at, '\0');
    ASSERT_EQ(source->read(head), at);
    source->mark();
    for (int again = 0; again < 3; ++again) {
      std::string part(400'000, '\0');
      part.resize(source->read(part));
      EXPECT_EQ(part, text.substr(at, part.size())) << at;
      source->reset();
    }
    EXPECT_EQ(rest_of(*source), text.substr(at)) << at;
    source->reset();
    EXPECT_EQ(rest_of(*source), text.substr(at)) << at;
    EXPECT_TRUE(source->damage().empty());
  }
}

// The hash is that of the file's bytes, however much was read and how often.
TEST_F(Gzip, RecordIsOfTheWholeFile) {
  const std::string packed = test::gzipped(long_text());
  const auto untouched = open(packed)->record();
  const auto source = open(packed);
  source->mark();
  rest_of(*source);
  source->reset();
  std::string part(1000, '\0');
  source->read(part);
  EXPECT_EQ(source->record().hash, untouched.hash);
  EXPECT_EQ(untouched.size, packed.size());
  EXPECT_NE(open(packed + "x")->record().hash, untouched.hash);
}

// XXH3-128 of no bytes at all, as published with the reference implementation.
TEST_F(Gzip, HashOfNothing) {
  EXPECT_EQ(open("")->record().hash, "xxh3:99aa06d3014798d86001c324468d497f");
}

TEST_F(Gzip, WhatIsNoFileIsAnError) {
  EXPECT_INPUT_ERROR(open_bytes(folder_.path()), "not a file");
  EXPECT_INPUT_ERROR(open_bytes(folder_.path() / "missing"), "missing", "cannot open");
}

}  // namespace
}  // namespace mdana
