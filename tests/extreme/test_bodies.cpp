// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies without atoms, of one atom, of atoms at one place.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "analyses/force_curve.hpp"
#include "readers/clusters.hpp"
#include "tests/contracts/catalogue.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::MadeUpAtom;
using test::MadeUpFrame;

MadeUpAtom atom(std::int64_t id, int type, const Eigen::Vector3d& x) {
  MadeUpAtom made;
  made.id = id;
  made.type = type;
  made.x = x;
  return made;
}

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

TEST(ExtremeBodies, OneAtomEach) {
  MadeUpFrame frame{0, {}, {atom(1, 1, {0, 0, 0}), atom(2, 2, {0, 0, 3})}};
  frame.atoms[0].v = {0, 0, 0.5};
  frame.atoms[1].f = {0, 0, -2};
  const SweepResult result = test::sweep_catalogue({frame});
  const RelativeMotion motion = relative_motion(result.tables[0], result.steps, {});
  EXPECT_EQ(motion.distance()[0], 3);
  EXPECT_EQ(approach_speed(motion)[0], 0.5);
  EXPECT_EQ(interparticle_force(motion, ForceSource::forces, Units::lj)[0], -1);
  for (const Table& table : result.tables)
    for (const char* radius : {"radius1", "radius2", "contact_radius"})
      if (table.has(radius)) {
        EXPECT_EQ(table.column(radius)[0], 0) << radius;
      }
}

TEST(ExtremeBodies, AllAtomsOfABodyAtOnePlace) {
  MadeUpFrame frame;
  for (int i = 0; i < 10; ++i) {
    frame.atoms.push_back(atom(2 * i, 1, {0.1, 0.2, 0.3}));
    frame.atoms.push_back(atom(2 * i + 1, 2, {0.1, 0.2, 0.4}));
  }
  const test::TemporaryFolder folder;
  const auto dump = folder.write("dump", test::dump_text({frame}));
  const auto of_neighbours = [](const auto& analysis) { return test::is_of_grains(analysis) || analysis->needs().whole_frame; };
  const auto swept = [&](auto&& left_out) {
    const FrameHeader first = first_header(dump);
    const Scene scene = test::made_up_scene();
    auto analyses = test::whole_catalogue({scene, first});
    std::erase_if(analyses, left_out);
    return sweep(dump, find_bodies(dump, first, "type"), Masses::from_column("the dump"), analyses);
  };
  const SweepResult result = swept(of_neighbours);
  test::for_all_values(result, result, [](auto& column, double a, double) {
    EXPECT_TRUE(std::isfinite(a)) << column.name;
  });
  EXPECT_INPUT_ERROR(swept([](const auto& a) { return a->needs().whole_frame; }), "two grains coincide at 0.1 0.2 0.3");
  EXPECT_INPUT_ERROR(swept(test::is_of_grains), "ids 0 and 2 are at the same place");
}

TEST(ExtremeBodies, WithoutAtomsAreNamed) {
  const std::vector<MadeUpAtom> one{atom(1, 1, {0, 0, 0}), atom(2, 1, {1, 0, 0})};
  EXPECT_INPUT_ERROR(test::sweep_catalogue({MadeUpFrame{7, {}, one}}), "body 2 has no atoms",
                     "frame 0, step 7");
  EXPECT_INPUT_ERROR(test::sweep_catalogue({MadeUpFrame{7, {}, {}}}), "without atoms", "step 7");
}

TEST(ExtremeBodies, WhoseCentresCoincideAreNamed) {
  MadeUpFrame frame;
  for (const double side : {-1.0, 1.0}) {
    frame.atoms.push_back(atom(1, 1, {side, 0, 0}));
    frame.atoms.push_back(atom(2, 2, {0, side, 0}));
  }
  EXPECT_INPUT_ERROR(test::sweep_catalogue({frame}), "centres coincide", "frame 0");
}

TEST(ExtremeBodies, NotFinitePositionsVelocitiesForcesAreNamed) {
  auto plain = test::made_up_collision(2, 20);
  for (const double bad : {nan, infinity, -infinity})
    for (const auto part : {&MadeUpAtom::x, &MadeUpAtom::v, &MadeUpAtom::f}) {
      auto frames = plain;
      (frames[1].atoms[5].*part)[1] = bad;
      const SweepResult result = test::sweep_catalogue(frames);
      EXPECT_EQ(result.steps.size(), 1u);
      EXPECT_TRUE(test::contains(result.damage, "is not finite")) << result.damage;
      EXPECT_TRUE(test::contains(result.damage, "frame 1, step 100")) << result.damage;
    }
}

// Atoms of no body do not count, whatever they are.
TEST(ExtremeBodies, NotFiniteAtomsOfNoBodyDoNoHarm) {
  const test::TemporaryFolder folder;
  auto frames = test::made_up_collision(1, 20);
  frames[0].atoms.push_back(atom(1000, 3, {nan, infinity, 0}));
  const auto dump = folder.write("dump", dump_text(frames));
  const FrameHeader first = first_header(dump);
  const Scene scene = test::made_up_scene();
  const Bodies bodies("type", {{1, 1, 1}, {2, 2, 2}}, "");
  const auto analyses = test::whole_catalogue({scene, first});
  const SweepResult result = sweep(dump, bodies, Masses::from_column(""), analyses);
  EXPECT_TRUE(result.damage.empty()) << result.damage;
  EXPECT_EQ(result.tables[0].column("atoms_none")[0], 1);
}

TEST(ExtremeBodies, MassesThatAreNoneAreNamed) {
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    auto frames = test::made_up_collision(1, 20);
    frames[0].atoms[3].mass = bad;
    EXPECT_INPUT_ERROR(test::sweep_catalogue(frames), "is not positive and finite");
  }
}

TEST(ExtremeBodies, WrongMassesSayWhere) {
  auto frames = test::made_up_collision(1, 20);
  frames[0].atoms[3].mass = -1;
  EXPECT_INPUT_ERROR(test::sweep_catalogue(frames), "dump", "frame 0");
}

// Pairs of atoms on top of each other do not make the nearest neighbour nought.
TEST(ExtremeBodies, ClustersOfCoincidentAtoms) {
  Eigen::Matrix3Xd points(3, 16);
  for (int i = 0; i < 16; ++i) points.col(i) << (i / 2 < 4 ? 0 : 20) + i / 2 % 4, 0, 0;
  const Clusters clusters = find_clusters(points);
  EXPECT_EQ(clusters.sizes, (std::vector<std::size_t>{8, 8}));
  EXPECT_DOUBLE_EQ(clusters.link_distance, 1.5);
}

}  // namespace
}  // namespace mdana
