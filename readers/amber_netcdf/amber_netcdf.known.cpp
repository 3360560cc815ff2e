// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include "readers/known_answer.hpp"
#include "readers/trajectory.hpp"

namespace mdana {

std::vector<KnownAnswer> amber_netcdf_known();

namespace {

/// Numbers as netCDF stores them: big-endian.
std::string big_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int k = bytes - 1; k >= 0; --k) text += static_cast<char>(value >> (8 * k));
  return text;
}

std::string words(std::initializer_list<std::uint32_t> numbers) {
  std::string bytes;
  for (const auto number : numbers) bytes += big_endian(number, 4);
  return bytes;
}

std::string floats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers) bytes += big_endian(std::bit_cast<std::uint32_t>(number), 4);
  return bytes;
}

std::string doubles(std::initializer_list<double> numbers) {
  std::string bytes;
  for (const double number : numbers) bytes += big_endian(std::bit_cast<std::uint64_t>(number), 8);
  return bytes;
}

/// A text behind its length, filled up to four bytes.
std::string text(const std::string& characters) {
  const auto size = static_cast<std::uint32_t>(characters.size());
  return words({size}) + characters + std::string((4 - size % 4) % 4, '\0');
}

constexpr std::uint32_t a_float = 5, a_double = 6;

/// Velocities have AMBER's scale_factor, the others no attribute.
std::string variable(const std::string& name, const std::string& axes,
                     const std::string& attributes, std::uint32_t type, std::uint32_t bytes,
                     std::uint32_t begin) {
  return text(name) + axes + attributes + words({type, bytes, begin});
}

// CDF-1: two atoms, one frame. Dimensions 0 frame (of records), 1 atom, 2 spatial.
std::string header(std::uint32_t data) {
  const std::string none = words({0, 0});
  const std::string vectors = words({3, 0, 1, 2}), lengths = words({2, 0, 2});
  return "CDF\x01" + words({1, 10, 3}) + text("frame") + words({0}) + text("atom") + words({2}) +
         text("spatial") + words({3}) + words({12, 1}) + text("Conventions") + words({2}) +
         text("AMBER") + words({11, 5}) + variable("time", words({1, 0}), none, a_float, 4, data) +
         variable("coordinates", vectors, none, a_float, 24, data + 4) +
         variable("velocities", vectors,
                  words({12, 1}) + text("scale_factor") + words({a_double, 1}) + doubles({20.455}),
                  a_double, 48, data + 28) +
         variable("cell_lengths", lengths, none, a_double, 24, data + 76) +
         variable("cell_angles", lengths, none, a_double, 24, data + 100);
}

std::string trajectory() {
  const auto size = static_cast<std::uint32_t>(header(0).size());
  return header(size) + floats({0.375F, 1.5F, -2, 0.25F, 3, 4, 5}) +
         doubles({1, 0, -2, 0, 0.5, 0}) + doubles({8, 4, 16}) + doubles({90, 90, 60});
}

/// Writes the trajectory to a file of its own, which is gone afterwards.
class TrajectoryFile {
 public:
  TrajectoryFile()
      : path(std::filesystem::temp_directory_path() /
             fmt::format("mdana-known-{:08x}.nc", std::random_device{}())) {
    std::ofstream(path, std::ios::binary) << trajectory();
  }
  ~TrajectoryFile() { std::filesystem::remove(path); }
  TrajectoryFile(const TrajectoryFile&) = delete;
  TrajectoryFile& operator=(const TrajectoryFile&) = delete;

  const std::filesystem::path path;
};

}  // namespace

std::vector<KnownAnswer> amber_netcdf_known() {
  const TrajectoryFile file;
  std::vector<KnownAnswer> answers;
  const auto add = [&](std::string what, double computed, double exact, double digits = 16) {
    answers.push_back({std::move(what), computed, exact, digits});
  };
  const FrameHeader header =
      for_first_frame(file.path, {"id", "x", "y", "z", "vx", "vy", "vz"}, [&](const auto& block) {
        add("x of the first atom", block.real("x")[0], 1.5);
        add("z of the second atom", block.real("z")[1], 5);
        add("vz with a scale_factor", block.real("vz")[0], -2 * 20.455);
        add("vy with a scale_factor", block.real("vy")[1], 0.5 * 20.455);
        add("id without a variable for it", static_cast<double>(block.integer("id")[1]), 2);
      });
  add("time", header.time.value_or(-1), 0.375);
  add("edge a", header.box.edges(0, 0), 8);
  add("edge b, x, at 60 degrees", header.box.edges(0, 1), 4 * 0.5, 15);
  add("edge b, y, at 60 degrees", header.box.edges(1, 1), 4 * std::sqrt(0.75), 15);
  add("edge c, x, at 90 degrees", header.box.edges(0, 2), 0);
  add("edge c, z", header.box.edges(2, 2), 16, 15);
  return answers;
}

}  // namespace mdana
