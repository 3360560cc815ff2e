// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "readers/gzip.hpp"
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

struct Library {
  const char* name;
  std::unique_ptr<Inflate> (*make)();
};

class Gzip : public ::testing::TestWithParam<Library> {
 protected:
  void SetUp() override {
    if (!GetParam().make()) GTEST_SKIP() << "built without " << GetParam().name;
  }
  std::unique_ptr<ByteSource> open(const std::string& bytes) {
    return open_gzip(std::make_unique<RawFile>(folder_.write("data.gz", bytes)), GetParam().make());
  }
  test::TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Libraries, Gzip,
                         ::testing::Values(Library{"zlib", make_zlib_inflate},
                                           Library{"isal", make_isal_inflate}),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(Gzip, GivesTheBytes) {
  const std::string text = long_text();
  for (const int level : {0, 1, 9}) {
    const auto source = open(test::gzipped(text, level));
    EXPECT_EQ(rest_of(*source), text);
    EXPECT_TRUE(source->damage().empty());
  }
}

TEST_P(Gzip, SeveralMembersAreOneText) {
  const std::string text = long_text();
  const auto source = open(test::gzipped(text) + test::gzipped("") + test::gzipped("end\n"));
  EXPECT_EQ(rest_of(*source), text + "end\n");
  EXPECT_TRUE(source->damage().empty()) << source->damage();
}

TEST(PlainFile, IsReadAsItIs) {
  const test::TemporaryFolder folder;
  const auto source = open_bytes(folder.write("data", "\x1fplain"));
  EXPECT_EQ(rest_of(*source), "\x1fplain");
}

// Members that begin and end around the fillings of the input buffer (2^18 bytes): headers,
// trailers and what the library holds back lie on both sides.
TEST_P(Gzip, MembersAcrossTheInputBuffer) {
  std::mt19937_64 random(2);
  std::string noise(1 << 18, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  for (std::size_t less = 80; less < 130; ++less) {
    const std::string first = noise.substr(less);
    const auto source = open(test::gzipped(first, 0) + test::gzipped("second\n") +
                             test::gzipped(noise) + test::gzipped("last\n"));
    EXPECT_EQ(rest_of(*source), first + "second\n" + noise + "last\n") << less;
    EXPECT_TRUE(source->damage().empty()) << less << " " << source->damage();
  }
}

TEST_P(Gzip, ManySmallMembers) {
  std::string packed, text;
  for (int k = 0; k < 10'000; ++k) {
    text += std::to_string(k * 7919) + "\n";
    packed += test::gzipped(std::to_string(k * 7919) + "\n");
  }
  const auto source = open(packed);
  EXPECT_EQ(rest_of(*source, 101), text);
  EXPECT_TRUE(source->damage().empty()) << source->damage();
}

/// A member with every optional field of RFC 1952: extra, name, comment and header checksum.
std::string with_all_fields(const std::string& member) {
  std::string header = member.substr(0, 10);
  header[3] = 2 | 4 | 8 | 16;
  header += std::string("\x03\0abc", 5) + std::string("name\0comment\0", 13);
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(header.data()),
                         static_cast<uInt>(header.size()));
  header += {static_cast<char>(sum), static_cast<char>(sum >> 8)};
  return header + member.substr(10);
}

TEST_P(Gzip, HeadersWithAllFields) {
  const std::string member = with_all_fields(test::gzipped("one\n"));
  const auto source = open(member + member);
  EXPECT_EQ(rest_of(*source), "one\none\n");
  EXPECT_TRUE(source->damage().empty()) << source->damage();
}

TEST_P(Gzip, ZeroBytesAtTheEndArePadding) {
  for (const std::size_t zeros : {1, 7, 8, 511, 300'000}) {
    const auto source = open(test::gzipped("one\n") + std::string(zeros, '\0'));
    EXPECT_EQ(rest_of(*source), "one\n");
    EXPECT_TRUE(source->damage().empty()) << zeros << " " << source->damage();
  }
}

TEST_P(Gzip, OtherBytesAtTheEndAreDamage) {
  const std::string tails[] = {"x", std::string("\0\0x", 3),
                               std::string(300'000, '\0') + "\x1f\x8b",
                               "ITEM: TIMESTEP\n", std::string("\x1fnothing like gzip")};
  for (const std::string& tail : tails) {
    const auto source = open(test::gzipped("one\n") + tail);
    EXPECT_EQ(rest_of(*source), "one\n");
    EXPECT_FALSE(source->damage().empty()) << tail.size();
  }
}

TEST_P(Gzip, AnyStepOfReadingGivesTheSame) {
  const std::string text = long_text().substr(0, 400'000), packed = test::gzipped(text);
  for (const std::size_t step : {1, 3, 255, 32'768, 32'769, 399'999, 400'000, 500'000})
    EXPECT_EQ(rest_of(*open(packed), step), text) << step;
}

TEST_P(Gzip, TruncatedDataGiveABeginningAndSaySo) {
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

TEST_P(Gzip, CutBetweenMembersIsACleanEnd) {
  const auto source = open(test::gzipped("one\n") + test::gzipped("two\n"));
  EXPECT_EQ(rest_of(*source), "one\ntwo\n");
  const auto shorter = open(test::gzipped("one\n"));
  EXPECT_EQ(rest_of(*shorter), "one\n");
  EXPECT_TRUE(shorter->damage().empty());
}

// Any flipped bit of the data or the checksum is noticed by the end of the text.
TEST_P(Gzip, CorruptDataSaySo) {
  const std::string packed = test::gzipped(long_text());
  for (const std::size_t at : {packed.size() / 4, packed.size() / 2, packed.size() - 6}) {
    std::string broken = packed;
    broken[at] = static_cast<char>(broken[at] ^ 0x10);
    const auto source = open(broken);
    rest_of(*source);
    EXPECT_TRUE(test::contains(source->damage(), "corrupt")) << at << " " << source->damage();
  }
}

/// A fuzzer's: of these bytes ISA-L counts more as taken than there are.
TEST_P(Gzip, DamageIsNotBehindTheEnd) {
  const std::filesystem::path seed = MDANA_SOURCE_DIR "/tests/fuzz/seeds/gzip/wrong_distance";
  const auto source = open_gzip(std::make_unique<RawFile>(seed), GetParam().make());
  rest_of(*source);
  const std::string damage = source->damage();
  const std::size_t number = damage.rfind("byte ");
  ASSERT_NE(number, std::string::npos) << damage;
  EXPECT_LE(std::stoull(damage.substr(number + 5)), std::filesystem::file_size(seed)) << damage;
}

TEST_P(Gzip, MarkAndResetInTheMiddle) {
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
TEST_P(Gzip, RecordIsOfTheWholeFile) {
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
TEST(PlainFile, HashOfNothing) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(open_bytes(folder.write("data", ""))->record().hash,
            "xxh3:99aa06d3014798d86001c324468d497f");
}

TEST(PlainFile, WhatIsNoFileIsAnError) {
  const test::TemporaryFolder folder;
  EXPECT_INPUT_ERROR(open_bytes(folder.path()), "not a file");
  EXPECT_INPUT_ERROR(open_bytes(folder.path() / "missing"), "missing", "cannot open");
}

}  // namespace
}  // namespace mdana
