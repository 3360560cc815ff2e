// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that every analysis of the list must obey.
#include <algorithm>
#include <bit>
#include <set>

#include <gtest/gtest.h>

#include "analyses/relative_motion.hpp"
#include "readers/input_error.hpp"
#include "tests/contracts/catalogue.hpp"

namespace mdana {
namespace {

using test::made_up_collision;
using test::MadeUpAtom;
using test::MadeUpFrame;

TEST(Catalogue, MadeUpCollisionsTouch) {
  const SweepResult result = test::sweep_catalogue(made_up_collision(4, 500));
  EXPECT_EQ(result.steps.size(), 4u);
  EXPECT_EQ(result.tables.size(), analysis_members().size());
  for (const Table& table : result.tables)
    if (table.has("contact_radius")) {
      EXPECT_GT(table.column("contact_radius")[3], 0);
    }
}

TEST(Catalogue, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const AnalysisMember* member : analysis_members()) {
    EXPECT_TRUE(names.insert(member->name).second) << member->name;
    EXPECT_FALSE(member->summary.empty()) << member->name;
  }
}

// Rounding of a sum of 1000 terms of order one, with room: 1e-12 of the largest term.
TEST(Catalogue, OrderOfAtomsInTheFileChangesNothing) {
  auto frames = made_up_collision(4, 500);
  const SweepResult plain = test::sweep_catalogue(frames);
  std::mt19937_64 random(9);
  for (MadeUpFrame& frame : frames) std::shuffle(frame.atoms.begin(), frame.atoms.end(), random);
  test::for_all_values(plain, test::sweep_catalogue(frames), [](auto& column, double a, double b) {
    EXPECT_TRUE(test::agree(a, b, 1e-12 * std::max(1.0, std::abs(a))))
        << column.name << " " << a << " " << b;
  });
}

TEST(Catalogue, OrderOfAtomsDoesNotLookLikeLostAtoms) {
  auto frames = made_up_collision(4, 500);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (MadeUpAtom& atom : frames[i].atoms) atom.mass = atom.mass == 1 ? 39.948 : 107.8682;
    std::mt19937_64 random(i);
    std::shuffle(frames[i].atoms.begin(), frames[i].atoms.end(), random);
  }
  const SweepResult result = test::sweep_catalogue(frames);
  EXPECT_NO_THROW(relative_motion(result.tables[0], result.steps, result.stated_times));
}

/// Another system of units in which all numbers are those times powers of two.
struct Factors {
  double mass, length, time;

  double of(const Dimension& d) const {
    return std::pow(mass, d.mass) * std::pow(length, d.length) * std::pow(time, d.time);
  }
  std::vector<MadeUpFrame> apply(std::vector<MadeUpFrame> frames) const {
    for (MadeUpFrame& frame : frames) {
      *frame.time *= time;
      for (MadeUpAtom& atom : frame.atoms) {
        atom.mass *= mass;
        atom.x *= length;
        atom.v *= length / time;
        atom.f *= mass * length / (time * time);
        atom.pe *= mass * length * length / (time * time);
      }
    }
    return frames;
  }
};

TEST(Catalogue, PowersOfTwoScaleEveryColumnExactly) {
  const auto frames = made_up_collision(4, 300);
  const SweepResult plain = test::sweep_catalogue(frames);
  for (const Factors f : {Factors{0x1p-85, 0x1p-30, 0x1p-40}, Factors{1, 0x1p+40, 1},
                          Factors{0x1p+20, 1, 1}, Factors{1, 1, 0x1p-20}}) {
    const SweepResult scaled =
        test::sweep_catalogue(f.apply(frames), test::made_up_scene(f.length));
    test::for_all_values(plain, scaled, [&](const ColumnSpec& column, double a, double b) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a * f.of(column.dimension)),
                std::bit_cast<std::uint64_t>(b))
          << column.name;
    });
    for (std::size_t i = 0; i < plain.stated_times.size(); ++i)
      EXPECT_EQ(plain.stated_times[i] * f.time, scaled.stated_times[i]);
  }
}

void expect_same_bits(const SweepResult& a, const SweepResult& b) {
  test::for_all_values(a, b, [](const ColumnSpec& column, double x, double y) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y)) << column.name;
  });
}

