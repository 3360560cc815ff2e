// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of grains: hand-made networks, all pairs one by one, grains that cannot be.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "analyses/contact_network.hpp"
#include "analyses/local_filling.hpp"
#include "analyses/motion.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Pull-off at -R*/4; the force does not matter here.
const GrainLaw law{[](double overlap, double reduced) { return reduced * overlap; },
                   [](double reduced) { return -0.25 * reduced; }};

Grain grain(double x, double y, double z, double radius, BodyIndex body = 1, std::int64_t id = 0) {
  return {{x, y, z}, radius, body, id};
}

/// Random grains of radii 0.1 to 0.4 in a cube of edge `side`.
std::vector<Grain> heap(std::size_t count, double side, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Grain> grains;
  for (std::size_t i = 0; i < count; ++i)
    grains.push_back({side * Eigen::Vector3d(part(random), part(random), part(random)),
                      0.1 + 0.3 * part(random), static_cast<BodyIndex>(1 + i % 2),
                      static_cast<std::int64_t>(i)});
  return grains;
}

/// A column of the network of grains; the bodies' centres are at x = 0 and x = 10.
double column(const std::vector<Grain>& grains, const ContactNetworkSettings& settings,
              std::string_view name) {
  AtomBlock block;
  block.reset(0, grains.size());
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  const auto radius = block.make_real("radius");
  const auto id = block.make_integer("id");
  std::vector<BodyIndex> body;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    x[i] = grains[i].position.x();
    y[i] = grains[i].position.y();
    z[i] = grains[i].position.z();
    radius[i] = grains[i].radius;
    id[i] = grains[i].id;
    body.push_back(grains[i].body);
  }
  const std::vector<double> mass(grains.size(), 1.0);
  std::array<BodyMotion, 2> motion;
  motion[1].position = {10, 0, 0};
  const auto analysis = make_contact_network(settings);
  const FrameHeader header;
  const auto partial = analysis->begin({header, motion});
  partial->add({block, body, mass});
  const auto columns = analysis->columns();
  std::vector<double> row(columns.size());
  partial->close(row);
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == name) return row[k];
  ADD_FAILURE() << "no column " << name;
  return nan;
}

ContactNetworkSettings settings() {
  ContactNetworkSettings all;
  all.radius = {5, 5};
  return all;
}

bool has_column(const ContactNetworkSettings& settings, std::string_view name) {
  const auto columns = make_contact_network(settings)->columns();
  return std::ranges::find(columns, name, &ColumnSpec::name) != columns.end();
}

TEST(GrainContacts, AreThoseOfAllPairs) {
  const auto grains = heap(400, 3, 1);
  const auto found = find_contacts(grains, law);
  std::size_t k = 0;
  for (std::uint32_t a = 0; a < grains.size(); ++a)
    for (std::uint32_t b = a + 1; b < grains.size(); ++b) {
      const Eigen::Vector3d apart = grains[b].position - grains[a].position;
      const double overlap = grains[a].radius + grains[b].radius - apart.norm();
      if (overlap < 0 && overlap <= -0.25 * reduced_radius(grains[a], grains[b])) continue;
      ASSERT_LT(k, found.size());
      EXPECT_EQ(found[k].a, a);
      EXPECT_EQ(found[k].b, b);
      EXPECT_NEAR(found[k].overlap, overlap, 1e-15);
      EXPECT_LE((found[k].normal - apart.normalized()).norm(), 1e-14);
      ++k;
    }
  EXPECT_EQ(k, found.size());
  EXPECT_GT(k, 500u);
}

TEST(GrainContacts, PolydisperseGrainsHoldByTheirReducedRadius) {
  // r = 1 and 3: R* = 3/4, pull-off at -3/16.
  EXPECT_NEAR(reduced_radius(grain(0, 0, 0, 1), grain(0, 0, 0, 3)), 0.75, 1e-16);
  for (const auto& [distance, there] : {std::pair(4.0, 1u), {4.18, 1u}, {4.19, 0u}, {3.5, 1u}})
    EXPECT_EQ(find_contacts(std::vector{grain(0, 0, 0, 1), grain(0, distance, 0, 3)}, law).size(),
              there)
        << distance;
  EXPECT_EQ(find_contacts(std::vector{grain(0, 0, 0, 1), grain(0, 4, 0, 3)}).size(), 1u);
  EXPECT_EQ(find_contacts(std::vector{grain(0, 0, 0, 1), grain(0, 4.01, 0, 3)}).size(), 0u);
}

