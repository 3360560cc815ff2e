// SPDX-License-Identifier: GPL-3.0-or-later
// Energies of a body about its centre of mass, whatever its drift and however it is cut into blocks.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "analyses/energy.hpp"
#include "analyses/energy_curve.hpp"
#include "analyses/motion.hpp"
#include "readers/boltzmann.hpp"

namespace mdana {
namespace {

using Eigen::Vector3d;

constexpr std::array<BodyIndex, 2> both{1, 2};

struct Atom {
  BodyIndex body;
  double mass;
  Vector3d x, v;
};

void fill(AtomBlock& block, std::array<const char*, 3> names, std::span<const Atom> atoms,
          Vector3d Atom::*part) {
  for (int k = 0; k < 3; ++k) {
    const auto column = block.make_real(names[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < atoms.size(); ++i) column[i] = (atoms[i].*part)[k];
  }
}

/// A table of one row, from blocks of `size` atoms merged one after the other.
Table measure(const Analysis& analysis, const std::vector<Atom>& atoms, std::size_t size) {
  const FrameHeader header;
  std::unique_ptr<Partial> whole;
  for (std::size_t first = 0; first < atoms.size(); first += size) {
    const std::span part = std::span(atoms).subspan(first, std::min(size, atoms.size() - first));
    AtomBlock block;
    block.reset(0, part.size());
    fill(block, {"x", "y", "z"}, part, &Atom::x);
    fill(block, {"vx", "vy", "vz"}, part, &Atom::v);
    std::vector<BodyIndex> body;
    std::vector<double> mass;
    for (const Atom& a : part) {
      body.push_back(a.body);
      mass.push_back(a.mass);
    }
    auto partial = analysis.begin({header, {}});
    partial->add({block, body, mass});
    if (whole) whole->merge(*partial);
    else whole = std::move(partial);
  }
  Table table(analysis.columns());
  std::vector<double> row(table.columns().size());
  whole->close(row);
  table.add_row(row);
  return table;
}

EnergyCurve energies(const std::vector<Atom>& atoms, Units units = Units::lj,
                     std::size_t block = 7) {
  return energy_curve(measure(*make_motion({true, false}), atoms, block),
                      measure(*make_energy(""), atoms, block), units);
}

/// Two balls of atoms whose positions and velocities are whole numbers of 2^-10 below 1.
std::vector<Atom> balls(std::size_t atoms_a_body) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> number(-1023, 1023);
  const auto vector = [&]() -> Vector3d {
    return Vector3d(number(random), number(random), number(random)) * 0x1p-10;
  };
  std::vector<Atom> atoms;
  for (const BodyIndex b : both)
    for (std::size_t i = 0; i < atoms_a_body; ++i)
      atoms.push_back({b, i % 3 ? 1.0 : 2.0, vector(), vector()});
  return atoms;
}

/// Turns every body with w about its centre of mass.
void turn(std::vector<Atom>& atoms, const Vector3d& w, const Vector3d& drift) {
  for (const BodyIndex b : both) {
    Vector3d sum = Vector3d::Zero();
    double mass = 0;
    for (const Atom& a : atoms)
      if (a.body == b) sum += a.mass * a.x, mass += a.mass;
    for (Atom& a : atoms)
      if (a.body == b) a.v = drift + w.cross(a.x - sum / mass);
  }
}

// 2^23 = 8e6 times the thermal speed: velocities are whole numbers of 2^-10 below 2^24, which doubles
// hold, so that all digits can be asked for. A mean rounded to a double is known to 2^-29
// thermal speeds only, and 72 blocks are merged; what is left must be the rounding of the sums.
TEST(Energy, DriftLeavesThermalEnergyAndRotation) {
  const auto rest = balls(500);
  auto moving = rest;
  for (Atom& a : moving) a.v += Vector3d(0x1p23, -0x1p23, 0x1p22);
  const EnergyCurve a = energies(rest), b = energies(moving);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(a.K_t[k][0], 200);
    EXPECT_GT(a.rotation[k][0], 0);
    EXPECT_NEAR(b.K_t[k][0], a.K_t[k][0], 1e-13 * a.K_t[k][0]);
    EXPECT_NEAR(b.rotation[k][0], a.rotation[k][0], 1e-13 * a.K_t[k][0]);
    EXPECT_NEAR(b.temperature[k][0], a.temperature[k][0], 1e-13 * a.temperature[k][0]);
    EXPECT_GT(b.K_p[k][0], 1e13 * a.K_t[k][0]);
  }
}

// Koenig's theorem: all atoms' m v^2/2 is that of the centres and that about them.
TEST(Energy, PartsAddUpToTheKineticEnergyOfAllAtoms) {
  const auto atoms = balls(300);
  long double direct = 0;
  for (const Atom& a : atoms) direct += 0.5L * a.mass * a.v.squaredNorm();
  const double whole = static_cast<double>(direct);
  for (const std::size_t block : {1, 2, 7, 100, 1000})
    EXPECT_NEAR(energies(atoms, Units::lj, block).kinetic()[0], whole, 1e-14 * whole);
}

TEST(Energy, RigidRotationIsNoHeat) {
  auto atoms = balls(200);
  turn(atoms, {0.3, -2, 0.7}, {5, 0, -3});
  const EnergyCurve curve = energies(atoms);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(curve.K_t[k][0], 100);
    EXPECT_NEAR(curve.rotation[k][0], curve.K_t[k][0], 1e-13 * curve.K_t[k][0]);
    EXPECT_GE(curve.temperature[k][0], 0);
    EXPECT_NEAR(curve.temperature[k][0], 0, 1e-13 * curve.K_t[k][0] / 600);
  }
}

