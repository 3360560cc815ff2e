// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "readers/amber_netcdf/classic_header.hpp"

namespace mdana::amber_netcdf {

/// A file that netCDF's library has opened. Its calls are serial.
class NetcdfFile {
 public:
  static constexpr int whole_file = -1;  ///< instead of a variable: the attributes of the file

  /// Throws InputError if the library cannot open it.
  explicit NetcdfFile(const std::filesystem::path& path);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  /// An attribute, if there is one. Throws InputError if it is of another kind.
  std::optional<std::string> text(int variable, const char* attribute) const;
  std::optional<double> number(int variable, const char* attribute) const;

  /// The bytes that stand where nothing was written to a variable: its attribute _FillValue, else
  /// netCDF's own value; none for types of one byte, of which every value may be meant.
  std::string fill(int variable, Type type) const;

  /// Numbers of a variable as they stand there; `into` is aligned for their type.
  void read(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
            void* into) const;

  /// The same as real numbers, unscaled.
  std::vector<double> numbers(int variable, std::span<const std::size_t> start,
                              std::span<const std::size_t> count) const;

 private:
  void check(int status, int variable, const char* what) const;

  std::string path_;
  int id_ = -1;
};

}  // namespace mdana::amber_netcdf
