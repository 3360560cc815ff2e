// SPDX-License-Identifier: GPL-3.0-or-later
// What AMBER's convention says of a netCDF file: columns, units, box, time.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/readers/gzipped.hpp"
#include "tests/readers/netcdf_bytes.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;
using test::NetcdfBytes;
using enum test::NetcdfBytes::Type;
using Bytes = NetcdfBytes;

constexpr std::size_t capacity = AtomBlock::capacity;

/// Two atoms, two frames: positions k, k + 0.5 ... of frame k.
NetcdfBytes plain() {
  NetcdfBytes file;
  file.records = 2;
  auto& v = file.add({"coordinates", {0, 1, 2}, float_, {}});
  for (const float k : {0.F, 1.F}) v.records.push_back(Bytes::floats({k, k + 0.5F, 2, 3, 4, 5}));
  return file;
}

void add_of_frames(NetcdfBytes& file, const std::string& name, const std::vector<double>& first,
                   const std::vector<double>& second,
                   const std::vector<Bytes::Attribute>& attributes = {}) {
  std::vector<std::uint64_t> axes{0};
  if (first.size() == 3) axes.push_back(2);
  file.add({name, axes, double_, {Bytes::doubles(first), Bytes::doubles(second)}, attributes});
}

struct Reader {
  test::TemporaryFolder folder;

  test::WholeTrajectory operator()(const NetcdfBytes& file, const ColumnSet& wanted = {"x"}) const {
    return test::read_all(folder.write("t.nc", file.bytes()), wanted);
  }
  FrameHeader header(const NetcdfBytes& file) const {
    const auto whole = (*this)(file, {});
    EXPECT_EQ(whole.error, "");
    return whole.frames.empty() ? FrameHeader{} : whole.frames[0].header;
  }
  std::string error(const NetcdfBytes& file, const ColumnSet& wanted = {"x"}) const {
    return (*this)(file, wanted).error;
  }
};

