// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <hdf5.h>

#include "readers/hdf5.hpp"

namespace mdana::hdf5 {

/// Turns off HDF5's printing of errors.
void quiet();

/// HDF5's innermost reason for the last failure.
std::string reason();

[[noreturn]] void fail_reading(const std::string& place, std::string_view doing);
[[noreturn]] void fail_writing(const std::string& place, std::string_view doing);

/// The result of a call of HDF5 unless it says that it failed.
template <class Result>
Result read_ok(Result result, const std::string& place, std::string_view doing = "read") {
  if (result < 0) fail_reading(place, doing);
  return result;
}

template <class Result>
Result write_ok(Result result, const std::string& place, std::string_view doing = "write") {
  if (result < 0) fail_writing(place, doing);
  return result;
}

Kind kind_of(Id type);

/// The number of elements of a dataspace. Throws InputError beyond `most`.
std::size_t elements_of(Id space, std::size_t most, const std::string& place);

/// A type of texts in UTF-8, padded by zeros.
/// Lengths of a chunk along the axes of a dataset of that rank, none of which is 0.
std::vector<hsize_t> chunk_of(Id layout, std::size_t rank, const std::string& place);

Handle text_type(std::size_t width);

/// Texts of one width out of those of any length.
std::string padded(std::span<const std::string> values, std::size_t width);

/// Texts out of memory as HDF5 read it by a type of the file, without their padding.
std::vector<std::string> unpadded(const std::string& bytes, Id type);

}  // namespace mdana::hdf5
