// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "analyses/contact_radius.hpp"
#include "analyses/motion.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

/// x = 1 + 0.3 h^p at h = 1, 2, 4, 8 times 0.01.
AccuracySubject power_law(double order) {
  Knob knob{"h", "step", Reference::finest, 6, {}};
  for (const double h : {1, 2, 4, 8}) knob.values.push_back({std::to_string(h), 0.01 * h});
  AccuracySubject subject{"model", {knob}, {}};
  subject.measure = [knob, order](const KnobChoice& choice) {
    const double h = knob.values[choice.of("h")].number;
    const double error = 0.3 * std::pow(h, order);
    return std::vector<JudgedNumber>{{"x", {1 + error, 2 * error, {}}}};
  };
  return subject;
}

/// Rows of a ladder that are of one number.
std::vector<AccuracyRow> rows_of(const Ladder& ladder, const std::string& quantity) {
  std::vector<AccuracyRow> rows;
  for (const AccuracyRow& row : ladder.rows)
    if (row.quantity == quantity) rows.push_back(row);
  return rows;
}

TEST(Accuracy, ErrorsAndOrderOfAPowerLawAreFoundWithoutTheTruth) {
  for (const double order : {1.0, 2.0, 4.0}) {
    const AccuracySubject subject = power_law(order);
    const Ladder ladder = climb(subject, subject.knobs[0], 1);
    ASSERT_EQ(ladder.rows.size(), 4u);
    for (const AccuracyRow& row : ladder.rows) {
      EXPECT_NEAR(row.error / (0.3 * std::pow(row.number, order)), 1, 0.02) << order << ", h = " << row.number;
      EXPECT_TRUE(std::isnan(row.order) || std::abs(row.order - order) < 0.02) << order;
    }
    EXPECT_FALSE(std::isnan(ladder.rows[3].order));
  }
}

TEST(Accuracy, AKnownNumberIsTheReference) {
  AccuracySubject subject = power_law(2);
  subject.exact["x"] = 0.9;
  const Ladder ladder = climb(subject, subject.knobs[0], 1);
  EXPECT_NEAR(ladder.rows[0].error, 0.1 / 1.00003, 1e-4);
}

TEST(Accuracy, ANumberThatDoesNotRepeatItselfIsABug) {
  AccuracySubject subject = power_law(2);
  double next = 0;
  subject.measure = [&next](const KnobChoice&) { return std::vector<JudgedNumber>{{"x", {next++, {}, {}}}}; };
  EXPECT_THROW(climb(subject, subject.knobs[0], 2), std::logic_error);
}

TEST(Accuracy, WhatCannotBeMeasuredIsLeftOut) {
  AccuracySubject subject = power_law(2);
  subject.measure = [measure = subject.measure](const KnobChoice& choice) {
    if (choice.of("h") == 3) throw InputError("too few frames");
    return measure(choice);
  };
  const Ladder ladder = climb(subject, subject.knobs[0], 1);
  EXPECT_EQ(ladder.rows.size(), 3u);
  EXPECT_NE(ladder.left_out.find("too few frames"), std::string::npos);
  EXPECT_TRUE(std::isinf(ladder.error_at(subject.knobs[0].values[3].text)));
}

TEST(Accuracy, TheRecommendationIsTheCheapestThatMeetsTheError) {
  const AccuracySubject subject = power_law(2);
  const Ladder ladder = climb(subject, subject.knobs[0], 1);
  for (const double wanted : {1e-4, 4e-4, 1e-3, 1e-2}) {  // errors: 3e-5, 1.2e-4, 4.8e-4, 1.9e-3
    const Recommendation r = recommend(subject, {&ladder, 1}, wanted);
    const std::size_t k = r.choice.of("h");
    EXPECT_TRUE(r.met());
    EXPECT_LE(ladder.rows[k].error, wanted);
    EXPECT_TRUE(k == 3 || ladder.rows[k + 1].error > wanted) << wanted;
  }
  const Recommendation no = recommend(subject, {&ladder, 1}, 1e-6);
  EXPECT_FALSE(no.met());
  EXPECT_EQ(no.choice.of("h"), 0u);
  EXPECT_NEAR(no.error, 3e-5, 1e-6);
}

