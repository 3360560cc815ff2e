// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/amber_netcdf/classic_header.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::amber_netcdf {
namespace {

// Of the tags before the header's lists.
constexpr std::uint64_t of_axes = 10, of_variables = 11, of_attributes = 12;

// More is a sign of damage: the first three are netCDF's own limits (netcdf.h, NC_MAX_*).
constexpr std::uint64_t most_entries = 8192;
constexpr std::uint64_t most_axes_of_variable = 1024;
constexpr std::uint64_t longest_name = 256;
constexpr std::uint64_t longest_header = std::uint64_t{1} << 26;

constexpr std::uint64_t infinite = std::numeric_limits<std::uint64_t>::max();

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > infinite / b ? infinite : a * b;
}

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return a > infinite - b ? infinite : a + b; }

std::uint64_t padded(std::uint64_t bytes) {
  return bytes > infinite - 3 ? infinite : (bytes + 3) / 4 * 4;
}

/// Reads the header's fields, big-endian.
class HeaderReader {
 public:
  explicit HeaderReader(const std::filesystem::path& path)
      : path_(path.string()), stream_(path, std::ios::binary) {
    header_.file_bytes = std::filesystem::file_size(path);
  }

  ClassicHeader read() {
    version();
    records();
    for (std::uint64_t left = list(of_axes, "dimensions"); left > 0; --left) axis();
    attributes();
    for (std::uint64_t left = list(of_variables, "variables"); left > 0; --left) variable();
    measure_records();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: byte {} of the netCDF header: {}", path_, position_, what));
  }

  void expect(std::uint64_t bytes) {
    if (sum(position_, bytes) > longest_header)
      fail(fmt::format("the header is longer than {} bytes", longest_header));
    if (position_ + bytes > header_.file_bytes)
      throw TruncatedInput(fmt::format("{}: the file ends within its header: {} bytes are there",
                                       path_, header_.file_bytes));
  }

  std::string text(std::uint64_t length) {
    expect(length);
    std::string bytes(length, '\0');
    if (!stream_.read(bytes.data(), static_cast<std::streamsize>(length))) fail("cannot be read");
    position_ += length;
    return bytes;
  }

  void skip(std::uint64_t bytes) {
    expect(bytes);
    stream_.ignore(static_cast<std::streamsize>(bytes));
    position_ += bytes;
  }

  std::uint64_t number(std::uint64_t bytes) {
    std::uint64_t value = 0;
    for (const char byte : text(bytes)) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }

