// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/hdf5/call.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::hdf5 {
namespace {

herr_t keep_first(unsigned, const H5E_error2_t* error, void* text) {
  auto& kept = *static_cast<std::string*>(text);
  if (kept.empty() && error->desc) kept = error->desc;
  return 0;
}

}  // namespace

Handle::~Handle() {
  if (id_ >= 0) H5Idec_ref(id_);
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void quiet() {
  H5dont_atexit();  // closing at exit what could not be written crashes (1.10); all is closed long before
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string reason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
  // Of failed system calls HDF5 tells time, addresses and sizes, too.
  constexpr std::string_view by_system = "error message = '";
  if (const std::size_t at = text.find(by_system); at != text.npos) {
    text.erase(0, at + by_system.size());
    text.resize(std::min(text.find('\''), text.size()));
  }
  return text.empty() ? "HDF5 gives no reason" : text;
}

void fail_reading(const std::string& place, std::string_view doing) {
  throw InputError(fmt::format("{}: cannot {}: {}", place, doing, reason()));
}

void fail_writing(const std::string& place, std::string_view doing) {
  throw std::runtime_error(fmt::format("{}: cannot {}: {}", place, doing, reason()));
}

Kind kind_of(Id type) {
  switch (H5Tget_class(type)) {
    case H5T_FLOAT: return Kind::real;
    case H5T_INTEGER:
    case H5T_ENUM: return Kind::integer;
    case H5T_STRING: return Kind::text;
    default: return Kind::other;
  }
}

std::size_t elements_of(Id space, std::size_t most, const std::string& place) {
  const auto count = read_ok(H5Sget_simple_extent_npoints(space), place);
  if (static_cast<std::uint64_t>(count) > most)
    throw InputError(fmt::format("{}: {} values, more than make sense here", place, count));
  return static_cast<std::size_t>(count);
}

std::vector<hsize_t> chunk_of(Id layout, std::size_t rank, const std::string& place) {
  std::vector<hsize_t> chunk(std::max<std::size_t>(rank, 1));
  const int found = read_ok(H5Pget_chunk(layout, static_cast<int>(chunk.size()), chunk.data()), place);
  if (rank == 0 || static_cast<std::size_t>(found) != rank || std::ranges::count(chunk, hsize_t{0}) > 0)
    throw InputError(fmt::format("{}: the shape of its chunks is not that of data", place));
  return chunk;
}

Handle text_type(std::size_t width) {
  Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.id(), std::max<std::size_t>(width, 1));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

std::string padded(std::span<const std::string> values, std::size_t width) {
  std::string bytes;
  for (const std::string& value : values) {
    bytes += value.substr(0, width);
    bytes.resize(bytes.size() + width - std::min(value.size(), width), '\0');
  }
  return bytes;
}

std::vector<std::string> unpadded(const std::string& bytes, Id type) {
  const std::size_t width = H5Tget_size(type);
  const bool blanks = H5Tget_strpad(type) == H5T_STR_SPACEPAD;
  std::vector<std::string> values;
  for (std::size_t at = 0; at + width <= bytes.size(); at += width) {
    std::string value = bytes.substr(at, width);
    value.resize(std::min(value.find('\0'), value.size()));
    if (blanks) value.resize(value.find_last_not_of(' ') + 1);
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace mdana::hdf5