// Atoms on an oblique line turn about two axes, one atom about none; inverting I would give infinity.
TEST(Energy, RotationOfALineAndOfOneAtom) {
  const Vector3d n = Vector3d(1, 2, -2) / 3;
  std::vector<Atom> atoms;
  for (int i = -3; i <= 3; ++i) atoms.push_back({1, 1, i * n, {0, 0, 0}});
  atoms.push_back({2, 4, {100, 7, 1}, {0, 0, 0}});
  turn(atoms, {3, 1, 1}, {1, 1, 1});
  const EnergyCurve curve = energies(atoms);
  const double across = Vector3d(3, 1, 1).cross(n).squaredNorm();  // w^2 less its part along the line
  EXPECT_NEAR(curve.K_t[0][0], 0.5 * 28 * across, 1e-12);
  EXPECT_NEAR(curve.rotation[0][0], curve.K_t[0][0], 1e-12 * curve.K_t[0][0]);
  EXPECT_NEAR(curve.temperature[0][0], 0, 1e-12);
  EXPECT_EQ(curve.K_t[1][0], 0);
  EXPECT_EQ(curve.rotation[1][0], 0);
  EXPECT_TRUE(std::isnan(curve.temperature[1][0]));
}

// The bodies change roles: every number of one is that of the other, and the pair's stay.
TEST(Energy, BodiesExchanged) {
  const auto atoms = balls(100);
  auto other = atoms;
  for (Atom& a : other) a.body = a.body == 1 ? 2 : 1;
  const EnergyCurve a = energies(atoms), b = energies(other);
  EXPECT_NE(a.K_t[0][0], a.K_t[1][0]);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(a.K_p[k], b.K_p[1 - k]);
    EXPECT_EQ(a.K_t[k], b.K_t[1 - k]);
    EXPECT_EQ(a.rotation[k], b.rotation[1 - k]);
  }
  EXPECT_NEAR(a.K_p_rel[0], b.K_p_rel[0], 1e-15 * a.K_p_rel[0]);
}

// Argon-like: mass 40 g/mol at 1 Å/ps is 40 * 1.0364269e-4/2 eV, and 300 K is 3/2 k_B 300 an atom.
TEST(Energy, UnitsOfEnergyAndTemperature) {
  std::vector<Atom> atoms = balls(400);
  for (Atom& a : atoms) a.mass = 40;
  const EnergyCurve lj = energies(atoms), metal = energies(atoms, Units::metal);
  EXPECT_NEAR(metal.K_t[0][0], lj.K_t[0][0] * 1.0364269e-4, 1e-14 * metal.K_t[0][0]);
  const double thermal = metal.K_t[0][0] - metal.rotation[0][0];
  EXPECT_NEAR(metal.temperature[0][0], 2 * thermal / (1194 * 8.617343e-5),
              1e-13 * metal.temperature[0][0]);
  EXPECT_NEAR(lj.temperature[0][0], 2 * (lj.K_t[0][0] - lj.rotation[0][0]) / 1194,
              1e-13 * lj.temperature[0][0]);
}

// A temperature is the same in every system: k_B in J, from each energy unit in J (CODATA 2006, which
// LAMMPS' constants are of; 5e-6 between its editions and the thermochemical calorie).
TEST(Boltzmann, IsTheSameConstantInAllUnits) {
  const double avogadro = 6.02214179e23, electronvolt = 1.602176487e-19;
  const std::pair<Units, double> joules[] = {
      {Units::real, 4184 / avogadro}, {Units::metal, electronvolt}, {Units::si, 1},
      {Units::cgs, 1e-7},             {Units::electron, 27.21138386 * electronvolt},
      {Units::micro, 1e-15},          {Units::nano, 1e-21}};
  for (const auto& [units, joule] : joules)
    EXPECT_NEAR(boltzmann(units) * joule / 1.3806504e-23, 1, 5e-6) << name(units);
  EXPECT_EQ(boltzmann(Units::lj), 1);
}

}  // namespace
}  // namespace mdana