TEST(AmberNetcdf, ReadsAllClassicFormats) {
  const Reader read;
  for (const int version : {1, 2, 5}) {
    NetcdfBytes file = plain();
    file.version = version;
    const auto whole = read(file, {"id", "x", "y", "z"});
    ASSERT_EQ(whole.error, "") << version;
    ASSERT_EQ(whole.frames.size(), 2u);
    EXPECT_EQ(whole.frames[1].real.at("x"), (std::vector<double>{1, 3}));
    EXPECT_EQ(whole.frames[1].real.at("y"), (std::vector<double>{1.5, 4}));
    EXPECT_EQ(whole.frames[1].real.at("z"), (std::vector<double>{2, 5}));
    EXPECT_EQ(whole.frames[1].integer.at("id"), (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(whole.frames[1].header.step, 1);
    EXPECT_EQ(whole.frames[1].header.index, 1u);
    EXPECT_FALSE(whole.frames[1].header.time.has_value());
    EXPECT_FALSE(whole.frames[1].header.units.has_value());
    EXPECT_FALSE(whole.frames[1].header.box.any_periodic());
  }
}

TEST(AmberNetcdf, ColumnsHaveLammpsNames) {
  NetcdfBytes file = plain();
  file.axes.push_back({"Voigt", 6});
  const auto reals = [](std::size_t n) { return Bytes::doubles(std::vector<double>(n, 0.25)); };
  for (const char* name : {"velocities", "forces", "unwrapped_coordinates", "mu", "c_v"})
    file.add({name, {0, 1, 2}, double_, {reals(6), reals(6)}});
  file.add({"f_stress", {0, 1, 3}, double_, {reals(12), reals(12)}});
  file.add({"c_pe", {0, 1}, double_, {reals(2), reals(2)}});
  file.add({"type", {1}, int_, {Bytes::integers({1, 2}, 4)}});  // the same for all frames
  file.add({"spatial", {2}, char_, {"xyz"}});
  file.add({"Temp", {0}, double_, {reals(1), reals(1)}});
  const Reader read;
  EXPECT_EQ(
      read.header(file).columns,
      (std::vector<std::string>{
          "id",          "x",           "y",           "z",           "vx",          "vy",
          "vz",          "fx",          "fy",          "fz",          "xu",          "yu",
          "zu",          "mux",         "muy",         "muz",         "c_v[1]",      "c_v[2]",
          "c_v[3]",      "f_stress[1]", "f_stress[2]", "f_stress[3]", "f_stress[4]", "f_stress[5]",
          "f_stress[6]", "c_pe",        "type"}));
  EXPECT_EQ(read(file, {"type"}).frames.at(1).integer.at("type"),
            (std::vector<std::int64_t>{1, 2}));
}

TEST(AmberNetcdf, WholeNumbersOf32And64Bit) {
  const Reader read;
  for (const auto& [type, bytes] : {std::pair{int_, 4}, std::pair{int64_, 8}}) {
    NetcdfBytes file = plain();
    file.version = 5;
    const std::vector<std::int64_t> ids{bytes == 8 ? 9'007'199'254'740'993 : 2'147'483'647, -1};
    file.add({"id", {0, 1}, type, {Bytes::integers(ids, bytes), Bytes::integers(ids, bytes)}});
    const auto whole = read(file, {"id"});
    ASSERT_EQ(whole.error, "");
    EXPECT_EQ(whole.frames.at(1).integer.at("id"), ids);
  }
  NetcdfBytes file = plain();
  file.add({"id", {0, 1}, double_, {Bytes::doubles({7, 8}), Bytes::doubles({9, 9.5})}});
  const auto whole = read(file, {"id"});
  EXPECT_EQ(whole.frames.size(), 1u);
  EXPECT_TRUE(contains(whole.error, "(frame 1): atom 2: column id is 9.5, not a whole number"))
      << whole.error;
}

TEST(AmberNetcdf, ScaleFactorsAreApplied) {
  NetcdfBytes file = plain();
  const std::string ones = Bytes::doubles({1, 2, 3, 4, 5, 6});
  file.add({"velocities", {0, 1, 2}, double_, {ones, ones}, {Bytes::scale(20.455)}});
  file.add({"c_q",
            {0, 1},
            short_,
            {Bytes::integers({3, -4}, 2), Bytes::integers({3, -4}, 2)},
            {Bytes::scale(0.5)}});
  add_of_frames(file, "time", {3}, {4}, {Bytes::scale(0.25)});
  const auto whole = Reader()(file, {"vx", "vz", "c_q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames.at(0).real.at("vx"), (std::vector<double>{20.455, 4 * 20.455}));
  EXPECT_EQ(whole.frames.at(1).real.at("vz"), (std::vector<double>{3 * 20.455, 6 * 20.455}));
  EXPECT_EQ(whole.frames.at(1).real.at("c_q"), (std::vector<double>{1.5, -2}));
  EXPECT_EQ(whole.frames.at(1).header.time, 1.0);
  EXPECT_EQ(whole.frames.at(1).header.step, 1);
}

TEST(AmberNetcdf, LammpsCountsTimeInSteps) {
  NetcdfBytes file = plain();
  file.attributes.push_back(Bytes::text("program", "LAMMPS"));
  add_of_frames(file, "time", {800}, {1600}, {Bytes::scale(0.125)});
  const Reader read;
  EXPECT_EQ(read(file).frames.at(1).header.step, 1600);
  EXPECT_EQ(read(file).frames.at(1).header.time, 200);
  add_of_frames(file, "Step", {801}, {1602});
  EXPECT_EQ(read(file).frames.at(1).header.step, 1602);
}

TEST(AmberNetcdf, BoxFromLengthsAndAngles) {
  NetcdfBytes file = plain();
  add_of_frames(file, "cell_lengths", {8, 4, 16}, {8, 0, 0});
  add_of_frames(file, "cell_angles", {90, 90, 60}, {90, 90, 90});
  add_of_frames(file, "cell_origin", {-1, -2, -3}, {1, 2, 3});
  const auto whole = Reader()(file);
  ASSERT_EQ(whole.error, "");
  const Box first = whole.frames.at(0).header.box, second = whole.frames.at(1).header.box;
  EXPECT_EQ(first.origin, Eigen::Vector3d(-1, -2, -3));
  EXPECT_EQ(first.periodic, (std::array{true, true, true}));
  Eigen::Matrix3d edges;
  edges << 8, 2, 0, 0, std::sqrt(12.0), 0, 0, 0, 16;
  EXPECT_LE((first.edges - edges).norm(), 1e-15 * 16);
  EXPECT_EQ(second.edges, Eigen::Vector3d(8, 0, 0).asDiagonal().toDenseMatrix());
  EXPECT_EQ(second.periodic, (std::array{true, false, false}));
}

TEST(AmberNetcdf, WrongBoxesAreTold) {
  const Reader read;
  const auto error = [&](const std::vector<double>& lengths, const std::vector<double>& angles) {
    NetcdfBytes file = plain();
    add_of_frames(file, "cell_lengths", {0, 0, 0}, lengths);
    add_of_frames(file, "cell_angles", {0, 0, 0}, angles);
    const auto whole = read(file);
    EXPECT_EQ(whole.frames.size(), 1u);  // no lengths are no box, whatever the angles
    return whole.error;
  };
  EXPECT_TRUE(contains(error({1, -1, 1}, {90, 90, 90}), "(frame 1): cell_lengths 1 -1 1"));
  EXPECT_TRUE(contains(error({1, 1, 1}, {90, 90, 180}), "are no box"));
  EXPECT_TRUE(contains(error({1, 1, 1}, {30, 30, 90}), "are no box"));
  EXPECT_TRUE(contains(error({1, 1, NAN}, {90, 90, 90}), "cell_lengths is nan"));
  NetcdfBytes file = plain();
  add_of_frames(file, "cell_lengths", {1, 1, 1}, {1, 1, 1});
  EXPECT_TRUE(contains(read.error(file), "cell_lengths, but no cell_angles"));
}

TEST(AmberNetcdf, ScaledCoordinatesNeedAllLengths) {
  NetcdfBytes file = plain();
  file.variables[0].name = "scaled_coordinates";
  add_of_frames(file, "cell_lengths", {8, 4, 2}, {8, 4, 0});
  add_of_frames(file, "cell_angles", {90, 90, 90}, {90, 90, 90});
  add_of_frames(file, "cell_origin", {1, 0, 0}, {0, 0, 0});
  const auto whole = Reader()(file, {"x", "z"});
  ASSERT_EQ(whole.frames.size(), 1u);
  EXPECT_EQ(whole.frames[0].real.at("x"), (std::vector<double>{1, 25}));
  EXPECT_EQ(whole.frames[0].real.at("z"), (std::vector<double>{4, 10}));
  EXPECT_TRUE(contains(whole.error, "(frame 1): scaled_coordinates, but cell_lengths are"))
      << whole.error;
}

std::optional<Units> units_of(const std::string& time, const std::string& length,
                              const std::string& force = "") {
  NetcdfBytes file = plain();
  file.variables[0].attributes.push_back(Bytes::text("units", length));
  if (!time.empty()) add_of_frames(file, "time", {0}, {1}, {Bytes::text("units", time)});
  const std::string zeros = Bytes::doubles(std::vector<double>(6, 0));
  if (!force.empty())
    file.add({"forces", {0, 1, 2}, double_, {zeros, zeros}, {Bytes::text("units", force)}});
  const FrameHeader header = Reader().header(file);
  EXPECT_TRUE(force.empty() || header.has_column("fx") || header.has_column("forces[1]"));
  return header.units;
}

// The words are those of LAMMPS' and AMBER's own writers.
TEST(AmberNetcdf, UnitsWhereAllAttributesAgreeWithOneSystem) {
  EXPECT_EQ(units_of("lj", "lj"), Units::lj);
  EXPECT_EQ(units_of("picosecond", "angstrom"), Units::metal);
  EXPECT_EQ(units_of("picosecond", "Angstrom", "eV/angstrom"), Units::metal);
  EXPECT_EQ(units_of("femtosecond", "angstrom", "(Kcal/mol)/angstrom)"), Units::real);
  EXPECT_EQ(units_of("", "angstrom", "kilocalorie/mole/angstrom"), Units::real);
  EXPECT_EQ(units_of("second", "meter", "Newton"), Units::si);
  EXPECT_EQ(units_of("second", "centimeter", "dynes"), Units::cgs);
  EXPECT_EQ(units_of("femtoseconds", "Bohr", "Hartree/Bohr"), Units::electron);
  EXPECT_EQ(units_of("microseconds", "micrometers", "picogram * micrometer/microsecond^2"),
            Units::micro);
  EXPECT_EQ(units_of("nanoseconds", "nanometers", "attogram * nanometer/nanosecond^2"),
            Units::nano);
  EXPECT_EQ(units_of("", "angstrom"), std::nullopt);  // real or metal
  EXPECT_EQ(units_of("second", ""), std::nullopt);
  EXPECT_EQ(units_of("second", "angstrom"), std::nullopt);
  EXPECT_EQ(units_of("", "furlong"), std::nullopt);
}

// AMBER's forces are in kcal/mol/angstrom, its time in picoseconds: no system's forces.
TEST(AmberNetcdf, ForcesOfOtherUnitsAreNotTheSystems) {
  EXPECT_EQ(units_of("picosecond", "angstrom", "kilocalorie/mole/angstrom"), Units::metal);
  NetcdfBytes file = plain();
  add_of_frames(file, "time", {0}, {1}, {Bytes::text("units", "picosecond")});
  file.variables[0].attributes.push_back(Bytes::text("units", "angstrom"));
  const std::string ones = Bytes::doubles(std::vector<double>(6, 1));
  file.add({"forces",
            {0, 1, 2},
            double_,
            {ones, ones},
            {Bytes::text("units", "kilocalorie/mole/angstrom")}});
  EXPECT_FALSE(Reader().header(file).has_column("fx"));
  EXPECT_TRUE(Reader().header(file).has_column("forces[3]"));
}

TEST(AmberNetcdf, WhatWasNeverWrittenIsTold) {
  NetcdfBytes file = plain();
  const float fill = 9.9692099683868690e+36F;  // netCDF's default for floats
  file.variables[0].records[1] = Bytes::floats({0, 0, 0, 0, fill, 0});
  const Reader read;
  EXPECT_EQ(read.error(file, {"vx"}).empty(), false);
  const auto whole = read(file, {"y"});
  EXPECT_EQ(whole.frames.size(), 1u);
  EXPECT_TRUE(contains(whole.error, "(frame 1): atom 2: column y was never written"))
      << whole.error;
  file.variables[0].attributes.push_back({"_FillValue", float_, Bytes::floats({-5})});
  EXPECT_EQ(read.error(file, {"y"}), "");
  file.variables[0].attributes[0].bytes = Bytes::floats({0.5});
  EXPECT_TRUE(contains(read.error(file, {"y"}), "(frame 0): atom 1: column y was never written"));
  file.variables[0].attributes[0].bytes = Bytes::floats({0.5, 7});  // one is meant
  EXPECT_TRUE(contains(read.error(file, {"y"}), "coordinates: _FillValue"));
}

TEST(AmberNetcdf, BlocksRestartAndPassingOver) {
  NetcdfBytes file;
  file.records = 3;
  file.axes[1].length = 2 * capacity + 7;
  auto& v = file.add({"q", {0, 1}, double_, {}});
  std::vector<double> q(2 * capacity + 7);
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = static_cast<double>(i) + 1e6 * k;
    v.records.push_back(Bytes::doubles(q));
  }
  const test::TemporaryFolder folder;
  const auto path = folder.write("t.nc", file.bytes());
  const auto whole = test::read_all(path, {"id", "q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames.at(2).block_atoms, (std::vector<std::size_t>{capacity, capacity, 7}));
  EXPECT_EQ(whole.frames[2].real.at("q"), q);
  EXPECT_EQ(whole.frames[2].integer.at("id").back(), static_cast<std::int64_t>(q.size()));
  const auto source = open_trajectory(path, {"id", "q"});
  FrameHeader header;
  Chunk chunk;
  ASSERT_TRUE(source->next(header));
  ASSERT_TRUE(source->next(header));
  ASSERT_TRUE(source->cut(chunk, 5));
  ASSERT_TRUE(source->next(header));
  ASSERT_TRUE(source->cut(chunk));
  source->restart_frame();
  test::WholeFrame again;
  test::read_blocks(*source, {"id", "q"}, again);
  EXPECT_EQ(again.real.at("q"), q);
  EXPECT_FALSE(source->next(header));
  const auto record = source->records().at(0);
  EXPECT_EQ(record.size, std::filesystem::file_size(path));
}

TEST(AmberNetcdf, FramesNeedNotGrow) {
  NetcdfBytes file = plain();
  file.axes[0].length = 2;
  file.records = 0;
  auto& v = file.variables[0];
  v.records = {v.records[0] + v.records[1]};
  const auto whole = Reader()(file);
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 2u);
  EXPECT_EQ(whole.frames[1].real.at("x"), (std::vector<double>{1, 3}));
}

TEST(AmberNetcdf, OtherFilesAreRefused) {
  const Reader read;
  const auto error = [&](auto&& change) {
    NetcdfBytes file = plain();
    change(file);
    return read.error(file);
  };
  EXPECT_TRUE(
      contains(error([](auto& f) { f.attributes.clear(); }), "Conventions does not name AMBER"));
  EXPECT_TRUE(contains(error([](auto& f) { f.attributes[0].bytes = "CF-1.8 AMBERish"; }),
                       "does not name AMBER"));
  EXPECT_EQ(error([](auto& f) { f.attributes[0].bytes = "CF-1.8,AMBER"; }), "");
  EXPECT_TRUE(contains(error([](auto& f) { f.attributes[0].bytes = "AMBERRESTART"; }), "restart"));
  EXPECT_TRUE(contains(error([](auto& f) { f.attributes[1].bytes = "2.0"; }), "ConventionVersion"));
  EXPECT_TRUE(contains(error([](auto& f) { f.axes[0].name = "frames"; }), "no dimension 'frame'"));
  EXPECT_TRUE(contains(error([](auto& f) { f.axes[1].name = "atoms"; }), "no dimension 'atom'"));
  EXPECT_TRUE(contains(error([](auto& f) { f.variables[0].attributes = {Bytes::scale(0)}; }),
                       "scale_factor of 0"));
  EXPECT_TRUE(contains(error([](auto& f) {
                         f.variables[0].attributes = {{"add_offset", double_, Bytes::doubles({1})}};
                       }),
                       "add_offset"));
  EXPECT_TRUE(contains(
      error([](auto& f) { f.variables[0].attributes = {Bytes::text("scale_factor", "2")}; }),
      "coordinates: scale_factor"));
  EXPECT_TRUE(
      contains(error([](auto& f) { f.axes[2].length = 2; }), "2 numbers an atom instead of 3"));
  const auto path = read.folder.write("t.nc.gz", test::gzipped(plain().bytes()));
  EXPECT_TRUE(contains(test::read_all(path, {"x"}).error, "compressed netCDF"));
}

}  // namespace
}  // namespace mdana
