// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/check_values.hpp"

#include <array>
#include <cmath>
#include <span>

#include <Eigen/LU>
#include <fmt/format.h>

#include "readers/columns.hpp"
#include "readers/frame_layout.hpp"

namespace mdana {
namespace {

/// Scaled positions of wrapped atoms are in 0 to 1; between two rebuilds of its neighbour lists
/// LAMMPS lets atoms leave by some skin, which is far less than half a box.
constexpr double far_outside = 0.5;

bool is_far_outside(double scaled) { return scaled < -far_outside || scaled > 1 + far_outside; }

class ValueCheck {
 public:
  ValueCheck(const FrameHeader& header, const Chunk& chunk, const AtomBlock& block,
             BlockFaults& faults, ColumnFaults& of_columns)
      : header_(header), chunk_(chunk), block_(block), faults_(faults), of_columns_(of_columns) {}

  void run() {
    for (const std::string& column : header_.columns)
      if (kind_of_column(column) == ColumnKind::real) finite(column);
    if (header_.has_column("type")) types();
    if (header_.has_column("mass")) masses();
    if (!header_.box.any_periodic()) return;
    if (has_all({"x", "y", "z"})) positions();
    if (has_all({"xs", "ys", "zs"})) scaled_positions();
  }

 private:
  bool has_all(const std::array<const char*, 3>& names) const {
    for (const char* name : names)
      if (!header_.has_column(name)) return false;
    return true;
  }

  template <class Values, class Wrong, class Tell>
  void each(const Values& values, Wrong&& wrong, Tell&& tell) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (wrong(values[i]) && faults_.usable(i)) tell(i);
  }

  void of_column(FaultKind kind, std::size_t atom, const std::string& column, double value) {
    of_columns_.add(
        fault_at(kind, chunk_, atom, fmt::format("{} in column {}", value, column), column));
  }

  void finite(const std::string& column) {
    const auto values = block_.real(column);
    each(values, [](double v) { return !std::isfinite(v); },
         [&](std::size_t i) { of_column(FaultKind::not_finite, i, column, values[i]); });
  }

  void types() {
    const auto values = block_.integer("type");
    each(values, [](std::int64_t v) { return v < 1; },
         [&](std::size_t i) { at(FaultKind::type, i, fmt::format("type {}", values[i]), "type"); });
  }

  void masses() {
    const auto values = block_.real("mass");
    each(values, [](double v) { return v <= 0; },
         [&](std::size_t i) { at(FaultKind::mass, i, fmt::format("mass {}", values[i]), "mass"); });
  }

  void at(FaultKind kind, std::size_t atom, std::string what, const char* column) {
    faults_.faults.add(fault_at(kind, chunk_, atom, std::move(what), column));
  }

  void positions() {
    const Eigen::Matrix3d to_scaled = header_.box.edges.inverse();
    const std::array<std::string, 3> names{"x", "y", "z"};
    const auto x = block_.real("x"), y = block_.real("y"), z = block_.real("z");
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Eigen::Vector3d position(x[i], y[i], z[i]);
      const Eigen::Vector3d scaled = to_scaled * (position - header_.box.origin);
      for (int k = 0; k < 3; ++k)
        if (header_.box.periodic[k] && is_far_outside(scaled[k]) && position.allFinite() &&
            faults_.usable(i))
          of_column(FaultKind::outside_box, i, names[k], position[k]);
    }
  }

  void scaled_positions() {
    const std::array<std::string, 3> names{"xs", "ys", "zs"};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!header_.box.periodic[k]) continue;
      const auto values = block_.real(names[k]);
      each(values, [](double v) { return std::isfinite(v) && is_far_outside(v); },
           [&](std::size_t i) { of_column(FaultKind::outside_box, i, names[k], values[i]); });
    }
  }

  const FrameHeader& header_;
  const Chunk& chunk_;
  const AtomBlock& block_;
  BlockFaults& faults_;
  ColumnFaults& of_columns_;
};

}  // namespace

void ColumnFaults::add(Fault fault) {
  const auto [it, is_new] = first_.try_emplace({fault.kind, fault.column}, fault);
  if (!is_new) it->second.times += fault.times;
}

void ColumnFaults::add(const ColumnFaults& later) {
  for (const auto& [key, fault] : later.first_) add(fault);
}

void ColumnFaults::settle(std::uint64_t frame, std::int64_t step, std::string_view file) {
  for (auto& [key, fault] : first_) {
    fault.frame = frame;
    fault.step = step;
    if (fault.file.empty()) fault.file = file;
  }
}

void ColumnFaults::tell(Faults& faults) const {
  for (const auto& [key, first] : first_) {
    Fault fault = first;
    if (fault.times > 1) fault.what += fmt::format("; it is the first of {} values", fault.times);
    faults.add(std::move(fault));
  }
}

void check_values(const FrameHeader& header, const Chunk& chunk, const AtomBlock& block,
                  BlockFaults& faults, ColumnFaults& of_columns) {
  if (!faults.all_unusable) ValueCheck(header, chunk, block, faults, of_columns).run();
}

Fault fault_at(FaultKind kind, const Chunk& chunk, std::size_t atom, std::string what,
               std::string column) {
  const AtomPlace place = place_of(chunk, atom);
  Fault fault;
  fault.kind = kind;
  fault.what = std::move(what);
  fault.file = place.file;
  if (place.line) fault.line = place.line;
  if (place.atom) fault.atom = place.atom;
  fault.column = std::move(column);
  return fault;
}

}  // namespace mdana
