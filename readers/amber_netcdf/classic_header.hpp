// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mdana::amber_netcdf {

/// The types of netCDF's classic formats, by their numbers in the file.
enum class Type {
  int8 = 1,
  character,
  int16,
  int32,
  float32,
  float64,
  uint8,
  uint16,
  uint32,
  int64,
  uint64
};

std::uint64_t size_of(Type type);  ///< [bytes]

/// One index of netCDF's arrays (there called dimension).
struct Axis {
  std::string name;
  std::uint64_t length = 0;  ///< 0: grows with the records
};

struct Variable {
  std::string name;
  std::vector<std::size_t> axes;  ///< slowest first
  Type type;
  std::uint64_t begin;  ///< of its numbers, or of those of the first record [bytes]
  std::uint64_t bytes;  ///< of all of them, or of one record; at most 2^64 - 1
  bool in_records;
};

/// The header of a file in netCDF's classic formats CDF-1, -2 or -5 (netCDF users' guide, appendix
/// "File format specifications"). Variables have their numbers of netCDF's interface.
struct ClassicHeader {
  std::vector<Axis> axes;
  std::vector<Variable> variables;
  std::uint64_t records = 0;       ///< as the header says
  std::uint64_t record_bytes = 0;  ///< from one record to the next; at most 2^64 - 1
  std::uint64_t file_bytes = 0;    ///< that are there

  std::optional<std::size_t> axis(std::string_view name) const;
  std::optional<std::size_t> variable(std::string_view name) const;

  bool fixed_part_is_whole() const;
  std::uint64_t whole_records() const;  ///< of `records`, if the fixed part is whole
  std::uint64_t end_of_records(std::uint64_t count) const;  ///< [bytes], at most 2^64 - 1
};

/// Throws TruncatedInput if the file ends within the header and InputError if it is wrong; reads
/// nothing behind it. What passes can be opened by netCDF's library without surprises.
ClassicHeader read_classic_header(const std::filesystem::path& path);

}  // namespace mdana::amber_netcdf
