// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analyses/table.hpp"
#include "readers/hdf5.hpp"
#include "readers/units.hpp"

/// How results stand in HDF5 files; see reports/hdf5/hdf5.md. Only in builds with HDF5.
namespace mdana::hdf5 {

/// Numbers by their names, objects as groups; what an object with a value does not know is NaN.
void put_numbers(Group& group, const nlohmann::ordered_json& object);

/// A dataset a column, with its unit and dimension; labelled columns as texts.
void put_table(Group& group, const Table& table, Units units);

void put_text(Group& group, const std::string& name, const std::string& text);

}  // namespace mdana::hdf5