  std::uint64_t word() { return number(4); }
  std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }
  std::uint64_t offset() { return number(version_ == 1 ? 4 : 8); }

  void version() {
    const std::string magic = text(4);
    version_ = magic[3];
    if (!magic.starts_with("CDF") || (version_ != 1 && version_ != 2 && version_ != 5))
      fail("not a file in netCDF's classic formats CDF-1, CDF-2 or CDF-5");
  }

  void records() {
    header_.records = count();
    if (header_.records == (version_ == 5 ? infinite : 0xffffffff))
      fail(
          "the number of frames was never written (a stream); write the file anew, or mend it with "
          "the program that wrote it");
    if (header_.records >> 63) fail("the number of frames is negative");
  }

  /// The number of entries of the list that follows.
  std::uint64_t list(std::uint64_t expected, std::string_view what) {
    const std::uint64_t tag = word(), entries = count();
    if (tag != expected && (tag != 0 || entries != 0))
      fail(fmt::format("no list of {} begins here", what));
    if (entries > most_entries)
      fail(fmt::format("{} {} (at most {})", entries, what, most_entries));
    return entries;
  }

  std::string name() {
    const std::uint64_t length = count();
    if (length == 0 || length > longest_name) fail(fmt::format("a name in {} bytes", length));
    std::string name = text(length);
    skip(padded(length) - length);
    return name;
  }

  Type type() {
    const std::uint64_t number = word();
    if (number < 1 || number > (version_ == 5 ? 11 : 6))
      fail(fmt::format("a type of number {}", number));
    return static_cast<Type>(number);
  }

  void axis() {
    Axis& axis = header_.axes.emplace_back();
    axis.name = name();
    axis.length = count();
    if (axis.length >> 63) fail(fmt::format("the dimension {} is negative", axis.name));
    if (axis.length != 0) return;
    if (record_axis_) fail("two dimensions are unlimited");
    record_axis_ = header_.axes.size() - 1;
  }

  void attributes() {
    for (std::uint64_t left = list(of_attributes, "attributes"); left > 0; --left) {
      name();
      const std::uint64_t element = size_of(type());
      skip(padded(product(element, count())));
    }
  }

  void variable() {
    Variable v;
    v.name = name();
    const std::uint64_t axes = count();
    if (axes > most_axes_of_variable) fail(fmt::format("a variable of {} dimensions", axes));
    for (std::uint64_t k = 0; k < axes; ++k) v.axes.push_back(axis_of_variable(k));
    attributes();
    v.type = type();
    count();  // its size, which follows from the dimensions and does not fit if it is large
    v.begin = offset();
    if (v.begin >> 63) fail(fmt::format("the variable {} begins at byte {}", v.name, v.begin));
    v.in_records = !v.axes.empty() && v.axes[0] == record_axis_;
    v.bytes = size_of(v.type);
    for (std::size_t k = v.in_records; k < v.axes.size(); ++k)
      v.bytes = product(v.bytes, header_.axes[v.axes[k]].length);
    header_.variables.push_back(std::move(v));
  }

  std::size_t axis_of_variable(std::uint64_t place) {
    const std::uint64_t id = count();
    if (id >= header_.axes.size()) fail(fmt::format("dimension {} of {}", id, header_.axes.size()));
    if (id == record_axis_ && place > 0) fail("the unlimited dimension is not a variable's first");
    return id;
  }

  /// Numbers of a record's variables fill up four bytes, but for those of a single variable.
  void measure_records() {
    for (const Variable& v : header_.variables) {
      if (v.begin < position_)
        fail(fmt::format("the variable {} begins within the header", v.name));
      if (v.in_records) header_.record_bytes = sum(header_.record_bytes, padded(v.bytes));
    }
    const auto in_records = [](const Variable& v) { return v.in_records; };
    if (std::ranges::count_if(header_.variables, in_records) == 1)
      header_.record_bytes = std::ranges::find_if(header_.variables, in_records)->bytes;
  }

  std::string path_;
  std::ifstream stream_;
  ClassicHeader header_;
  int version_ = 0;
  std::uint64_t position_ = 0;
  std::optional<std::size_t> record_axis_;
};

template <class Named>
std::optional<std::size_t> find(const std::vector<Named>& all, std::string_view name) {
  const auto it = std::ranges::find(all, name, &Named::name);
  if (it == all.end()) return std::nullopt;
  return static_cast<std::size_t>(it - all.begin());
}

}  // namespace

std::uint64_t size_of(Type type) {
  constexpr std::array<std::uint64_t, 12> sizes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  return sizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> ClassicHeader::axis(std::string_view name) const {
  return find(axes, name);
}

std::optional<std::size_t> ClassicHeader::variable(std::string_view name) const {
  return find(variables, name);
}

bool ClassicHeader::fixed_part_is_whole() const {
  return std::ranges::all_of(variables, [&](const Variable& v) {
    return v.in_records || sum(v.begin, v.bytes) <= file_bytes;
  });
}

std::uint64_t ClassicHeader::whole_records() const {
  std::uint64_t whole = records;
  for (const Variable& v : variables) {
    if (!v.in_records || v.bytes == 0) continue;
    const std::uint64_t end = sum(v.begin, v.bytes);
    const std::uint64_t here = end > file_bytes ? 0 : 1 + (file_bytes - end) / record_bytes;
    whole = std::min(whole, here);
  }
  return whole;
}

std::uint64_t ClassicHeader::end_of_records(std::uint64_t count) const {
  std::uint64_t end = 0;
  for (const Variable& v : variables) {
    const bool any = !v.in_records || count > 0;
    const std::uint64_t before = v.in_records && any ? product(count - 1, record_bytes) : 0;
    end = std::max(end, sum(v.begin, sum(before, any ? v.bytes : 0)));
  }
  return end;
}

ClassicHeader read_classic_header(const std::filesystem::path& path) {
  return HeaderReader(path).read();
}

}  // namespace mdana::amber_netcdf