// The third value is right by chance, and says by its stated error that it need not be.
TEST(Accuracy, WhatIsRightByChanceIsNotRecommended) {
  AccuracySubject subject = power_law(2);
  subject.measure = [measure = subject.measure](const KnobChoice& choice) {
    std::vector<JudgedNumber> numbers = measure(choice);
    if (choice.of("h") == 2) numbers[0].value.value = 1;
    return numbers;
  };
  const Ladder ladder = climb(subject, subject.knobs[0], 1);
  EXPECT_LT(ladder.rows[2].error, 2e-4);
  EXPECT_NEAR(ladder.error_at(ladder.rows[2].setting), 0.3 * (0.04 * 0.04 - 0.01 * 0.01), 1e-6);
  EXPECT_EQ(recommend(subject, {&ladder, 1}, 4e-4).choice.of("h"), 1u);
}

// Two knobs whose errors add up: each alone would do.
TEST(Accuracy, KnobsAreJudgedTogether) {
  AccuracySubject subject = power_law(1);
  subject.knobs.push_back(subject.knobs[0]);
  subject.knobs[1].name = "g";
  subject.measure = [](const KnobChoice& c) {
    const double error = 1e-3 * std::pow(2.0, static_cast<double>(c.of("h"))) + 1e-3 * std::pow(2.0, static_cast<double>(c.of("g"))) - 1e-3;
    return std::vector<JudgedNumber>{{"x", {1 + error, {}, {}}}};
  };
  std::vector<Ladder> ladders;
  for (const Knob& knob : subject.knobs) ladders.push_back(climb(subject, knob, 1));
  const Recommendation r = recommend(subject, ladders, 0.0085);
  EXPECT_TRUE(r.met());
  EXPECT_LT(r.choice.of("h") + r.choice.of("g"), 6u);
  EXPECT_GT(r.choice.of("h") + r.choice.of("g"), 0u);
}

// Without a reference: until what is stated, and the change from the value before, are small enough.
TEST(Accuracy, AChoiceNeedsTheStatedErrorAndTheChangeToBeSmall) {
  const AccuracySubject subject = power_law(2);
  for (const double wanted : {1e-3, 1e-2}) {
    const Recommendation r = choose(subject, subject.knobs[0], wanted);
    EXPECT_TRUE(r.met());
    EXPECT_LE(0.3 * std::pow(subject.knobs[0].values[r.choice.of("h")].number, 2), wanted);
    EXPECT_GT(r.choice.of("h"), 0u);
    EXPECT_LT(r.choice.of("h"), 3u);  // the first one has nothing to be compared with
  }
  const Recommendation no = choose(subject, subject.knobs[0], 1e-5);
  EXPECT_FALSE(no.met());
  EXPECT_NEAR(no.error, 6e-5, 1e-6);
}

// ---- orders of the methods ----

/// A value of a knob of derivatives.
struct Differentiated {
  ForceDerivative by;
  std::size_t stride;
};

/// F_max of an elastic bounce whose turn falls on a frame; speeds and positions have that noise.
AccuracySubject bounce(Knob knob, ForceSource source, std::vector<Differentiated> values, double noise = 0) {
  constexpr double omega = 0.25, v = 0.5, mass = 3, step = 0.04;
  AccuracySubject subject{"force", {std::move(knob)}, {}, {{"F_max", mass * omega * v}}};
  subject.measure = [=, name = subject.knobs[0].name](const KnobChoice& choice) {
    const Differentiated& value = values[choice.of(name)];
    const double h = step * static_cast<double>(value.stride), turn = std::acos(-1.0) / (2 * omega);
    const double flight = value.stride > 1 ? 30 : 12;  // of which 6.3 in contact
    const auto before = std::floor(flight / h);
    RelativeMotion motion =
        test::head_on(test::even_times(turn - before * h, turn + flight, h), test::elastic_bounce(v, omega), 20, mass);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0, noise);
    for (double& x : motion.velocity.reshaped()) x += normal(random);
    motion.velocity_noise = noise;
    return std::vector<JudgedNumber>{{"F_max", force_curve(motion, source, Units::lj, 20, value.by).force_max}};
  };
  return subject;
}