TEST(GrainContacts, GrainsThatCannotBeAreRefused) {
  const Grain good = grain(0, 0, 0, 1);
  EXPECT_INPUT_ERROR(find_contacts(std::vector{good, grain(1, 2, 3, -1)}), "1 2 3", "radius", "-1");
  EXPECT_INPUT_ERROR(find_contacts(std::vector{good, grain(1, 2, 3, 0)}), "radius");
  EXPECT_INPUT_ERROR(find_contacts(std::vector{good, grain(1, 2, 3, nan)}), "radius");
  EXPECT_INPUT_ERROR(find_contacts(std::vector{good, grain(1, 2, 3, INFINITY)}), "radius");
  EXPECT_INPUT_ERROR(find_contacts(std::vector{good, grain(nan, 2, 3, 1)}), "not a place");
  EXPECT_INPUT_ERROR(find_contacts(std::vector{good, good}), "coincide", "0 0 0");
  auto crowd = heap(400, 3, 1);
  const std::size_t before = find_contacts(crowd).size();
  crowd.push_back(grain(1, 1, 1, 1e300));
  EXPECT_EQ(find_contacts(crowd).size(), before + 400);  // it holds all others
  for (Grain& g : crowd) g.radius = 1e300;
  EXPECT_INPUT_ERROR(find_contacts(crowd), "contacts a grain", "same unit", "1e+300");
  EXPECT_TRUE(find_contacts({}).empty());
}

// Empty space between grains costs nothing.
TEST(GrainContacts, FarGrainsCostNothing) {
  auto grains = heap(400, 3, 1);
  const std::size_t near = find_contacts(grains).size();
  grains.push_back(grain(1e15, -1e15, 1e12, 0.1));
  EXPECT_EQ(find_contacts(grains).size(), near);
}

// A million grains at the corners of a cube: 3 n^2 (n - 1) contacts. Pairs one by one would take
// hours.
TEST(GrainContacts, MillionGrains) {
  constexpr int n = 100;
  std::vector<Grain> grains;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) grains.push_back(grain(i, j, k, 0.5));
  EXPECT_EQ(find_contacts(grains).size(), 3u * n * n * (n - 1));
}

TEST(ContactNetwork, ComparesWithTheReference) {
  // A chain 1-2-3-4 before; then 3 has let go of 2 and holds 1, and 4 is gone.
  auto reference = std::make_shared<ReferenceNetwork>();
  reference->ids = {1, 2, 3, 4};
  reference->touching = {{1, 2}, {2, 3}, {3, 4}};
  auto set = settings();
  set.reference = reference;
  const std::vector<Grain> now{grain(-1, 0, 0, 0.5, 1, 3), grain(0, 0, 0, 0.5, 1, 1),
                               grain(1, 0, 0, 0.5, 2, 2)};
  EXPECT_EQ(column(now, set, "made"), 1);
  EXPECT_EQ(column(now, set, "broken"), 1);
  EXPECT_EQ(column(now, set, "lost_contacts"), 1);
  EXPECT_FALSE(has_column(settings(), "made"));
  EXPECT_TRUE(has_column(set, "made"));
}

// A list decides about pairs that are apart, and its forces come first.
TEST(ContactNetwork, ListedContacts) {
  auto set = settings();
  set.law = law;
  const LocalFrame list{0, {{1, 2, -3}, {2, 3, 0}, {7, 8, 5}}};
  set.listed = [&](std::int64_t) { return &list; };
  const std::vector<Grain> grains{grain(0, 0, 0, 0.5, 1, 2), grain(1.02, 0, 0, 0.5, 1, 1),
                                  grain(-0.5, 0, 0, 0.5, 2, 3), grain(0, 1.03, 0, 0.5, 2, 4)};
  EXPECT_EQ(column(grains, set, "contacts"), 2);
  EXPECT_EQ(column(grains, set, "undecided"), 1);
  EXPECT_EQ(column(grains, set, "listed"), 1);
  EXPECT_EQ(column(grains, set, "unmatched"), 1);
  EXPECT_EQ(column(grains, set, "force_min"), -3);
  EXPECT_NEAR(column(grains, set, "force_max"), 0.125, 1e-15);  // by the law: overlap 1/2, R* = 1/4
}

