// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef MDANA_WITH_ZSTD
#include "readers/zstd.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"
#include "tests/readers/zstd_packed.hpp"

namespace mdana {
namespace {

std::string rest_of(ByteSource& source, std::size_t step = 10'007) {
  std::string text, piece(step, '\0');
  while (const std::size_t got = source.read(piece)) text.append(piece, 0, got);
  return text;
}

std::string long_text() {
  std::mt19937_64 random(1);
  std::string text;
  while (text.size() < 3'000'000) text += std::to_string(random()) + "\n";
  return text;
}

class Zstd : public ::testing::Test {
 protected:
  std::unique_ptr<ByteSource> open(const std::string& bytes) {
    return open_bytes(folder_.write("data.zst", bytes));
  }
  test::TemporaryFolder folder_;
};

TEST_F(Zstd, GivesTheBytes) {
  const std::string long_one = long_text();
  for (const int level : {-5, 1, 3, 19}) {
    const std::string text = long_one.substr(0, level == 19 ? 200'000 : long_one.size());
    const auto source = open(test::zstd_packed(text, level));
    EXPECT_EQ(rest_of(*source), text);
    EXPECT_EQ(source->damage(), "");
  }
}

TEST_F(Zstd, AnyStepOfReadingGivesTheSame) {
  const std::string text = long_text().substr(0, 400'000), packed = test::zstd_packed(text);
  for (const std::size_t step : {1, 3, 255, 131'072, 131'073, 399'999, 400'000, 500'000})
    EXPECT_EQ(rest_of(*open(packed), step), text) << step;
}

TEST_F(Zstd, SeveralFramesAndSkippableOnesAreOneText) {
  const std::string text = long_text();
  const auto source =
      open(test::zstd_skippable("index") + test::zstd_packed(text) + test::zstd_packed("") +
           test::zstd_skippable("") + test::zstd_packed("end\n") + test::zstd_skippable("more"));
  EXPECT_EQ(rest_of(*source), text + "end\n");
  EXPECT_EQ(source->damage(), "");
}

TEST_F(Zstd, TruncatedDataGiveABeginningAndSaySo) {
  const std::string text = long_text(), packed = test::zstd_packed(text);
  for (const std::size_t cut : {std::size_t{4}, std::size_t{5}, packed.size() / 3,
                                packed.size() / 2, packed.size() - 5, packed.size() - 1}) {
    const auto source = open(packed.substr(0, cut));
    const std::string got = rest_of(*source);
    EXPECT_EQ(got, text.substr(0, got.size())) << cut;
    EXPECT_TRUE(test::contains(source->damage(), "early")) << cut << " " << source->damage();
  }
}

TEST_F(Zstd, CorruptDataAndOtherBytesAtTheEndSaySo) {
  const std::string packed = test::zstd_packed(long_text());
  for (const std::size_t at : {packed.size() / 4, packed.size() / 2, packed.size() - 2}) {
    std::string broken = packed;
    broken[at] = static_cast<char>(broken[at] ^ 0x10);
    const auto source = open(broken);
    rest_of(*source);
    EXPECT_TRUE(test::contains(source->damage(), "corrupt")) << at << " " << source->damage();
  }
  const auto source = open(test::zstd_packed("one\n") + "and more");
  EXPECT_EQ(rest_of(*source), "one\n");
  EXPECT_TRUE(test::contains(source->damage(), "corrupt")) << source->damage();
}

TEST_F(Zstd, MarkAndResetInTheMiddle) {
  const std::string text = long_text();
  const std::string packed = test::zstd_packed(text.substr(0, 1'000'000)) +
                             test::zstd_packed(text.substr(1'000'000, 1'000'000)) +
                             test::zstd_packed(text.substr(2'000'000));
  for (const std::size_t at :
       {std::size_t{0}, std::size_t{1}, std::size_t{777'777}, std::size_t{1'999'999},
        std::size_t{2'000'000}, std::size_t{2'500'000}, text.size()}) {
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
    EXPECT_EQ(source->damage(), "");
  }
}

// As a sweep in two rounds does it, with some frames that are read once or passed over.
TEST_F(Zstd, MarksAndResetsOneAfterAnother) {
  const std::string text = long_text();
  for (const std::string& packed :
       {test::zstd_packed(text),
        test::zstd_packed(text.substr(0, 700'001)) + test::zstd_packed(text.substr(700'001))}) {
    const auto source = open(packed);
    std::string part(100'000, '\0');
    for (std::size_t at = 0; at + part.size() <= text.size(); at += part.size()) {
      source->mark();
      for (std::size_t round = 0; round < 1 + at / part.size() % 4; ++round) {
        if (round > 0) source->reset();
        ASSERT_EQ(source->read(part), part.size());
        EXPECT_EQ(part, text.substr(at, part.size())) << at << " " << round;
      }
    }
  }
}

TEST_F(Zstd, RecordIsOfTheWholeFile) {
  const std::string packed = test::zstd_packed(long_text());
  const auto untouched = open(packed)->record();
  const auto source = open(packed);
  source->mark();
  rest_of(*source);
  source->reset();
  std::string part(1000, '\0');
  source->read(part);
  EXPECT_EQ(source->record().hash, untouched.hash);
  EXPECT_EQ(untouched.size, packed.size());
}

const std::string frame =
    "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
    "ITEM: ATOMS id q\n3 0.5\n";

TEST_F(Zstd, DumpsAreRead) {
  const auto path = folder_.write("dump.zst", test::zstd_packed(frame + frame));
  const auto whole = test::read_all(path, {"id", "q"});
  EXPECT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 2u);
  EXPECT_EQ(whole.frames[1].real.at("q"), std::vector<double>{0.5});
}

TEST_F(Zstd, ACutDumpIsTruncated) {
  const std::string packed = test::zstd_packed(frame + frame);
  const auto path = folder_.write("dump.zst", packed.substr(0, packed.size() - 2));
  const auto whole = test::read_all(path, {"q"});
  EXPECT_TRUE(whole.truncated);
  EXPECT_TRUE(test::contains(whole.error, "zstd")) << whole.error;
}

}  // namespace
}  // namespace mdana
#endif