/// The ladder of windows, or of strides, of one degree.
Ladder window_ladder(ForceSource source, int degree, std::vector<int> windows, double noise = 0) {
  Knob knob{"window", "", Reference::finest, static_cast<double>(degree), {}};
  std::vector<Differentiated> values;
  for (const int w : windows) knob.values.push_back({std::to_string(w), w - 1.0}), values.push_back({{w, degree}, 1});
  const AccuracySubject subject = bounce(knob, source, values, noise);
  return climb(subject, knob, 1);
}

Ladder stride_ladder(ForceSource source, int degree, std::vector<std::size_t> strides) {
  Knob knob{"stride", "", Reference::finest, static_cast<double>(degree), {}};
  std::vector<Differentiated> values;
  for (const std::size_t s : strides)
    knob.values.push_back({std::to_string(s), static_cast<double>(s)}), values.push_back({{degree + 1, degree}, s});
  const AccuracySubject subject = bounce(knob, source, values);
  return climb(subject, knob, 1);
}

// In the middle of a window the terms of the next odd (first derivative) or even (second) power cancel: h^degree. Windows
// are so long that omega h is 0.2 to 0.7, where the next order is still small: 10 % of the order.
TEST(AccuracyLadders, ErrorsOfDerivativesFallWithTheirDegree) {
  for (const ForceSource source : {ForceSource::velocities, ForceSource::positions})
    for (const Ladder& ladder : {window_ladder(source, 2, {9, 13, 17, 25}), window_ladder(source, 4, {17, 25, 33, 49}),
                                 window_ladder(source, 6, {65, 73, 97, 129}), stride_ladder(source, 2, {4, 8, 16, 32}),
                                 stride_ladder(source, 4, {4, 8, 16, 32}), stride_ladder(source, 6, {16, 20, 24, 32})}) {
      const auto degree = ladder.knob.order;
      ASSERT_EQ(ladder.rows.size(), 4u);
      for (std::size_t k = 1; k < 4; ++k)
        EXPECT_NEAR(ladder.rows[k].order, degree, 0.1 * degree) << ladder.knob.name << " " << ladder.rows[k].setting;
      for (const AccuracyRow& row : ladder.rows)
        EXPECT_LE(row.error, 2 * row.stated) << ladder.knob.name << " " << row.setting << ", degree " << degree;
    }
}

// Noise ends the fall: short windows are then worse than long ones, and of one window a higher degree is.
TEST(AccuracyLadders, NoiseOfDerivativesFallsWithTheWindowAndGrowsWithTheDegree) {
  constexpr double noise = 1e-3;
  const auto error = [&](int window, int degree) {
    return window_ladder(ForceSource::velocities, degree, {window}, noise).rows[0].error;
  };
  EXPECT_GT(error(5, 4), 10 * error(65, 4));
  EXPECT_GT(error(9, 6), 1.5 * error(9, 2));
  for (const int degree : {2, 4, 6})
    for (const int window : {9, 17, 33}) {
      const AccuracyRow row = window_ladder(ForceSource::velocities, degree, {window}, noise).rows[0];
      EXPECT_LE(row.error, 2 * row.stated) << window << ", degree " << degree;
    }
}

TEST(AccuracyLadders, ToleranceOfIntegratorsIsKept) {
  struct Case {
    const char* law;
    std::vector<NamedValue> more;
  };
  const Case cases[] = {{"krijt", {{"gamma", "3.17"}, {"nu", "0.25"}, {"T_vis", "0.075"}}},
                        {"viscous-hertz", {{"nu", "0.25"}, {"T_vis", "0.075"}}},
                        {"stress", {{"gamma", "3.17"}, {"nu", "0.25"}, {"C", "2.1e-4"}, {"B", "6.2"}, {"zeta", "4"}}}};
  for (const Case& c : cases) {
    const CollisionLaw* law = find_collision_law(c.law);
    if (!law) continue;
    std::vector<NamedValue> given{{"R", "147"}, {"m", "14434147"}, {"E", "65.5"}, {"v", "0.2"}};
    given.insert(given.end(), c.more.begin(), c.more.end());
    const AccuracySubject subject = predict_subject(*law, collision_input(*law, given), {});
    const std::vector<AccuracyRow> rows = rows_of(climb(subject, subject.knobs[0], 1), "e");
    ASSERT_GE(rows.size(), 5u) << c.law;
    for (const AccuracyRow& row : rows) {
      EXPECT_LE(row.error, row.number + 1e-11) << c.law << " " << row.setting;
      EXPECT_LE(row.error, 2 * row.stated + 1e-11) << c.law << " " << row.setting;
    }
    EXPECT_GT(rows.back().error, 10 * rows.front().error) << c.law;
  }
}

