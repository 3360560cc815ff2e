// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "readers/hdf5/call.hpp"
#include "readers/input_error.hpp"

namespace mdana::hdf5 {
namespace {

constexpr std::size_t longest_text = 1024;  ///< in bytes, of a dataset's texts of one width
constexpr std::size_t longest_alone = std::size_t{4} << 20;  ///< of a single one: a document

Handle type_of(const Dataset& d) { return Handle(read_ok(H5Dget_type(d.id()), d.place())); }

struct Selection {
  Handle file, memory;
  std::size_t count = 1;
};

/// Throws InputError if the slab reaches beyond the dataset.
Selection select(const Dataset& d, const Slab& slab) {
  quiet();
  Selection s{Handle(read_ok(H5Dget_space(d.id()), d.place())), {}, 1};
  if (slab.first.empty()) {
    s.memory = Handle(H5Screate(H5S_SCALAR));
    return s;
  }
  const std::vector<hsize_t> first(slab.first.begin(), slab.first.end());
  const std::vector<hsize_t> count(slab.count.begin(), slab.count.end());
  for (const auto n : slab.count) s.count *= static_cast<std::size_t>(n);
  read_ok(H5Sselect_hyperslab(s.file.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(),
                              nullptr),
          d.place());
  if (H5Sselect_valid(s.file.id()) <= 0)
    throw InputError(fmt::format("{}: the data end before what is wanted of them", d.place()));
  const hsize_t all = s.count;
  s.memory = Handle(H5Screate_simple(1, &all, nullptr));
  return s;
}

void read_numbers(const Dataset& d, const Slab& slab, Id type, std::size_t room, void* into) {
  const Selection s = select(d, slab);
  if (s.count != room) throw std::logic_error("hdf5::Dataset::read: wrong length");
  read_ok(H5Dread(d.id(), type, s.memory.id(), s.file.id(), H5P_DEFAULT, into), d.place());
}

void write_values(const Dataset& d, const Slab& slab, Id type, std::size_t room,
                  const void* values) {
  const Selection s = select(d, slab);
  if (s.count != room) throw std::logic_error("hdf5::Dataset::write: wrong length");
  write_ok(H5Dwrite(d.id(), type, s.memory.id(), s.file.id(), H5P_DEFAULT, values), d.place());
}

/// HDF5 makes the largest signed number of unsigned ones that are too large.
void check_range(const Dataset& d, std::span<const std::int64_t> values) {
  const Handle type = type_of(d);
  const bool may_clip = H5Tget_class(type.id()) == H5T_INTEGER && H5Tget_size(type.id()) >= 8 &&
                        H5Tget_sign(type.id()) == H5T_SGN_NONE;
  constexpr auto largest = std::numeric_limits<std::int64_t>::max();
  if (may_clip && std::ranges::find(values, largest) != values.end())
    throw InputError(fmt::format("{}: a number is not below 2^63 - 1", d.place()));
}

bool chunk_stored(const Dataset& d, const Shape& place) {
  const std::vector<hsize_t> at(place.begin(), place.end());
  const Handle layout(read_ok(H5Dget_create_plist(d.id()), d.place()));
  const std::vector<hsize_t> chunk = chunk_of(layout.id(), at.size(), d.place());
  std::vector<hsize_t> corner(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) corner[k] = at[k] / chunk[k] * chunk[k];
  unsigned filters = 0;
  haddr_t address = HADDR_UNDEF;
  hsize_t size = 0;
  return H5Dget_chunk_info_by_coord(d.id(), corner.data(), &filters, &address, &size) >= 0 &&
         address != HADDR_UNDEF;
}

}  // namespace

Kind Dataset::kind() const { return kind_of(type_of(*this).id()); }

Shape Dataset::shape() const {
  const Handle space(read_ok(H5Dget_space(id()), place()));
  const int rank = read_ok(H5Sget_simple_extent_ndims(space.id()), place());
  std::vector<hsize_t> size(static_cast<std::size_t>(rank));
  if (rank > 0) read_ok(H5Sget_simple_extent_dims(space.id(), size.data(), nullptr), place());
  return {size.begin(), size.end()};
}

std::optional<std::int64_t> Dataset::fill_integer() const {
  const Handle layout(read_ok(H5Dget_create_plist(id()), place()));
  H5D_fill_value_t defined = H5D_FILL_VALUE_UNDEFINED;
  read_ok(H5Pfill_value_defined(layout.id(), &defined), place());
  if (defined != H5D_FILL_VALUE_USER_DEFINED || kind() != Kind::integer) return std::nullopt;
  std::int64_t value = 0;
  read_ok(H5Pget_fill_value(layout.id(), H5T_NATIVE_INT64, &value), place());
  return value;
}

bool Dataset::stored(const Shape& element) const {
  quiet();
  const Handle layout(read_ok(H5Dget_create_plist(id()), place()));
  const auto kind = H5Pget_layout(layout.id());
  if (kind == H5D_CHUNKED) return chunk_stored(*this, element);
  return kind == H5D_COMPACT || H5Dget_storage_size(id()) > 0;
}

void Dataset::read(const Slab& slab, std::span<double> into) const {
  read_numbers(*this, slab, H5T_NATIVE_DOUBLE, into.size(), into.data());
}

void Dataset::read(const Slab& slab, std::span<std::int64_t> into) const {
  read_numbers(*this, slab, H5T_NATIVE_INT64, into.size(), into.data());
  check_range(*this, into);
}

std::vector<std::string> Dataset::read_texts(const Slab& slab) const {
  const Selection s = select(*this, slab);
  const Handle type = type_of(*this);
  if (H5Tis_variable_str(type.id()) > 0) {
    std::vector<char*> pointers(s.count, nullptr);
    read_ok(H5Dread(id(), type.id(), s.memory.id(), s.file.id(), H5P_DEFAULT, pointers.data()),
            place());
    std::vector<std::string> values;
    for (const char* text : pointers) values.emplace_back(text ? text : "");
    H5Dvlen_reclaim(type.id(), s.memory.id(), H5P_DEFAULT, pointers.data());
    return values;
  }
  const std::size_t longest = s.count == 1 ? longest_alone : longest_text;
  if (H5Tget_size(type.id()) > longest)
    throw InputError(fmt::format("{}: texts of {} bytes (at most {} are read)", place(),
                                 H5Tget_size(type.id()), longest));
  std::string bytes(s.count * H5Tget_size(type.id()), '\0');
  read_ok(H5Dread(id(), type.id(), s.memory.id(), s.file.id(), H5P_DEFAULT, bytes.data()), place());
  return unpadded(bytes, type.id());
}

void Dataset::write(const Slab& slab, std::span<const double> values) {
  write_values(*this, slab, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

void Dataset::write(const Slab& slab, std::span<const std::int64_t> values) {
  write_values(*this, slab, H5T_NATIVE_INT64, values.size(), values.data());
}

void Dataset::write(const Slab& slab, std::span<const std::string> values) {
  const Handle type = type_of(*this);
  const std::size_t width = H5Tget_size(type.id());
  for (const std::string& value : values)
    if (value.size() > width)
      throw InputError(fmt::format("{}: '{}' is longer than {} bytes", place(), value, width));
  write_values(*this, slab, type.id(), values.size(), padded(values, width).data());
}

void Dataset::extend(const Shape& shape) {
  const std::vector<hsize_t> size(shape.begin(), shape.end());
  write_ok(H5Dset_extent(id(), size.data()), place());
}

}  // namespace mdana::hdf5
