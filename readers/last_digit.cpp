// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/last_digit.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

#include "readers/positions.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

/// SplitMix64 (Steele, Lea & Flood 2014): a well-mixed 64-bit hash of a counter.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0;
  for (const char c : text) h = mix(h ^ static_cast<unsigned char>(c));
  return h;
}

/// Uniform in [-1/2, 1/2).
double uniform(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53 - 0.5; }

/// One unit in the last printed digit of the value.
double last_digit_unit(double value, const PrintedPrecision& printed) {
  if (value == 0 || !std::isfinite(value)) return 0;
  if (printed.fixed) return std::pow(10.0, -printed.decimals);
  return std::pow(10.0, std::floor(std::log10(std::abs(value))) - printed.digits + 1);
}

/// The move of an atom's value as it is printed.
using Move = std::function<double(std::size_t atom, double value)>;
using MoveOfColumn = std::function<Move(const std::string& column)>;

/// At random within the last printed digit.
Move random_move(const Chunk& chunk, std::int64_t step, std::uint64_t seed, std::string_view column) {
  const PrintedPrecision printed = chunk.layout->printed_precision(chunk, column);
  const std::uint64_t start = mix(mix(mix(seed) ^ static_cast<std::uint64_t>(step)) ^ hash(column)) +
                              chunk.number * AtomBlock::capacity;
  return [=](std::size_t atom, double value) {
    return printed.digits == 0 ? 0.0 : uniform(mix(start + atom)) * last_digit_unit(value, printed);
  };
}

/// To the nearest number with fewer digits. Numbers that are no decimal text count as of 17 digits.
Move rounding_move(const Chunk& chunk, int dropped, std::string_view column) {
  PrintedPrecision printed = chunk.layout->printed_precision(chunk, column);
  if (printed.digits == 0) printed = {17, 0, false};
  return [=](std::size_t, double value) {
    const double unit = last_digit_unit(value, printed) * std::pow(10.0, dropped);
    return unit > 0 ? std::nearbyint(value / unit) * unit - value : 0.0;
  };
}

Eigen::Vector3d image_of(const AtomBlock& block, std::size_t i) {
  return {static_cast<double>(block.integer("ix")[i]), static_cast<double>(block.integer("iy")[i]),
          static_cast<double>(block.integer("iz")[i])};
}

void move_positions(const PositionSource& positions, const Box& box, AtomBlock& block,
                    const MoveOfColumn& moves_of) {
  const std::array<Move, 3> moves{moves_of(positions.columns[0]), moves_of(positions.columns[1]),
                                   moves_of(positions.columns[2])};
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  std::array<std::span<const double>, 3> raw{x, y, z};
  if (positions.columns[0] != "x")
    for (std::size_t k = 0; k < 3; ++k) raw[k] = block.real(positions.columns[k]);
  for (std::size_t i = 0; i < block.atoms(); ++i) {
    const Eigen::Vector3d image = positions.image_flags && !positions.scaled
                                      ? Eigen::Vector3d(box.edges * image_of(block, i))
                                      : Eigen::Vector3d::Zero();
    Eigen::Vector3d move;
    for (std::size_t k = 0; k < 3; ++k)
      move[static_cast<int>(k)] = moves[k](i, raw[k][i] - image[static_cast<int>(k)]);
    if (positions.scaled) move = box.edges * move;
    x[i] += move.x();
    y[i] += move.y();
    z[i] += move.z();
  }
}

void move_columns(const FrameHeader& header, const ColumnSet& wanted, const MoveOfColumn& moves_of, AtomBlock& block) {
  const auto positions = position_source(header.columns);
  if (wanted.has("x") && positions) move_positions(*positions, header.box, block, moves_of);
  for (const std::string& column : wanted.names()) {
    const bool position = column == "x" || column == "y" || column == "z";
    if (position || column == "mass" || kind_of_column(column) != ColumnKind::real)
      continue;
    const Move move = moves_of(column);
    const auto values = block.make_real(column);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += move(i, values[i]);
  }
}

}  // namespace

void move_last_digits(const Chunk& chunk, const FrameHeader& header, const ColumnSet& wanted,
                      std::uint64_t seed, AtomBlock& block) {
  move_columns(header, wanted,
               [&](const std::string& column) { return random_move(chunk, header.step, seed, column); }, block);
}

void drop_digits(const Chunk& chunk, const FrameHeader& header, const ColumnSet& wanted, int dropped, AtomBlock& block) {
  move_columns(header, wanted, [&](const std::string& column) { return rounding_move(chunk, dropped, column); }, block);
}

double rounding_of(const std::filesystem::path& dump, const std::string& column, int dropped) {
  FrameHeader header;
  if (!open_trajectory(dump, {})->next(header)) return 0;
  std::string printed_as = column;
  double length = 1;  // of one unit of the printed numbers
  if (column == "x") {
    const auto positions = position_source(header.columns);
    if (!positions) return 0;
    printed_as = positions->columns[0];
    if (positions->scaled) length = header.box.edges.row(0).norm();
  }
  const auto source = open_trajectory(dump, {printed_as});
  Chunk chunk;
  if (!source->next(header) || !source->cut(chunk)) return 0;
  PrintedPrecision printed = chunk.layout->printed_precision(chunk, printed_as);
  if (printed.digits == 0 && dropped == 0) return 0;
  if (printed.digits == 0) printed = {17, 0, false};
  AtomBlock block;
  convert(chunk, block);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double squares = 0;
  for (const double value : block.real(printed_as)) {
    const double unit = last_digit_unit(value, printed) * std::pow(10.0, dropped);
    if (unit > epsilon * std::abs(value)) squares += unit * unit;  // else every bit is told
  }
  return length * std::sqrt(squares / (12 * static_cast<double>(block.atoms())));
}

}  // namespace mdana
