// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/added_columns.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "readers/positions.hpp"

namespace mdana {
namespace {

/// The block's positions by mdana's rule: a copy, as its own x y z stay as they stand.
void make_unwrapped(const FrameHeader& frame, AtomBlock& block) {
  const auto source = position_source(frame.columns);
  if (!source) throw InputError("no position columns (x y z, xs, xu or xsu) to unwrap");
  AtomBlock own;
  own.reset(block.number(), block.atoms());
  for (const std::string& name : source->columns)
    std::ranges::copy(block.real(name), own.make_real(name).begin());
  if (source->image_flags)
    for (const char* name : {"ix", "iy", "iz"})
      std::ranges::copy(block.integer(name), own.make_integer(name).begin());
  make_positions(*source, frame.box, own);
  for (const char* axis : {"x", "y", "z"})
    std::ranges::copy(own.real(axis), block.make_real(std::string(axis) + "u").begin());
}

}  // namespace

AddedColumns added_bodies(Bodies bodies) {
  const ColumnSet needs = bodies.columns();
  return {{"c_mdana_body"}, needs, [bodies = std::move(bodies)](const FrameHeader&, auto& block) {
            std::vector<BodyIndex> body;
            bodies.label(block, body);
            std::ranges::copy(body, block.make_real("c_mdana_body").begin());
          }};
}

AddedColumns added_masses(Masses masses) {
  const ColumnSet needs = masses.columns();
  return {{"c_mdana_mass"}, needs, [masses = std::move(masses)](const FrameHeader&, auto& block) {
            std::vector<double> mass;
            masses.fill(block, mass);
            std::ranges::copy(mass, block.make_real("c_mdana_mass").begin());
          }};
}

AddedColumns added_kinetic_energy(Masses masses, Units units) {
  ColumnSet needs{"vx", "vy", "vz"};
  needs.add(masses.columns());
  const double half = 0.5 * force_per_mass_acceleration(units);
  return {{"c_mdana_ke"},
          needs,
          [masses = std::move(masses), half](const FrameHeader&, AtomBlock& block) {
            std::vector<double> mass;
            masses.fill(block, mass);
            const auto energy = block.make_real("c_mdana_ke");
            const auto vx = block.real("vx"), vy = block.real("vy"), vz = block.real("vz");
            for (std::size_t i = 0; i < energy.size(); ++i)
              energy[i] = half * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i]);
          }};
}

AddedColumns added_unwrapped() { return {{"xu", "yu", "zu"}, {}, make_unwrapped}; }

void check_added(const AddedColumns& added, const FrameHeader& frame) {
  for (const std::string& name : added.needs.names())
    if (!frame.has_column(name))
      throw InputError(fmt::format("{}: no column '{}', which {} is made of", frame.place, name,
                                   added.names[0]));
  for (const std::string& name : added.names)
    if (frame.has_column(name))
      throw InputError(fmt::format("{}: the frame has a column '{}' already; it cannot be added",
                                   frame.place, name));
}

}  // namespace mdana
