// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that are done slab by slab, by way of temporary files: every bit as if they were whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <numeric>

#include "analyses/defects/slabs.hpp"
#include "readers/input_error.hpp"
#include "tests/analyses/crystals.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::Looked;
using test::Points;

DefectSettings everything() {
  DefectSettings settings;
  settings.surface = settings.lines = settings.centro_symmetry = settings.coordination = settings.bcc = settings.ico = true;
  return settings;
}

/// Two bodies with faults, vacancies, noise and a loose cluster, which touch and lie askew.
std::shared_ptr<FrameAtoms> hurt_pair() {
  Points one = test::stacked_ball("ABCABCABCBACBACBCABCABCABC", 9), two = test::fcc_ball(7);
  std::erase_if(two, [](const auto& p) { return p.norm() < 0.1 || (p - Eigen::Vector3d(2, 1, -2)).norm() < 1.1; });
  const Points loose = test::fcc_ball(2.5);
  for (const auto& p : loose) one.push_back(p + Eigen::Vector3d(0, 14, 3));
  test::turn(two, Eigen::Quaterniond(0.7, 0.2, -0.3, 0.4).normalized());
  for (auto& p : two) p += Eigen::Vector3d(3, 4, 15.6);
  test::add_noise(one, 0.045);
  test::add_noise(two, 0.03, 2);
  Points all = one;
  all.insert(all.end(), two.begin(), two.end());
  test::turn(all, Eigen::Quaterniond(0.9, 0.1, 0.3, -0.2).normalized());
  test::scale(all, 2.5);
  const auto atoms = test::atoms_of(all);
  std::fill(atoms->body.begin() + static_cast<std::ptrdiff_t>(one.size()), atoms->body.end(), BodyIndex{2});
  return atoms;
}

/// In the order of a file that is not sorted.
std::vector<std::size_t> shuffled(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::shuffle(order, std::mt19937_64(4));
  return order;
}

/// A store of so many atoms in memory, filled block by block.
std::unique_ptr<FrameStore> stored(const FrameAtoms& atoms, std::size_t most, bool ids = true) {
  auto store = std::make_unique<FrameStore>(most, ids, false);
  std::vector<std::size_t> order = shuffled(atoms.size());
  if (!ids) std::ranges::sort(order);
  for (std::size_t first = 0; first < order.size(); first += 700) {
    AtomBlock block;
    block.reset(first / 700, std::min<std::size_t>(700, order.size() - first));
    std::vector<BodyIndex> bodies;
    const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
    const auto id = block.make_integer("id");
    for (std::size_t k = 0; k < block.atoms(); ++k) {
      const std::size_t i = order[first + k];
      x[k] = atoms.x[i];
      y[k] = atoms.y[i];
      z[k] = atoms.z[i];
      id[k] = static_cast<std::int64_t>(i + 1);
      bodies.push_back(atoms.body[i]);
    }
    store->add(block, bodies);
  }
  store->sort();
  return store;
}

template <class T>
void expect_same(const std::vector<T>& a, const std::vector<T>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i)
    if constexpr (std::is_same_v<T, float>)
      ASSERT_EQ(std::bit_cast<std::uint32_t>(a[i]), std::bit_cast<std::uint32_t>(b[i])) << what << ' ' << i;
    else
      ASSERT_EQ(a[i], b[i]) << what << ' ' << i;
}

void expect_same_planes(const std::vector<FaultPlane>& a, const std::vector<FaultPlane>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].kind, b[k].kind);
    EXPECT_EQ(a[k].body, b[k].body);
    EXPECT_EQ(a[k].atoms, b[k].atoms);
    EXPECT_EQ(a[k].area, b[k].area);
    EXPECT_EQ(a[k].error, b[k].error);
    EXPECT_EQ(a[k].normal, b[k].normal);
    EXPECT_EQ(a[k].centre, b[k].centre);
  }
}

void expect_same_lines(const DislocationLines& a, const DislocationLines& b) {
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t k = 0; k < a.segments.size(); ++k) {
    EXPECT_EQ(a.segments[k].burgers, b.segments[k].burgers);
    EXPECT_EQ(a.segments[k].ends, b.segments[k].ends);
    EXPECT_EQ(a.segments[k].length.value, b.segments[k].length.value);
    expect_same(a.segments[k].points, b.segments[k].points, "line");
  }
}

void expect_same(const Looked& a, const Looked& b) {
  for (std::size_t k = 0; k < a.table.columns().size(); ++k)
    EXPECT_EQ(a.table.column(k)[0], b.table.column(k)[0]) << a.table.columns()[k].name;
  expect_same(a.labels.structure, b.labels.structure, "structure");
  expect_same(a.labels.site, b.labels.site, "site");
  expect_same(a.labels.margin, b.labels.margin, "margin");
  expect_same(a.labels.cluster, b.labels.cluster, "cluster");
  expect_same(a.labels.centro_symmetry, b.labels.centro_symmetry, "centro-symmetry");
  expect_same(a.labels.coordination, b.labels.coordination, "coordination");
  expect_same_planes(a.found.planes, b.found.planes);
  expect_same_lines(a.found.lines, b.found.lines);
  for (std::size_t body = 0; body < 2; ++body) {
    const SurfaceMesh &one = a.found.surfaces.body[body], &other = b.found.surfaces.body[body];
    expect_same(one.points, other.points, "points");
    expect_same(one.triangles, other.triangles, "triangles");
    expect_same(one.part, other.part, "parts");
  }
}

