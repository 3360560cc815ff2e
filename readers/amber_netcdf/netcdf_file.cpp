// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/amber_netcdf/netcdf_file.hpp"

#include <cstring>
#include <functional>
#include <numeric>

#include <fmt/format.h>
#include <netcdf.h>

#include "readers/input_error.hpp"

namespace mdana::amber_netcdf {
namespace {

static_assert(NetcdfFile::whole_file == NC_GLOBAL);

constexpr std::size_t bytes_at_once = std::size_t{1} << 16;  ///< of the library's buffers
constexpr std::size_t longest_text = 4096;                   ///< of an attribute
constexpr const char* fill_value = "_FillValue";

template <class T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string default_fill(Type type) {
  switch (type) {
    case Type::int16:
      return bytes_of(NC_FILL_SHORT);
    case Type::uint16:
      return bytes_of(NC_FILL_USHORT);
    case Type::int32:
      return bytes_of(NC_FILL_INT);
    case Type::uint32:
      return bytes_of(NC_FILL_UINT);
    case Type::int64:
      return bytes_of(NC_FILL_INT64);
    case Type::uint64:
      return bytes_of(NC_FILL_UINT64);
    case Type::float32:
      return bytes_of(NC_FILL_FLOAT);
    case Type::float64:
      return bytes_of(NC_FILL_DOUBLE);
    default:
      return {};
  }
}

}  // namespace

NetcdfFile::NetcdfFile(const std::filesystem::path& path) : path_(path.string()) {
  // An absolute path cannot be taken for the address of a server.
  const std::string absolute = std::filesystem::absolute(path).string();
  std::size_t buffer = bytes_at_once;
  check(nc__open(absolute.c_str(), NC_NOWRITE, &buffer, &id_), whole_file, "netCDF cannot open it");
}

NetcdfFile::~NetcdfFile() { nc_close(id_); }

void NetcdfFile::check(int status, int variable, const char* what) const {
  if (status == NC_NOERR) return;
  char name[NC_MAX_NAME + 1] = "";
  if (variable != whole_file) nc_inq_varname(id_, variable, name);
  throw InputError(
      fmt::format("{}: {}{}{}: {}", path_, name, *name ? ": " : "", what, nc_strerror(status)));
}

std::optional<std::string> NetcdfFile::text(int variable, const char* attribute) const {
  nc_type type;
  std::size_t length;
  const int status = nc_inq_att(id_, variable, attribute, &type, &length);
  if (status == NC_ENOTATT) return std::nullopt;
  check(status, variable, attribute);
  if (type != NC_CHAR || length > longest_text) check(NC_EBADTYPE, variable, attribute);
  std::string text(length, '\0');
  check(nc_get_att_text(id_, variable, attribute, text.data()), variable, attribute);
  text.erase(text.find_last_not_of(std::string(" \0", 2)) + 1);
  return text;
}

std::optional<double> NetcdfFile::number(int variable, const char* attribute) const {
  nc_type type;
  std::size_t length;
  const int status = nc_inq_att(id_, variable, attribute, &type, &length);
  if (status == NC_ENOTATT) return std::nullopt;
  check(status, variable, attribute);
  if (type == NC_CHAR || length != 1) check(NC_EBADTYPE, variable, attribute);
  double value = 0;
  check(nc_get_att_double(id_, variable, attribute, &value), variable, attribute);
  return value;
}

std::string NetcdfFile::fill(int variable, Type type) const {
  nc_type own;
  std::size_t length;
  const int status = nc_inq_att(id_, variable, fill_value, &own, &length);
  if (status == NC_ENOTATT) return default_fill(type);
  check(status, variable, fill_value);
  if (own != static_cast<nc_type>(type) || length != 1) check(NC_EBADTYPE, variable, fill_value);
  std::string bytes(size_of(type), '\0');
  check(nc_get_att(id_, variable, fill_value, bytes.data()), variable, fill_value);
  return bytes;
}

void NetcdfFile::read(int variable, std::span<const std::size_t> start,
                      std::span<const std::size_t> count, void* into) const {
  check(nc_get_vara(id_, variable, start.data(), count.data(), into), variable, "cannot be read");
}

std::vector<double> NetcdfFile::numbers(int variable, std::span<const std::size_t> start,
                                        std::span<const std::size_t> count) const {
  std::vector<double> values(
      std::accumulate(count.begin(), count.end(), std::size_t{1}, std::multiplies<>()));
  check(nc_get_vara_double(id_, variable, start.data(), count.data(), values.data()), variable,
        "cannot be read");
  return values;
}

}  // namespace mdana::amber_netcdf