// Two spheres of R = 20 cut off at the plane where they meet in a circle of radius a; atoms on a fine lattice. A layer of
// half thickness h reaches down to circles with a^2 + 2 c h: the error is of first order.
TEST(AccuracyLadders, LayerOfAKnownContactIsOfFirstOrder) {
  constexpr double R = 20, a = 6, spacing = 0.125;
  const double c = std::sqrt(R * R - a * a);
  std::vector<Eigen::Vector3d> at;
  for (double z = spacing / 2; z < 1; z += spacing)
    for (double x = -12; x <= 12; x += spacing)
      for (double y = -12; y <= 12; y += spacing)
        if (x * x + y * y + (c - z) * (c - z) <= R * R) at.emplace_back(x, y, z);
  AtomBlock block;
  block.reset(0, 2 * at.size());
  const auto xs = block.make_real("x"), ys = block.make_real("y"), zs = block.make_real("z");
  std::vector<BodyIndex> body(2 * at.size(), 1);
  for (std::size_t i = 0; i < at.size(); ++i) {
    xs[i] = xs[at.size() + i] = at[i].x(), ys[i] = ys[at.size() + i] = at[i].y();
    zs[i] = -at[i].z(), zs[at.size() + i] = at[i].z();
    body[at.size() + i] = 2;
  }
  const std::vector<double> mass(2 * at.size(), 1.0);
  std::array<BodyMotion, 2> motion;
  motion[0].position = {0, 0, -c}, motion[1].position = {0, 0, c};
  Knob knob{"layer", "", Reference::finest, 1, {}};
  for (const double h : {0.25, 0.5, 1.0}) knob.values.push_back({std::to_string(h), h});
  AccuracySubject subject{"contact-radius", {knob}, {}, {{"a", a}}};
  subject.measure = [&](const KnobChoice& choice) {
    const double half = knob.values[choice.of("layer")].number;
    const FrameHeader header;
    const auto partial = make_contact_radius({{R, R}, half})->begin({header, motion});
    partial->add({block, body, mass});
    std::array<double, 4> row{};
    partial->close(row);
    return std::vector<JudgedNumber>{{"a", {row[0], row[1], dimension::length}}};
  };
  const Ladder ladder = climb(subject, knob, 1);
  for (std::size_t k = 1; k < 3; ++k) EXPECT_NEAR(ladder.rows[k].order, 1, 0.25) << ladder.rows[k].setting;
}

/// e(v) by JKR with noise.
std::vector<ObservedCollision> noisy_collisions() {
  const CollisionLaw& law = *find_collision_law("jkr");
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<ObservedCollision> all;
  for (const double v : {0.2, 0.22, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6}) {
    ObservedCollision o;
    o.given = {{"R", 58.9}, {"m", 4.3633 * 58.9 * 58.9 * 58.9}, {"E", 65.5}, {"v", v}};
    const std::vector<NamedNumber> truth{{"gamma", 3.17}};
    o.e = {collide(law, input_of(law, o, truth)).e + noise(random), 0.01};
    all.push_back(o);
  }
  return all;
}

// 20 and 320 draws: 4 times, known of eight seeds each to a factor of 1.6 (two standard deviations).
TEST(AccuracyLadders, BootstrapConvergesWithTheRootOfItsDraws) {
  ContactFitSettings settings;
  settings.free = {{"gamma"}};
  settings.starts = 1;
  const AccuracySubject subject = fit_contact_subject(*find_collision_law("jkr"), noisy_collisions(), settings);
  const Ladder ladder = climb(subject, subject.knob("bootstrap"), 1);
  ASSERT_EQ(ladder.rows.size(), 4u);
  const double ratio = ladder.rows.back().error / ladder.rows.front().error;
  EXPECT_GT(ratio, 4 / 1.9);
  EXPECT_LT(ratio, 4 * 1.9);
}

}  // namespace
}  // namespace mdana