TEST(ContactNetwork, ForcesBelowTheNoiseAreNeither) {
  auto set = settings();
  set.law = law;
  set.force_noise = 0.01;
  set.strong_force = 0.1;
  // R* = 1/4: forces 0.0025, 0.025 and 0.125.
  const std::vector<Grain> grains{grain(0, 0, 0, 0.5), grain(0.99, 0, 0, 0.5),
                                  grain(1.89, 0, 0, 0.5), grain(2.39, 0, 0, 0.5, 2)};
  EXPECT_EQ(column(grains, set, "contacts"), 3);
  EXPECT_EQ(column(grains, set, "compression"), 2);
  EXPECT_EQ(column(grains, set, "tension"), 0);
  EXPECT_EQ(column(grains, set, "strong_compression"), 1);
  EXPECT_NEAR(column(grains, set, "force12"), 0.125, 1e-15);
  EXPECT_FALSE(has_column(settings(), "tension"));
}

TEST(ContactNetwork, WhatDoesNotDependOnAxesTurnsWithTheFrame) {
  const auto grains = heap(300, 2.5, 5);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.8, 0.5, 0.1).normalized();
  auto turned = grains;
  for (Grain& g : turned) g.position = turn * g.position;
  auto set = settings();
  set.law = law;
  for (const char* name :
       {"contacts", "contacts12", "undecided", "coordination", "force_mean", "fabric_deviator"})
    EXPECT_NEAR(column(turned, set, name), column(grains, set, name), 1e-13) << name;
  // The fabric's trace is 1, and it turns with the frame.
  Eigen::Matrix3d before, after;
  const auto fabric = [&](const std::vector<Grain>& all, Eigen::Matrix3d& f) {
    const char* names[3][3] = {{"fabric_xx", "fabric_xy", "fabric_xz"},
                               {"fabric_xy", "fabric_yy", "fabric_yz"},
                               {"fabric_xz", "fabric_yz", "fabric_zz"}};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) f(i, j) = column(all, set, names[i][j]);
  };
  fabric(grains, before);
  fabric(turned, after);
  EXPECT_NEAR(before.trace(), 1, 1e-13);
  EXPECT_LE((turn * before * turn.inverse() - after).norm(), 1e-13);
}

// Simple cubic grains of radius 1/2 that touch: pi/6, within what the sphere of 2.5 edges counts:
// 81 places.
TEST(LocalFilling, OfASimpleCubicLattice) {
  std::vector<Grain> grains;
  std::size_t centre = 0;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k) {
        if (i == 0 && j == 0 && k == 0) centre = grains.size();
        grains.push_back(grain(i, j, k, 0.5));
      }
  std::size_t places = 0;
  for (const Grain& g : grains) places += g.position.norm() < 2.5;
  const auto filling = local_filling(grains);
  EXPECT_NEAR(filling[centre], static_cast<double>(places) / 125, 1e-14);
  EXPECT_NEAR(filling[centre], std::numbers::pi / 6, 0.15);
  EXPECT_LT(filling[0], 0.5 * filling[centre]);  // at a corner
}

TEST(ContactNetwork, ShellsAddUpToTheGrains) {
  std::vector<Grain> grains = heap(300, 4, 3);  // body 1 about the origin, body 2 about (10, 0, 0)
  double volume = 0;
  for (Grain& g : grains) {
    if (g.body == 2) g.position.x() += 6;
    const Eigen::Vector3d centre(g.body == 1 ? 0 : 10, 0, 0);
    if ((g.position - centre).norm() < 5) volume += std::pow(g.radius / 5, 3);
  }
  double sum = 0;
  for (int k = 1; k <= 8; ++k)
    sum += 2 * column(grains, settings(), "filling_shell" + std::to_string(k)) *
           (std::pow(k / 8.0, 3) - std::pow((k - 1) / 8.0, 3));
  EXPECT_NEAR(sum, volume, 1e-14);
}

TEST(ContactNetwork, CompactedVolume) {
  auto set = settings();
  set.compacted = 0.3;
  // A pair counts 2/125 each; 27 places of a cubic lattice of spacing 1 within reach count 27/125
  // and less.
  std::vector<Grain> grains{grain(0, 0, 0, 0.5), grain(1, 0, 0, 0.5), grain(9, 0, 0, 0.5, 2)};
  EXPECT_EQ(column(grains, set, "compacted_grains"), 0);
  set.compacted = 0.01;
  EXPECT_EQ(column(grains, set, "compacted_grains"), 2);
  EXPECT_NEAR(column(grains, set, "compacted_volume"), 2 * std::numbers::pi / 6 / (2.0 / 125),
              1e-10);
}

}  // namespace
}  // namespace mdana
