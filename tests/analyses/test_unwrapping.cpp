// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that cross periodic faces in dumps without image flags.
#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analyses/motion.hpp"
#include "analyses/sweep.hpp"
#include "readers/trajectory.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

constexpr double radius = 1.5;

/// A box, orthogonal or tilted, and two rigid balls that fly through its faces.
struct Flight {
  explicit Flight(bool in_tilted_box = false, double spacing = 0.4) : tilted(in_tilted_box) {
    const int n = static_cast<int>(radius / spacing) + 1;
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j)
        for (int k = -n; k <= n; ++k) {
          const Eigen::Vector3d p = spacing * Eigen::Vector3d(i, j, k);
          if (p.norm() <= radius) ball.push_back(p + Eigen::Vector3d(0, 0, 0.01 * i));
        }
    atoms = ball.size();
  }

  bool tilted;
  std::vector<Eigen::Vector3d> ball;
  std::size_t atoms;  ///< a body

  Eigen::Matrix3d edges() const {
    Eigen::Matrix3d m = Eigen::Vector3d(10, 9, 8).asDiagonal();
    if (tilted) m.col(1).x() = 3, m.col(2).x() = -2, m.col(2).y() = 1;
    return m;
  }

  /// True centre of a body: 2 to 4 boxes away in the end; body 2 stays a fixed way off body 1.
  Eigen::Vector3d centre(int body, int frame) const {
    const Eigen::Vector3d start(9, 1, 4), step(1.3, -0.9, 0.4);
    return start + frame * step + (body == 2 ? Eigen::Vector3d(3.1 - 0.02 * frame, 0.2, 0.5)
                                              : Eigen::Vector3d::Zero());
  }

  Eigen::Vector3d wrapped(const Eigen::Vector3d& p) const {
    Eigen::Vector3d s = edges().inverse() * p;
    for (double& c : s) c -= std::floor(c);
    return edges() * s;
  }

  std::string frame(int k) const {
    const Eigen::Matrix3d e = edges();
    std::string text = fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", k, 2 * atoms);
    if (tilted)
      text += fmt::format("ITEM: BOX BOUNDS xy xz yz pp pp pp\n{} {} 3\n0 {} -2\n0 8 1\n", -2.0,
                          13.0, 10.0);
    else
      text += fmt::format("ITEM: BOX BOUNDS pp pp pp\n0 {}\n0 {}\n0 {}\n", e(0, 0), e(1, 1), e(2, 2));
    text += "ITEM: ATOMS id type x y z\n";
    for (const int body : {1, 2})
      for (std::size_t i = 0; i < atoms; ++i) {
        const Eigen::Vector3d p = wrapped(centre(body, k) + ball[i]);
        text += fmt::format("{} {} {} {} {}\n", i + 1 + (body == 2 ? atoms : 0), body, p.x(), p.y(),
                            p.z());
      }
    return text;
  }

  std::string dump(int frames) const {
    std::string text;
    for (int k = 0; k < frames; ++k) text += frame(k);
    return text;
  }

  Eigen::Vector3d mean() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& p : ball) sum += p;
    return sum / static_cast<double>(ball.size());
  }
};

SweepResult motion_of(const std::string& text, const std::string& bodies,
                      const SweepOptions& options = {}) {
  const test::TemporaryFolder folder;
  const auto dump = folder.write("dump", text);
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion({}));
  return sweep(dump, find_bodies(dump, first_header(dump), bodies), Masses::uniform(""), analyses,
               options);
}

Eigen::Vector3d centre_of(const SweepResult& result, int body, std::size_t row) {
  return body_motion(result.tables[0], row)[static_cast<std::size_t>(body - 1)].position;
}

// Positions are of order 100 at most: rounding of sums of 200 of them stays below 1e-12.
TEST(Unwrapping, FollowsBodiesThroughTheFacesOfTheBox) {
  for (const bool tilted : {false, true})
    for (const char* bodies : {"type", "clusters"}) {
      const Flight flight(tilted);
      const SweepResult result = motion_of(flight.dump(30), bodies);
      EXPECT_TRUE(result.unwrapped);
      EXPECT_EQ(result.uncertain_images, 0u);
      const Eigen::Vector3d away = centre_of(result, 1, 0) - flight.centre(1, 0) - flight.mean();
      const Eigen::Vector3d images = flight.edges().inverse() * away;
      EXPECT_LT((images - images.array().round().matrix()).norm(), 1e-12);  // whole boxes off at most
      for (std::size_t k = 0; k < 30; ++k)
        for (const int body : {1, 2}) {
          const Eigen::Vector3d expected =
              flight.centre(body, static_cast<int>(k)) + flight.mean() + away;
          EXPECT_LT((centre_of(result, body, k) - expected).norm(), 1e-11)
              << bodies << " frame " << k << " body " << body;
        }
    }
}

TEST(Unwrapping, IsTheSameOnAnyThreadsAndMemory) {
  const Flight flight(false, 0.09);
  ASSERT_GT(2 * flight.atoms, AtomBlock::capacity);
  const std::string text = flight.dump(3);
  const SweepResult plain = motion_of(text, "type");
  for (const std::size_t threads : {1, 3})
    for (const std::size_t memory : {std::size_t{1}, std::size_t{1} << 30}) {
      SweepOptions options;
      options.threads = threads;
      options.memory = memory;
      const SweepResult other = motion_of(text, "type", options);
      for (const char* name : {"x1", "y1", "z2"})
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_EQ(plain.tables[0].column(name)[k], other.tables[0].column(name)[k]);
    }
}

TEST(Unwrapping, BodiesThatDoNotReachTheFacesStayToTheBit) {
  const std::string middle = R"(ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
4
ITEM: BOX BOUNDS pp pp pp
-5 5
-5 5
-5 5
ITEM: ATOMS id type x y z
1 1 -1.1 0.3 0.7
2 1 -1.3 0.1 0.2
3 2 1.1 -0.3 0.7
4 2 1.7 -0.1 0.9
)";
  std::string free = middle;
  free.replace(free.find("pp pp pp"), 8, "ff ff ff");
  const SweepResult a = motion_of(middle, "type"), b = motion_of(free, "type");
  EXPECT_TRUE(a.unwrapped);
  EXPECT_FALSE(b.unwrapped);
  for (const int body : {1, 2}) EXPECT_EQ(centre_of(a, body, 0), centre_of(b, body, 0));
}

TEST(Unwrapping, SaysWhichImagesAreUncertain) {
  const std::string text = R"(ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
5
ITEM: BOX BOUNDS pp ff ff
0 10
0 10
0 10
ITEM: ATOMS id type x y z
1 1 2 1 1
2 1 2 2 1
3 1 2 1 2
4 1 7.1 1 1
5 2 4 9 9
)";
  EXPECT_EQ(motion_of(text, "type").uncertain_images, 1u);
}

}  // namespace
}  // namespace mdana
