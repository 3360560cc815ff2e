// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/scene.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

class SceneFile : public ::testing::Test {
 protected:
  Scene load(const std::string& text) { return load_scene(folder_.write("scene.toml", text)); }

  /// The error of a scene whose third line is the given one.
  std::string error(const std::string& line) {
    return test::input_error_of([&] { load("schema = 1\n\n" + line + "\n"); });
  }
  void expect_error(const std::string& line, const std::string& key, const std::string& what) {
    const std::string text = error(line);
    EXPECT_TRUE(test::contains(text, "scene.toml:3: " + key)) << text;
    EXPECT_TRUE(test::contains(text, what)) << text;
  }
  test::TemporaryFolder folder_;
};

TEST_F(SceneFile, StatesEverything) {
  const Scene scene = load(R"(schema = 1
name = "run 7"
dump = "d.gz"
units = "nano"
interaction = "aggregate"
timestep = 1e-5
sigma = 2
cutoff = 5
shift = false
bodies = "mol"
[masses]
1 = 1.5
20 = 3
[[body]]
radius = 5
radius_definition = "cut"
[[body]]
radius = 6.5
radius_definition = "cut"
[material]
gamma = 0.1
nu = 0.25
[aggregate]
filling_factor = 0.4
[grains]
radius = 100
density = 0.001
surface_energy = 100
modulus = 7000
poisson_ratio = 0.25
rolling_displacement = 0.8
[generator]
velocity = 0.02
anything = "else"
)");
  EXPECT_EQ(scene.name, "run 7");
  EXPECT_EQ(scene.dump, "d.gz");
  EXPECT_EQ(scene.units, Units::nano);
  EXPECT_EQ(scene.interaction, Interaction::aggregate);
  EXPECT_EQ(scene.timestep, 1e-5);
  EXPECT_EQ(scene.sigma, 2);
  EXPECT_EQ(scene.cutoff, 5);
  EXPECT_EQ(scene.shift, false);
  EXPECT_EQ(scene.bodies, "mol");
  EXPECT_EQ(scene.masses, (std::map<std::int64_t, double>{{1, 1.5}, {20, 3}}));
  EXPECT_EQ(scene.radii, (std::vector<double>{5, 6.5}));
  EXPECT_EQ(scene.radius_definition, "cut");
  EXPECT_EQ(scene.surface_energy, 0.1);
  EXPECT_EQ(scene.poisson_ratio, 0.25);
  EXPECT_EQ(scene.impact_velocity, 0.02);
  EXPECT_EQ(scene.filling_factor, 0.4);
  EXPECT_EQ(scene.grains.radius, 100);
  EXPECT_EQ(scene.grains.density, 0.001);
  EXPECT_EQ(scene.grains.surface_energy, 100);
  EXPECT_EQ(scene.grains.modulus, 7000);
  EXPECT_EQ(scene.grains.poisson_ratio, 0.25);
  EXPECT_EQ(scene.grains.rolling_displacement, 0.8);
}

TEST_F(SceneFile, EverythingIsOptionalButTheSchema) {
  const Scene scene = load("schema = 1\n");
  EXPECT_FALSE(scene.units.has_value());
  EXPECT_EQ(scene.interaction, Interaction::unknown);
  EXPECT_TRUE(scene.masses.empty() && scene.radii.empty());
  for (const char* text : {"", "schema = 2\n", "schema = \"1\"\n"})
    EXPECT_INPUT_ERROR(load(text), "scene.toml", "schema");
}

TEST_F(SceneFile, UnknownKeysAreErrors) {
  expect_error("time_step = 1", "time_step", "unknown key");
  expect_error("materials = {}", "materials", "unknown key");
}

TEST_F(SceneFile, UnknownKeysInTables) {
  EXPECT_INPUT_ERROR(load("schema = 1\n[material]\ngama = 1\n"), "scene.toml:3: material.gama",
                     "unknown key");
  EXPECT_INPUT_ERROR(load("schema = 1\n[[body]]\nradios = 1\n"), "scene.toml:3: body.radios",
                     "unknown key");
}

TEST_F(SceneFile, WrongTypesAreErrors) {
  expect_error("name = 5", "name", "text in quotes");
  expect_error("shift = \"yes\"", "shift", "true or false");
  expect_error("timestep = \"1\"", "timestep", "finite number");
  expect_error("timestep = true", "timestep", "finite number");
  expect_error("masses = 1", "masses", "a table is expected");
  expect_error("body = 1", "body", "[[body]]");
  expect_error("material = \"steel\"", "material", "a table is expected");
}

TEST_F(SceneFile, WrongValuesAreErrors) {
  expect_error("units = \"imperial\"", "units", "lj, real, metal");
  expect_error("interaction = \"magnetic\"", "interaction", "hertz, adhesive or aggregate");
  expect_error("timestep = 0", "timestep", "greater than zero");
  expect_error("timestep = nan", "timestep", "finite number");
  expect_error("sigma = -1.0", "sigma", "greater than zero");
  expect_error("sigma = inf", "sigma", "finite number");
  expect_error("masses = { x = 1.0 }", "masses.x", "atom type");
  expect_error("masses = { 1 = 0 }", "masses.1", "greater than zero");
  expect_error("material = { gamma = -1 }", "material.gamma", "greater than zero");
  expect_error("aggregate = { filling_factor = 1.1 }", "aggregate.filling_factor", "at most 1");
  expect_error("aggregate = { filling_factor = 0 }", "aggregate.filling_factor", "greater than zero");
  expect_error("grains = { radius = -1 }", "grains.radius", "greater than zero");
  expect_error("grains = { poisson_ratio = 0.6 }", "grains.poisson_ratio", "at most 0.5");
  expect_error("grains = { gamma = 1 }", "grains.gamma", "unknown key");
}

TEST_F(SceneFile, AllBodiesOrNoneStateTheirRadius) {
  EXPECT_INPUT_ERROR(load("schema = 1\n[[body]]\nradius = 1\n[[body]]\nname = \"b\"\n"),
                     "every body or none");
}

TEST_F(SceneFile, WhatIsNoTomlNamesItsLine) {
  EXPECT_INPUT_ERROR(load("schema = 1\nname = \n"), "scene.toml:2");
  EXPECT_INPUT_ERROR(load_scene(folder_.path() / "none.toml"), "no such scene file");
}

TEST_F(SceneFile, BelongsToTheDumpThatItNames) {
  folder_.write("scene.toml", "schema = 1\nname = \"mine\"\ndump = \"a.dump\"\n");
  EXPECT_EQ(scene_beside(folder_.path() / "a.dump").name, "mine");
  EXPECT_EQ(scene_beside(folder_.path() / "b.dump").name, "");
  EXPECT_EQ(scene_beside(folder_.path() / "elsewhere" / "a.dump").name, "");
}

}  // namespace
}  // namespace mdana
