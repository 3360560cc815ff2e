// SPDX-License-Identifier: GPL-3.0-or-later
// Hundreds of random small systems, however they are written, against what the pages of the analyses say.
#include <array>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "analyses/relative_motion.hpp"
#include "tests/contracts/catalogue.hpp"
#include "tests/differential/straightforward.hpp"

namespace mdana {
namespace {

using test::MadeUpAtom;
using test::MadeUpFrame;

double uniform(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution(low, high)(random); }

Eigen::Vector3d direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// Two bodies of 1 to 60 atoms anywhere, in any order, on a drift; masses and speeds of any kind.
MadeUpFrame random_frame(std::mt19937_64& random) {
  const Eigen::Vector3d place = uniform(random, 0, 10) * direction(random), line = direction(random);
  const Eigen::Vector3d drift = uniform(random, 0, 3) * direction(random);
  const double apart = uniform(random, 0.5, 2.5);
  MadeUpFrame frame;
  for (const int type : {1, 2}) {
    const auto atoms = std::uniform_int_distribution<std::size_t>(1, 60)(random);
    const Eigen::Vector3d centre = place + (type == 1 ? -0.5 : 0.5) * apart * line;
    for (MadeUpAtom& atom : test::ball(random, type, atoms, 1, centre, drift)) {
      atom.v += uniform(random, 0, 0.5) * direction(random);
      atom.mass = std::exp(uniform(random, -3, 3));
      atom.mol = type;
      frame.atoms.push_back(atom);
    }
  }
  std::ranges::shuffle(frame.atoms, random);
  for (std::size_t k = 0; k < frame.atoms.size(); ++k) frame.atoms[k].id = static_cast<std::int64_t>(7 * k + 1);
  return frame;
}

/// A tilted periodic box, and how positions are told in it.
struct RandomBox {
  std::array<double, 3> low, edge;
  double xy, xz, yz;
  enum { wrapped, scaled, unwrapped } positions;

  explicit RandomBox(std::mt19937_64& random) {
    for (int k = 0; k < 3; ++k) low[k] = uniform(random, -5, 5), edge[k] = uniform(random, 3, 9);
    xy = uniform(random, -0.5, 0.5) * edge[0], xz = uniform(random, -0.5, 0.5) * edge[0], yz = uniform(random, -0.5, 0.5) * edge[1];
    positions = static_cast<decltype(positions)>(random() % 3);
  }

  /// LAMMPS' bounding box of a tilted one.
  std::string bounds() const {
    const auto least = [](std::initializer_list<double> all) { return std::min(all); };
    const auto most = [](std::initializer_list<double> all) { return std::max(all); };
    std::string text = "ITEM: BOX BOUNDS xy xz yz pp pp pp\n";
    const auto line = [&](double from, double to, double tilt) {
      for (const double value : {from, to, tilt}) test::print(text, value);
      text += "\n";
    };
    line(low[0] + least({0, xy, xz, xy + xz}), low[0] + edge[0] + most({0, xy, xz, xy + xz}), xy);
    line(low[1] + least({0, yz}), low[1] + edge[1] + most({0, yz}), xz);
    line(low[2], low[2] + edge[2], yz);
    return text;
  }

  Eigen::Matrix3d edges() const { return (Eigen::Matrix3d() << edge[0], xy, xz, 0, edge[1], yz, 0, 0, edge[2]).finished(); }

  std::string columns() const {
    constexpr std::array<const char*, 3> names{"x y z ix iy iz", "xs ys zs ix iy iz", "xu yu zu"};
    return names[positions];
  }

  void print(std::string& text, const Eigen::Vector3d& x) const {
    if (positions == unwrapped) return test::print(text, x);
    const Eigen::Vector3d corner(low[0], low[1], low[2]);
    const Eigen::Vector3d share = edges().inverse() * (x - corner), image = share.array().floor();
    test::print(text, positions == scaled ? Eigen::Vector3d(share - image) : Eigen::Vector3d(x - edges() * image));
    for (const double i : image) text += " " + std::to_string(static_cast<long>(i));
  }
};

std::string text_in(const RandomBox& box, const MadeUpFrame& frame) {
  std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(frame.atoms.size()) + "\n" + box.bounds() +
                     "ITEM: ATOMS " + box.columns() + " id c_pe fx fy fz type vx vy vz mol mass\n";
  for (const MadeUpAtom& atom : frame.atoms) {
    box.print(text, atom.x);
    text += " " + std::to_string(atom.id);
    test::print(text, atom.pe);
    test::print(text, atom.f);
    text += " " + std::to_string(atom.type);
    test::print(text, atom.v);
    text += " " + std::to_string(atom.mol);
    test::print(text, atom.mass);
    text += "\n";
  }
  return text;
}

std::map<std::string, double> numbers_of(const std::string& dump) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("dump", dump);
  const FrameHeader first = first_header(path);
  const Scene scene = test::made_up_scene();
  auto analyses = test::whole_catalogue({scene, first});
  std::erase_if(analyses, [](const auto& a) { return test::is_of_grains(a) || a->needs().whole_frame; });
  const SweepResult swept = sweep(path, find_bodies(path, first, "type"), Masses::from_column("the dump"), analyses);
  std::map<std::string, double> numbers;
  for (const Table& table : swept.tables)
    for (const ColumnSpec& column : table.columns()) numbers[column.name] = table.column(column.name)[0];
  const RelativeMotion motion = relative_motion(swept.tables[0], swept.steps, {});
  numbers["distance"] = motion.distance()[0];
  numbers["approach speed"] = approach_speed(motion)[0];
  numbers["force"] = interparticle_force(motion, ForceSource::forces, Units::lj)[0];
  return numbers;
}

/// Every number is the straightforward one but for rounding: 1e-12 of its scale, 1e-11 where a box wraps.
void expect_straightforward(const MadeUpFrame& frame, const std::string& dump, double rounding) {
  const Scene scene = test::made_up_scene();
  const test::Straightforward right(frame, {scene.radii[0], scene.radii[1]}, *scene.sigma / 2);
  const auto found = numbers_of(dump);
  for (const auto& [name, number] : right.numbers()) {
    const auto at = found.find(name);
    RC_ASSERT(at != found.end());
    if (!(std::abs(at->second - number.value) <= rounding * number.scale))
      RC_FAIL(name + ": " + std::to_string(at->second) + " instead of " + std::to_string(number.value));
  }
}

RC_GTEST_PROP(Differential, PlainDumps, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const MadeUpFrame frame = random_frame(random);
  expect_straightforward(frame, test::dump_text(frame), 1e-12);
}

RC_GTEST_PROP(Differential, TiltedPeriodicBoxes, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const MadeUpFrame frame = random_frame(random);
  expect_straightforward(frame, text_in(RandomBox(random), frame), 1e-11);
}

}  // namespace
}  // namespace mdana
