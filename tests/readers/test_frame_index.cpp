// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include <gtest/gtest.h>

#include "readers/frame_index.hpp"
#include "tests/readers/binary_dump.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

constexpr std::uint64_t frames = 6;

/// Frame k has step 10 k and k + 1 atoms whose q is 100 k. A comment before it makes the
/// file longer than what is read to recognise its format.
std::string text_frame(std::uint64_t k) {
  const std::string comment = k == 0 ? "" : "# " + std::string(5000, '-') + "\n";
  std::string text = comment + "ITEM: TIMESTEP\n" + std::to_string(10 * k) + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(k + 1) +
                     "\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS id q\n";
  for (std::uint64_t i = 0; i <= k; ++i)
    text += std::to_string(i + 1) + " " + std::to_string(100 * k) + "\n";
  return text;
}

std::string text_dump() {
  std::string text;
  for (std::uint64_t k = 0; k < frames; ++k) text += text_frame(k);
  return text;
}

std::string binary_dump() {
  std::string bytes;
  for (std::uint64_t k = 0; k < frames; ++k) {
    test::BinaryFrame frame;
    frame.step = static_cast<std::int64_t>(10 * k);
    frame.columns = "id q";
    frame.ranks = {{}};
    for (std::uint64_t i = 0; i <= k; ++i)
      frame.ranks[0].insert(frame.ranks[0].end(),
                            {static_cast<double>(i + 1), static_cast<double>(100 * k)});
    bytes += frame.bytes(std::endian::little);
  }
  return bytes;
}

/// The true index of a text dump.
FrameIndex text_index() {
  FrameIndex index{{}, "xxh3:00ff"};
  std::uint64_t offset = 0, line = 0;
  for (std::uint64_t k = 0; k < frames; ++k) {
    index.frames.push_back({offset, line, static_cast<std::int64_t>(10 * k), k + 1});
    const std::string text = text_frame(k);
    offset += text.size();
    line += static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
  }
  return index;
}

/// Seeks to a frame and reads it; the numbers must be its own.
void expect_frame(FrameSource& source, std::uint64_t k) {
  source.seek(k);
  FrameHeader header;
  do ASSERT_TRUE(source.next(header));
  while (header.index < k);
  EXPECT_EQ(header.index, k);
  EXPECT_EQ(header.step, static_cast<std::int64_t>(10 * k));
  Chunk chunk;
  AtomBlock block;
  ASSERT_TRUE(source.cut(chunk));
  convert(chunk, block);
  ASSERT_EQ(block.atoms(), k + 1);
  for (const double q : block.real("q")) EXPECT_EQ(q, static_cast<double>(100 * k));
}

class Index : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(Index, IsReadBackAsItWasWritten) {
  const auto file = folder_.write("dump", text_dump());
  const FrameIndex index = text_index();
  ASSERT_TRUE(save_frame_index(index, file));
  const auto loaded = load_frame_index(file);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->hash, "xxh3:00ff");
  ASSERT_EQ(loaded->frames.size(), frames);
  for (std::size_t k = 0; k < frames; ++k) {
    EXPECT_EQ(loaded->frames[k].offset, index.frames[k].offset);
    EXPECT_EQ(loaded->frames[k].line, index.frames[k].line);
    EXPECT_EQ(loaded->frames[k].step, index.frames[k].step);
    EXPECT_EQ(loaded->frames[k].atoms, index.frames[k].atoms);
  }
}

TEST_F(Index, OfAnotherStateOfTheFileIsNotUsed) {
  const std::string text = text_dump();
  const auto file = folder_.write("dump", text);
  ASSERT_TRUE(save_frame_index(text_index(), file));
  const auto time = std::filesystem::last_write_time(file);
  std::string other = text;
  other[other.size() / 2] ^= 1;  // the same size and time
  folder_.write("dump", other);
  std::filesystem::last_write_time(file, time);
  EXPECT_FALSE(load_frame_index(file));
  folder_.write("dump", text);  // the same content at another time
  std::filesystem::last_write_time(file, time + std::chrono::seconds(1));
  EXPECT_FALSE(load_frame_index(file));
  std::filesystem::last_write_time(file, time);
  EXPECT_TRUE(load_frame_index(file));
}

TEST_F(Index, ThatIsDamagedAnywhereIsNotUsed) {
  const auto file = folder_.write("dump", text_dump());
  ASSERT_TRUE(save_frame_index(text_index(), file));
  const std::string name = frame_index_path(file).filename().string();
  std::ifstream stream(frame_index_path(file));
  const std::string good(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = bad[i] == '7' ? '8' : '7';
    folder_.write(name, bad);
    EXPECT_FALSE(load_frame_index(file)) << "byte " << i;
    folder_.write(name, good.substr(0, i));
    EXPECT_FALSE(load_frame_index(file)) << "cut at " << i;
  }
}

TEST_F(Index, SeeksGiveTheFramesThemselves) {
  const auto text = folder_.write("dump", text_dump());
  const auto binary = folder_.write("dump.bin", binary_dump());
  for (const bool with_index : {false, true}) {
    if (with_index) {
      ASSERT_TRUE(save_frame_index(text_index(), text));
    }
    for (const auto& file : {text, binary}) {
      const auto source = open_trajectory(file, {"id", "q"});
      for (const std::uint64_t k : {1, 2, 5}) expect_frame(*source, k);
      FrameHeader header;
      EXPECT_FALSE(source->next(header));
      const auto again = open_trajectory(file, {"id", "q"});
      again->seek(100);
      while (again->next(header)) EXPECT_LT(header.index, frames);
    }
  }
}

// The index has the file's own key, but tells the wrong places: the reader must not believe it.
TEST_F(Index, ThatLiesIsNotBelieved) {
  const auto file = folder_.write("dump", text_dump());
  FrameIndex wrong_place = text_index(), wrong_step = text_index();
  for (auto& frame : wrong_place.frames) frame.offset += 7;
  for (auto& frame : wrong_step.frames) frame.step += 10;
  for (const FrameIndex& index : {wrong_place, wrong_step}) {
    ASSERT_TRUE(save_frame_index(index, file));
    const auto source = open_trajectory(file, {"id", "q"});
    expect_frame(*source, 0);
    expect_frame(*source, 3);
    expect_frame(*source, 4);
  }
}

TEST_F(Index, GoesAheadWithoutReading) {
  const auto file = folder_.write("dump", text_dump());
  const FrameIndex index = text_index();
  ASSERT_TRUE(save_frame_index(index, file));
  std::string damaged = text_dump();  // in frame 1, which is passed over
  damaged.replace(index.frames[2].offset - 4, 3, "???");
  const auto time = std::filesystem::last_write_time(file);
  folder_.write("dump", damaged);
  std::filesystem::last_write_time(file, time);
  ASSERT_FALSE(load_frame_index(file));  // the change is seen here, in a small file
  ASSERT_TRUE(save_frame_index(index, file));
  const auto source = open_trajectory(file, {"id", "q"});
  expect_frame(*source, 4);
  EXPECT_EQ(source->records().at(0).hash, "xxh3:00ff");
}

TEST_F(Index, IsNotWrittenBesideSmallFiles) {
  const auto file = folder_.write("dump", text_dump());
  EXPECT_EQ(test::read_all(file, {"id", "q"}).frames.size(), frames);
  EXPECT_FALSE(std::filesystem::exists(frame_index_path(file)));
}

}  // namespace
}  // namespace mdana