// Frames of more than one block; kept whole, kept in part, read twice, with moved last digits; those needed together
// whole or in slabs.
TEST(Catalogue, MemoryChangesNoBit) {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("dump", dump_text(made_up_collision(2, AtomBlock::capacity / 2 + 999)));
  for (const std::optional<std::uint64_t> seed : {std::optional<std::uint64_t>(), {7}}) {
    SweepOptions options;
    options.last_digit_seed = seed;
    const SweepResult plain = test::sweep_catalogue(path, test::made_up_scene(), options);
    ASSERT_EQ(plain.steps.size(), 2u);
    for (const std::size_t memory : {std::size_t{1}, std::size_t{3'000'000}}) {
      options.memory = memory;
      options.frame_memory = memory;
      expect_same_bits(plain, test::sweep_catalogue(path, test::made_up_scene(), options));
    }
  }
}

// House rule: the same bits on any number of threads, whether blocks are kept or read twice.
TEST(Catalogue, ThreadsChangeNoBit) {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("dump", dump_text(made_up_collision(2, 5 * AtomBlock::capacity + 77)));
  const SweepResult plain = test::sweep_catalogue(path, test::made_up_scene());
  ASSERT_EQ(plain.steps.size(), 2u);
  for (const std::size_t threads : {2, 3, 7}) {
    for (const std::size_t memory : {std::size_t{1}, std::size_t{1} << 30}) {
      SweepOptions options;
      options.threads = threads;
      options.memory = memory;
      expect_same_bits(plain, test::sweep_catalogue(path, test::made_up_scene(), options));
    }
  }
}

// Many small frames, between them large ones; whole, and cut or broken at some place.
TEST(Catalogue, ThreadsShareSmallFramesAndChangeNoBit) {
  const test::TemporaryFolder folder;
  auto frames = made_up_collision(40, 30);
  const auto large = made_up_collision(40, AtomBlock::capacity / 2 + 9);
  for (const std::size_t k : {7, 8, 30}) frames[k].atoms = large[k].atoms;
  const std::string text = dump_text(frames);
  std::string broken = text;
  broken.replace(broken.find(" -", broken.find("\n3500\n") + 400), 2, " ?");
  for (const std::string& content : {text, text.substr(0, text.size() - 700), broken}) {
    const auto path = folder.write("dump", content);
    const SweepResult plain = test::sweep_catalogue(path, test::made_up_scene());
    EXPECT_EQ(plain.damage.empty(), content == text);
    EXPECT_GE(plain.steps.size(), 35u);
    for (const std::size_t threads : {2, 3, 7}) {
      SweepOptions options;
      options.threads = threads;
      const SweepResult other = test::sweep_catalogue(path, test::made_up_scene(), options);
      EXPECT_EQ(other.steps, plain.steps);
      EXPECT_EQ(other.damage, plain.damage);
      expect_same_bits(plain, other);
    }
  }
}

// Whatever the threads, the first wrong line of the file is the one that is told.
TEST(Catalogue, ThreadsTellTheFirstWrongLine) {
  const test::TemporaryFolder folder;
  std::string text = dump_text(made_up_collision(1, 3 * AtomBlock::capacity));
  for (const std::size_t part : {2, 4, 5}) {  // of 6: in three different blocks
    const std::size_t line = text.find('\n', text.size() / 6 * part) + 1;
    text.replace(line, text.find('\n', line) - line, "broken");
  }
  const auto path = folder.write("dump", text);
  std::vector<std::string> told;
  for (const std::size_t threads : {1, 2, 7}) {
    SweepOptions options;
    options.threads = threads;
    try {
      test::sweep_catalogue(path, test::made_up_scene(), options);
    } catch (const InputError& error) {
      told.emplace_back(error.what());
    }
  }
  ASSERT_EQ(told.size(), 3u);
  EXPECT_EQ(told[1], told[0]);
  EXPECT_EQ(told[2], told[0]);
}

// The same atoms in one block and spread over several by atoms of no body between them.
TEST(Catalogue, BlocksChangeNothingBeyondRounding) {
  auto frames = made_up_collision(3, 400);
  frames.erase(frames.begin());  // bodies overlap from the first frame on
  const SweepResult plain = test::sweep_catalogue(frames);
  for (MadeUpFrame& frame : frames) {
    std::vector<MadeUpAtom> spread;
    for (const MadeUpAtom& atom : frame.atoms) {
      spread.push_back(atom);
      MadeUpAtom other = atom;  // far away, in no body
      other.x *= 100;
      other.type = 300;
      spread.insert(spread.end(), 100, other);
    }
    frame.atoms = spread;
  }
  test::for_all_values(plain, test::sweep_catalogue(frames), [](auto& column, double a, double b) {
    if (column.name == "atoms_none") return;
    EXPECT_TRUE(test::agree(a, b, 1e-12 * std::max(1.0, std::abs(a))))
        << column.name << " " << a << " " << b;
  });
}

}  // namespace
}  // namespace mdana