TEST(Slabs, ChangeNoBit) {
  const auto atoms = hurt_pair();
  const Looked whole = test::look(atoms, everything());
  ASSERT_GT(whole.found.planes.size(), 1u);
  ASSERT_GT(whole["patch_area"], 0);
  ASSERT_GT(whole["voids2"], 0);
  ASSERT_GT(whole["repaired"], 0);
  ASSERT_GT(std::ranges::max(whole.labels.cluster), 3u);
  for (const std::size_t most : {std::size_t{1}, atoms->size() / 2, atoms->size() - 1})
    for (const std::size_t threads : {1, 2}) {
      SCOPED_TRACE(std::to_string(most) + " atoms in memory, " + std::to_string(threads) + " threads");
      const auto store = stored(*atoms, most);
      ASSERT_FALSE(store->whole());
      expect_same(whole, test::look(*store, everything(), threads));
    }
  expect_same(whole, test::look(*stored(*atoms, atoms->size()), everything()));
}

TEST(Slabs, ChangeNoBitWithoutIds) {
  const auto atoms = std::make_shared<FrameAtoms>(*hurt_pair());
  atoms->id.clear();
  DefectSettings settings = everything();
  settings.ids = false;
  expect_same(test::look(atoms, settings), test::look(*stored(*atoms, 1, false), settings));
}

TEST(Slabs, ChangeNoBitOfOtherStructures) {
  Points hot = test::stacked_ball("ABCABCABCBACBACBCABCABCABC", 7), gas = hot;
  test::add_noise(hot, 0.12);
  test::add_noise(gas, 1);
  for (const Points& points : {hot, gas, test::lattice_ball(1.1547, 7, test::bcc_basis), test::fcc_ball(1.1),
                               test::stacked_ball("A", 9), test::stacked_ball("ABABABABABABABA", 7)}) {
    const auto atoms = test::atoms_of(points);
    expect_same(test::look(atoms, everything()), test::look(*stored(*atoms, 1), everything()));
  }
}

// Noise that leaves many atoms to the repair, to neighbours at the surface and to those in the layer of a fault: what
// reaches farthest.
TEST(Slabs, ChangeNoBitWhereNeighboursDecide) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Points ball = test::stacked_ball("ABCBCABACBCABCACBABCABCBCA", 6);
    test::add_noise(ball, 0.05 + 0.004 * static_cast<double>(seed), seed);
    test::turn(ball, Eigen::Quaterniond(1, 0.3 * static_cast<double>(seed), -0.4, 0.2).normalized());
    const auto atoms = test::atoms_of(ball);
    expect_same(test::look(atoms, everything()), test::look(*stored(*atoms, 1), everything()));
  }
}

TEST(Slabs, CgalNeighboursAreTheSame) {
  DefectSettings settings = everything();
  settings.by_cgal = true;
  const auto atoms = hurt_pair();
  expect_same(test::look(atoms, settings), test::look(*stored(*atoms, 1), settings));
}

// There are many of them, every atom is in one as its own, and with all that are near.
TEST(Slabs, HoldTheFrame) {
  const auto atoms = hurt_pair();
  const auto store = stored(*atoms, atoms->size() / 2);
  const defects::CellSpace space(defects::box_of(*atoms), 2.5);
  for (const std::size_t most : {std::size_t{1}, atoms->size() - 1}) {
    const auto in_slabs = stored(*atoms, most);
    const defects::Slabs slabs(*in_slabs, space);
    EXPECT_GE(slabs.count(), most == 1 ? 15u : 2u);
    std::vector<int> owners(atoms->size());
    for (std::size_t k = 0; k < slabs.count(); ++k) {
      const defects::Slab slab = slabs.slab(k);
      EXPECT_TRUE(std::ranges::is_sorted(slab.index));
      EXPECT_LE(slab.atoms->size(), std::max(most, atoms->size() - 1));
      const auto& at = slab.axis == 0 ? slab.atoms->x : slab.axis == 1 ? slab.atoms->y : slab.atoms->z;
      for (std::size_t i = 0; i < slab.index.size(); ++i) {
        const std::uint64_t cell = space.cell(at[i], slab.axis);
        owners[slab.index[i]] += cell >= slab.first && cell < slab.end;
        EXPECT_EQ(slab.atoms->x[i], atoms->x[slab.index[i]]);
      }
    }
    EXPECT_EQ(std::ranges::count(owners, 1), static_cast<std::ptrdiff_t>(owners.size()));
  }
}

TEST(Slabs, RefuseWhatTheWholeRefuses) {
  for (const auto& [points, says, header] : test::impossible_input())
    EXPECT_INPUT_ERROR(test::look(*stored(*test::atoms_of(points), 1), everything(), 1, header), says);
}

TEST(Slabs, AcrossEmptySpace) {
  Points pair = test::fcc_ball(5);
  for (const auto& p : test::fcc_ball(5)) pair.push_back(p + Eigen::Vector3d(9e5, -3e5, 7e5));
  const auto atoms = test::atoms_of(pair);
  expect_same(test::look(atoms, everything()), test::look(*stored(*atoms, 1), everything()));
}

// No space left on the device, and a folder that does not exist.
TEST(Slabs, SayWhereTheyCannotWrite) {
  const auto atoms = hurt_pair();
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", "/nonexistent", 1);
  EXPECT_THROW(stored(*atoms, 1), std::runtime_error);
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace mdana
