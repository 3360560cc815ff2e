// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "analyses/motion.hpp"
#include "analyses/relative_motion.hpp"
#include "tests/contracts/catalogue.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::made_up_collision;
using Steps = std::vector<std::int64_t>;

class SweepOfDump : public ::testing::Test {
 protected:
  SweepResult run(const std::string& text, const SweepOptions& options = {}) {
    return test::sweep_catalogue(folder_.write("dump", text), test::made_up_scene(), options);
  }
  std::string whole(std::size_t frames) { return dump_text(made_up_collision(frames, 20)); }
  test::TemporaryFolder folder_;
};

TEST_F(SweepOfDump, GivesARowAFrame) {
  const SweepResult result = run(whole(5));
  EXPECT_EQ(result.steps, (Steps{0, 100, 200, 300, 400}));
  EXPECT_EQ(result.stated_times, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  for (const Table& table : result.tables) EXPECT_EQ(table.rows(), 5u);
  EXPECT_TRUE(result.damage.empty());
  EXPECT_FALSE(result.unwrapped);
  EXPECT_TRUE(result.inputs.at(0).hash.starts_with("xxh3:"));
}

TEST_F(SweepOfDump, StrideTakesEveryNthFromTheFirst) {
  SweepOptions options;
  options.choice.stride = 3;
  const SweepResult some = run(whole(8), options), all = run(whole(8));
  EXPECT_EQ(some.steps, (Steps{0, 300, 600}));
  EXPECT_EQ(some.tables[0].column("x1")[2], all.tables[0].column("x1")[6]);
  EXPECT_EQ(some.inputs.at(0).hash, all.inputs.at(0).hash);
}

TEST_F(SweepOfDump, TheChoiceIsAWindow) {
  SweepOptions options;
  options.choice = {2, 7, 2};
  const SweepResult some = run(whole(9), options), all = run(whole(9));
  EXPECT_EQ(some.steps, (Steps{200, 400, 600}));
  EXPECT_EQ(some.tables[0].column("x1")[1], all.tables[0].column("x1")[4]);
  EXPECT_EQ(some.inputs.at(0).hash, all.inputs.at(0).hash);
  options.choice = {9, {}, 1};
  EXPECT_INPUT_ERROR(run(whole(9), options), "none chosen");
}

TEST_F(SweepOfDump, SelectedAtomsAreAsIfThereWereNoOthers) {
  auto frames = made_up_collision(3, 20), other = frames;
  for (auto& frame : other)
    for (int k = 0; k < 10; ++k) {
      test::MadeUpAtom atom = frame.atoms[static_cast<std::size_t>(k)];
      atom.id += 1000;
      frame.atoms.insert(frame.atoms.begin() + 3 * k, atom);
    }
  SweepOptions options;
  options.selection = Selection("id:1-40");
  const SweepResult plain = run(dump_text(frames)), selected = run(dump_text(other), options);
  test::for_all_values(plain, selected, [](const ColumnSpec& column, double a, double b) {
    EXPECT_TRUE(test::agree(a, b, 0)) << column.name << " " << a << " " << b;
  });
}

TEST_F(SweepOfDump, StrictMakesDamageAnError) {
  SweepOptions options;
  options.strict = true;
  const std::string text = whole(3);
  EXPECT_EQ(run(text, options).steps.size(), 3u);
  EXPECT_INPUT_ERROR(run(text.substr(0, text.size() - 20), options), "dump", "the file ends");
}

TEST_F(SweepOfDump, FramesLimitTheRows) {
  SweepOptions options;
  options.frames = 2;
  EXPECT_EQ(run(whole(5), options).steps, (Steps{0, 100}));
  options.choice.stride = 2;
  EXPECT_EQ(run(whole(5), options).steps, (Steps{0, 200}));
  options.frames = 100;
  EXPECT_EQ(run(whole(5), options).steps, (Steps{0, 200, 400}));
}

TEST_F(SweepOfDump, FramesBeforeTheDamageAreKept) {
  const std::string text = whole(4);
  const std::size_t third = text.find("\n200\n");
  std::string wrong = text;
  wrong.replace(wrong.find(" -", third + 200), 2, " ?");
  const struct {
    std::string text, what;
  } cases[] = {
      {text.substr(0, third + 500), "file ends"},
      {wrong, "is not a number"},
      {text.substr(0, third) + "\n100" + text.substr(third + 4), "does not come after"},
  };
  const SweepResult whole_result = run(text);
  for (const auto& c : cases) {
    const SweepResult result = run(c.text);
    EXPECT_EQ(result.steps, (Steps{0, 100})) << c.what;
    EXPECT_TRUE(test::contains(result.damage, c.what)) << result.damage;
    for (std::size_t k = 0; k < result.tables.size(); ++k)
      for (std::size_t i = 0; i < result.tables[k].columns().size(); ++i) {
        ASSERT_EQ(result.tables[k].column(i).size(), 2u);
        EXPECT_TRUE(test::agree(result.tables[k].column(i)[1], whole_result.tables[k].column(i)[1], 0));
      }
  }
}

TEST_F(SweepOfDump, DamageInTheFirstFrameIsAnError) {
  const std::string text = whole(1);
  EXPECT_INPUT_ERROR(run(text.substr(0, text.size() - 20)), "dump", "the file ends");
}

TEST_F(SweepOfDump, BodyWithoutAtomsIsNamed) {
  auto frames = made_up_collision(2, 20);
  for (auto& atom : frames[1].atoms) atom.type = 1;
  const SweepResult result = run(dump_text(frames));
  EXPECT_EQ(result.steps, (Steps{0}));
  EXPECT_TRUE(test::contains(result.damage, "body 2 has no atoms")) << result.damage;
}

TEST_F(SweepOfDump, TimesAreStatedByAllFramesOrNone) {
  auto frames = made_up_collision(3, 20);
  frames[2].time.reset();
  EXPECT_TRUE(test::contains(run(dump_text(frames)).damage, "some frames state their time"));
  frames[0].time.reset();
  EXPECT_TRUE(test::contains(run(dump_text(frames)).damage, "some frames state their time"));
  frames[1].time.reset();
  EXPECT_TRUE(run(dump_text(frames)).damage.empty());
}

TEST_F(SweepOfDump, StopsAtASignal) {
  const std::atomic<int> signal = 15;
  SweepOptions options;
  options.stop = &signal;
  try {
    run(whole(2), options);
    ADD_FAILURE() << "not interrupted";
  } catch (const Interrupted& interrupted) {
    EXPECT_EQ(interrupted.signal, 15);
  }
}

TEST_F(SweepOfDump, TellsItsProgress) {
  std::vector<std::uint64_t> seen;
  SweepOptions options;
  options.progress = [&](const Progress& progress) { seen.push_back(progress.frames); };
  run(whole(3), options);
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST_F(SweepOfDump, KnowsThatPositionsMayJump) {
  std::string text = whole(2);
  text.replace(text.rfind("ff ff ff"), 8, "ff pp ff");
  EXPECT_TRUE(run(text).unwrapped);
}

/// Motion of a made-up dump of 17 digits, the last ones moved or not.
SweepResult motion_of(const std::filesystem::path& dump, const Masses& masses,
                      std::optional<std::uint64_t> seed) {
  SweepOptions options;
  options.last_digit_seed = seed;
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion({}));
  return sweep(dump, find_bodies(dump, first_header(dump), "type"), masses, analyses, options);
}

// Positions in steps of 2^-10 are printed with ten decimals; half a unit of the last is 5e-11.
TEST_F(SweepOfDump, MovedLastDigitsMoveTheResultsALittle) {
  auto frames = made_up_collision(2, 20);
  for (auto& frame : frames)
    for (auto& atom : frame.atoms) atom.x = (atom.x * 1024).array().round() / 1024;
  const auto dump = folder_.write("dump", dump_text(frames));
  const double plain = motion_of(dump, Masses::uniform(""), {}).tables[0].column("x1")[0];
  const double moved = motion_of(dump, Masses::uniform(""), 1).tables[0].column("x1")[0];
  EXPECT_NE(plain, moved);
  EXPECT_NEAR(plain, moved, 5e-11);
}

TEST_F(SweepOfDump, MovedLastDigitsLeaveTheMasses) {
  const auto dump = folder_.write("dump", whole(2));
  const SweepResult moved = motion_of(dump, Masses::from_column(""), 1);
  const SweepResult plain = motion_of(dump, Masses::from_column(""), {});
  EXPECT_EQ(moved.tables[0].column("mass1")[0], plain.tables[0].column("mass1")[0]);
  EXPECT_NO_THROW(relative_motion(moved.tables[0], moved.steps, {}));
}

/// Notes which atoms it is shown, and the order in which its products are given on.
class Witness final : public FrameAnalysis {
 public:
  explicit Witness(std::vector<std::int64_t>& given) : given_(given) {}
  Needs needs() const override { return {{"id", "x", "y", "z"}, false, /*whole_frame=*/true}; }
  std::vector<ColumnSpec> columns() const override {
    return {{"atoms", dimension::none}, {"sorted", dimension::none}};
  }
  std::size_t bytes_an_atom() const override { return 1; }
  std::unique_ptr<Product> look(const FrameHeader& header, const FrameStore& frame, std::size_t,
                                std::span<double> row) const override {
    std::vector<std::int64_t> ids;
    frame.for_blocks([&](const FrameAtoms& atoms, std::size_t first) {
      if (first == ids.size()) ids.insert(ids.end(), atoms.id.begin(), atoms.id.end());
    });
    row[0] = static_cast<double>(ids.size());
    row[1] = std::is_sorted(ids.begin(), ids.end());
    return std::make_unique<Note>(header.step, given_);
  }
  void give_sent(const std::function<std::string()>&) const override {}

 private:
  struct Note final : Product {
    Note(std::int64_t of_step, std::vector<std::int64_t>& to) : step(of_step), given(to) {}
    void give() override { given.push_back(step); }
    void send(const std::function<void(const std::string&)>&) override {}
    std::int64_t step;
    std::vector<std::int64_t>& given;
  };
  std::vector<std::int64_t>& given_;
};

class SweepOfWholeFrames : public SweepOfDump {
 protected:
  SweepResult watch(const std::string& text, std::size_t threads, bool after_motion = false,
                    std::optional<std::size_t> memory = {}) {
    const auto dump = folder_.write("dump", text);
    std::vector<std::unique_ptr<Analysis>> analyses;
    if (after_motion) analyses = test::whole_catalogue({test::made_up_scene(), first_header(dump)});
    analyses.push_back(std::make_unique<Witness>(given_));
    SweepOptions options;
    options.threads = threads;
    options.frame_memory = memory;
    given_.clear();
    return sweep(dump, find_bodies(dump, first_header(dump), "type"), Masses::from_column("the dump"),
                 analyses, options);
  }
  std::vector<std::int64_t> given_;
};

TEST_F(SweepOfWholeFrames, SeeAllAtomsSortedAndGiveInOrder) {
  for (const std::size_t bodies : {std::size_t{20}, AtomBlock::capacity}) {
    auto frames = made_up_collision(bodies == 20 ? 9 : 2, bodies);
    std::mt19937_64 random(2);
    for (auto& frame : frames) std::shuffle(frame.atoms.begin(), frame.atoms.end(), random);
    for (const std::size_t threads : {1, 3})
      for (const auto& [after_motion, memory] :
           {std::pair(false, std::optional<std::size_t>()), {true, {}}, {false, 1}, {true, 1000}}) {
        const SweepResult result = watch(dump_text(frames), threads, after_motion, memory);
        EXPECT_EQ(given_, result.steps);
        EXPECT_EQ(result.steps.size(), frames.size());
        for (std::size_t k = 0; k < frames.size(); ++k) {
          EXPECT_EQ(result.tables.back().column("atoms")[k], 2.0 * static_cast<double>(bodies));
          EXPECT_EQ(result.tables.back().column("sorted")[k], 1);
        }
      }
  }
}

// A frame that is dropped because of what follows it has no product either.
TEST_F(SweepOfWholeFrames, DamagedFramesGiveNothing) {
  auto frames = made_up_collision(4, 20);
  frames[2].atoms.pop_back();
  const std::string text = dump_text(frames);
  for (const std::size_t threads : {1, 3}) {
    EXPECT_EQ(watch(text, threads).steps.size(), 4u);
    const std::size_t last = text.rfind("ITEM: TIMESTEP");
    const SweepResult cut = watch(text.substr(0, last) + "nonsense" + text.substr(last), threads);
    EXPECT_FALSE(cut.damage.empty());
    EXPECT_EQ(cut.steps, (Steps{0, 100}));
    EXPECT_EQ(given_, cut.steps);
  }
}

}  // namespace
}  // namespace mdana
