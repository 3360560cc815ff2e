// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as large and as small as they come.
#include <gtest/gtest.h>

#include "analyses/force_curve.hpp"
#include "analyses/relative_motion.hpp"
#include "tests/contracts/catalogue.hpp"

namespace mdana {
namespace {

using test::made_up_collision;
using test::MadeUpAtom;
using test::MadeUpFrame;

template <class Change>
std::vector<MadeUpFrame> changed(std::vector<MadeUpFrame> frames, Change&& change) {
  for (MadeUpFrame& frame : frames)
    for (MadeUpAtom& atom : frame.atoms) change(atom);
  return frames;
}

// Nanoparticles in SI units: lengths 1e-9, masses 1e-26, times 1e-12, forces 1e-11.
TEST(Scales, NanoparticlesInSi) {
  const auto frames = made_up_collision(4, 200);
  const SweepResult plain = test::sweep_catalogue(frames);
  const SweepResult si = test::sweep_catalogue(changed(frames,
                                                       [](MadeUpAtom& a) {
                                                         a.x *= 1e-9;
                                                         a.mass *= 1e-26;
                                                         a.v *= 1e3;
                                                         a.f *= 1e-11;
                                                         a.pe *= 1e-20;
                                                       }),
                                               test::made_up_scene(1e-9));
  test::for_all_values(plain, si, [](const ColumnSpec& column, double a, double b) {
    const Dimension d = column.dimension;
    const double factor =
        std::pow(1e-26, d.mass) * std::pow(1e-9, d.length) * std::pow(1e-12, d.time);
    EXPECT_TRUE(test::agree(b / factor, a, 1e-12 * std::max(1.0, std::abs(a)))) << column.name;
  });
}

// All positions 1e7 radii away from the origin: they are known to 1e-9 of a radius, and so is all
// that is computed from them.
TEST(Scales, FarFromTheOrigin) {
  const auto frames = made_up_collision(4, 200);
  const Eigen::Vector3d offset(1e7, -1e7, 1e7);
  const SweepResult near = test::sweep_catalogue(frames);
  const SweepResult far =
      test::sweep_catalogue(changed(frames, [&](MadeUpAtom& a) { a.x += offset; }));
  const auto x = relative_motion(near.tables[0], near.steps, {}).distance();
  const auto y = relative_motion(far.tables[0], far.steps, {}).distance();
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-8);
  test::for_all_values(near, far, [](const ColumnSpec& column, double a, double b) {
    if (column.name.find_first_of("xyz") == std::string::npos) {
      EXPECT_TRUE(test::agree(a, b, 1e-8 * std::max(1.0, std::abs(a)))) << column.name;
    }
  });
}

TEST(Scales, FastDriftOfBothBodies) {
  const auto frames = made_up_collision(4, 200);
  const Eigen::Vector3d drift(1e7, 3e6, -1e7);
  const auto speed = [](const SweepResult& result) {
    return approach_speed(relative_motion(result.tables[0], result.steps, {}));
  };
  const auto rest = speed(test::sweep_catalogue(frames));
  const auto moving =
      speed(test::sweep_catalogue(changed(frames, [&](MadeUpAtom& a) { a.v += drift; })));
  for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_NEAR(rest[i], moving[i], 1e-8);
}

TEST(Scales, LargeIds) {
  const test::TemporaryFolder folder;
  auto frames = changed(made_up_collision(2, 200), [](MadeUpAtom& a) {
    a.id += 1'000'000'000'000;
    a.type = 1;
    a.mol = 1;
  });
  const auto dump = folder.write("dump", dump_text(frames));
  const Bodies bodies = find_bodies(dump, first_header(dump), "id:1000000000001-1000000000200");
  std::vector<int> atoms(3);
  for_first_frame(dump, bodies.columns(), [&](const AtomBlock& block) {
    std::vector<BodyIndex> body;
    bodies.label(block, body);
    for (const BodyIndex b : body) ++atoms.at(b);
  });
  EXPECT_EQ(atoms, (std::vector<int>{0, 200, 200}));
}

TEST(Scales, StepsBeyondTheWholeNumbersOfADouble) {
  auto frames = made_up_collision(3, 20);
  const std::int64_t first = (std::int64_t{1} << 53) + 1;
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].step = first + static_cast<std::int64_t>(i);
  const SweepResult result = test::sweep_catalogue(frames);
  EXPECT_EQ(result.steps, (std::vector<std::int64_t>{first, first + 1, first + 2}));
  EXPECT_EQ(relative_motion(result.tables[0], result.steps, {}).steps, result.steps);
}

}  // namespace
}  // namespace mdana
