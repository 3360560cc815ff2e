// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "readers/hdf5/call.hpp"
#include "readers/input_error.hpp"

namespace mdana::hdf5 {
namespace {

constexpr std::uint64_t most_links = 1 << 14;  ///< in a group

// Bytes of a dataset's cache of chunks: HDF5's own default, and all that a dataset may take.
constexpr std::uint64_t least_cache = 1 << 20;
constexpr std::uint64_t most_cache = std::uint64_t{1} << 28;
constexpr std::size_t cache_slots = 12421;  ///< a prime, well above the number of chunks

std::string place_in(const Group& group, const std::string& name) {
  return group.place() + (group.place().ends_with('/') ? "" : "/") + name;
}

[[noreturn]] void fail_elsewhere(const std::string& place) {
  throw InputError(fmt::format("{}: stands in another file, which is not read; make one file of the two",
                               place));
}

herr_t refuse(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) { return -1; }

/// Access to objects that follows no link to another file, of which no record would tell.
Handle within_file(Id property_class) {
  Handle access(H5Pcreate(property_class));
  H5Pset_elink_cb(access.id(), refuse, nullptr);
  return access;
}

/// The object of that name, or nothing that is open.
Handle opened(const Group& group, const std::string& name) {
  quiet();
  if (H5Lexists(group.id(), name.c_str(), H5P_DEFAULT) <= 0) return {};
  H5L_info_t link;
  read_ok(H5Lget_info(group.id(), name.c_str(), &link, H5P_DEFAULT), place_in(group, name));
  if (link.type == H5L_TYPE_EXTERNAL) fail_elsewhere(place_in(group, name));
  const Handle access = within_file(H5P_LINK_ACCESS);
  if (H5Oexists_by_name(group.id(), name.c_str(), access.id()) <= 0) return {};
  return Handle(read_ok(H5Oopen(group.id(), name.c_str(), access.id()), place_in(group, name)));
}

/// Throws InputError if a dataset's values stand in other files.
void expect_own_values(const Dataset& d) {
  const Handle layout(read_ok(H5Dget_create_plist(d.id()), d.place()));
  if (H5Pget_layout(layout.id()) == H5D_VIRTUAL || H5Pget_external_count(layout.id()) > 0)
    fail_elsewhere(d.place());
}

bool is(const Handle& object, H5I_type_t type) {
  return object.id() >= 0 && H5Iget_type(object.id()) == type;
}

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? ~std::uint64_t{0} : result;
}

/// Bytes of the chunks that one row of the first axis touches, if they span several rows; else of
/// one chunk. None if the dataset is not chunked.
std::uint64_t wanted_cache(const Dataset& d) {
  const Handle layout(read_ok(H5Dget_create_plist(d.id()), d.place()));
  if (H5Pget_layout(layout.id()) != H5D_CHUNKED) return 0;
  const Shape shape = d.shape();
  const std::vector<hsize_t> chunk = chunk_of(layout.id(), shape.size(), d.place());
  const Handle type(read_ok(H5Dget_type(d.id()), d.place()));
  std::uint64_t bytes = H5Tget_size(type.id());
  for (const hsize_t n : chunk) bytes = product(bytes, n);
  if (bytes > most_cache && H5Pget_nfilters(layout.id()) > 0)
    throw InputError(fmt::format("{}: compressed chunks of {} MB (at most {} MB are read); h5repack "
                                 "makes smaller ones",
                                 d.place(), bytes >> 20, most_cache >> 20));
  if (chunk.front() > 1)
    for (std::size_t k = 1; k < chunk.size(); ++k)
      bytes = product(bytes, (shape[k] + chunk[k] - 1) / chunk[k]);
  return bytes;
}

Handle without_times(Id property_class) {
  Handle list(H5Pcreate(property_class));
  H5Pset_obj_track_times(list.id(), false);
  return list;
}

Id file_type(const NewDataset& wanted) {
  return wanted.kind == Kind::real ? H5T_IEEE_F64LE : H5T_STD_I64LE;
}

Handle space_of(const NewDataset& wanted) {
  if (wanted.shape.empty()) return Handle(H5Screate(H5S_SCALAR));
  const std::vector<hsize_t> size(wanted.shape.begin(), wanted.shape.end());
  const std::vector<hsize_t> any(size.size(), H5S_UNLIMITED);
  return Handle(H5Screate_simple(static_cast<int>(size.size()), size.data(),
                                 wanted.chunk.empty() ? nullptr : any.data()));
}

Handle layout_of(const NewDataset& wanted) {
  Handle list = without_times(H5P_DATASET_CREATE);
  if (!wanted.chunk.empty()) {
    const std::vector<hsize_t> chunk(wanted.chunk.begin(), wanted.chunk.end());
    H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), chunk.data());
    if (wanted.deflate > 0) {
      H5Pset_shuffle(list.id());
      H5Pset_deflate(list.id(), wanted.deflate);
    }
  }
  if (wanted.fill) H5Pset_fill_value(list.id(), H5T_NATIVE_INT64, &*wanted.fill);
  return list;
}

}  // namespace

