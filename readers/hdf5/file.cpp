// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "readers/hdf5/call.hpp"
#include "readers/input_error.hpp"

namespace mdana::hdf5 {
namespace {

Group root_of(Handle file, const std::string& path) {
  const std::string place = path + ": /";
  return {Handle(read_ok(H5Gopen2(file.id(), "/", H5P_DEFAULT), place, "open")), place};
}

}  // namespace

// The file stays open as long as an object in it is.
Group open_file(const std::filesystem::path& path) {
  quiet();
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (file.id() >= 0) return root_of(std::move(file), path.string());
  const std::string why = reason();
  const std::string text = fmt::format("{}: cannot open: {}", path.string(), why);
  if (why.find("truncated") != why.npos) throw TruncatedInput(text);
  throw InputError(text);
}

Group create_file(const std::filesystem::path& path) {
  quiet();
  const Handle list(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_obj_track_times(list.id(), false);
  Handle file(write_ok(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, list.id(), H5P_DEFAULT),
                       path.string(), "create"));
  return root_of(std::move(file), path.string());
}

void flush(const Object& object) {
  write_ok(H5Fflush(object.id(), H5F_SCOPE_LOCAL), object.place());
}

}  // namespace mdana::hdf5