std::vector<std::string> Group::names() const {
  quiet();
  H5G_info_t info;
  read_ok(H5Gget_info(id(), &info), place());
  if (info.nlinks > most_links)
    throw InputError(fmt::format("{}: {} objects in this group, more than make sense", place(),
                                 info.nlinks));
  const Handle list(read_ok(H5Gget_create_plist(id()), place()));
  unsigned order = 0;
  if (H5Pget_link_creation_order(list.id(), &order) < 0) order = 0;
  const auto index = order & H5P_CRT_ORDER_TRACKED ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  std::vector<std::string> names;
  for (hsize_t k = 0; k < info.nlinks; ++k) {
    const auto name_of = [&](char* into, std::size_t room) {
      return read_ok(H5Lget_name_by_idx(id(), ".", index, H5_ITER_INC, k, into, room, H5P_DEFAULT),
                     place());
    };
    std::string name(static_cast<std::size_t>(name_of(nullptr, 0)), '\0');
    name_of(name.data(), name.size() + 1);
    names.push_back(std::move(name));
  }
  return names;
}

bool Group::has_group(const std::string& name) const { return is(opened(*this, name), H5I_GROUP); }

bool Group::has_dataset(const std::string& name) const {
  return is(opened(*this, name), H5I_DATASET);
}

Group Group::group(const std::string& name) const {
  Handle object = opened(*this, name);
  if (!is(object, H5I_GROUP))
    throw InputError(fmt::format("{}: there is no such group", place_in(*this, name)));
  return {std::move(object), place_in(*this, name)};
}

Dataset Group::dataset(const std::string& name) const {
  const std::string place = place_in(*this, name);
  Handle object = opened(*this, name);
  if (!is(object, H5I_DATASET))
    throw InputError(fmt::format("{}: there is no such dataset", place));
  Dataset plain(std::move(object), place);
  expect_own_values(plain);
  const std::uint64_t cache = wanted_cache(plain);
  if (cache <= least_cache) return plain;
  const Handle access = within_file(H5P_DATASET_ACCESS);
  H5Pset_chunk_cache(access.id(), cache_slots, std::min(cache, most_cache), 1.0);
  plain = Dataset(Handle{}, place);  // HDF5 takes the cache's size from who opens it first
  return {Handle(read_ok(H5Dopen2(id(), name.c_str(), access.id()), place)), place};
}

Group Group::make_group(const std::string& name, bool track_order) {
  quiet();
  const std::string place = place_in(*this, name);
  const Handle list = without_times(H5P_GROUP_CREATE);
  if (track_order)
    H5Pset_link_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return {Handle(write_ok(H5Gcreate2(id(), name.c_str(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
                          place, "create")),
          place};
}

Dataset Group::make_dataset(const std::string& name, const NewDataset& wanted) {
  quiet();
  const std::string place = place_in(*this, name);
  const Handle text = text_type(wanted.width);
  const Handle space = space_of(wanted), layout = layout_of(wanted);
  const Id type = wanted.kind == Kind::text ? text.id() : file_type(wanted);
  return {Handle(write_ok(H5Dcreate2(id(), name.c_str(), type, space.id(), H5P_DEFAULT, layout.id(),
                                     H5P_DEFAULT),
                          place, "create")),
          place};
}

void Group::link(const std::string& name, const Object& object) {
  quiet();
  write_ok(H5Olink(object.id(), id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
           place_in(*this, name), "link");
}

}  // namespace mdana::hdf5
