// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// HDF5 files by HDF5's C library, of builds that need it. What fails while reading throws InputError,
/// while writing std::runtime_error, with file, object and HDF5's own reason. One thread at a time.
namespace mdana::hdf5 {

using Id = std::int64_t;  ///< HDF5's hid_t
using Shape = std::vector<std::uint64_t>;

enum class Kind { real, integer, text, other };  ///< enumerated values are integers

/// Owns one of HDF5's identifiers.
class Handle {
 public:
  Handle() = default;
  explicit Handle(Id id) : id_(id) {}
  ~Handle();
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;

  Id id() const { return id_; }

 private:
  Id id_ = -1;
};

/// A part of a dataset: first element and number of elements along each axis.
struct Slab {
  Shape first, count;
};

/// What groups and datasets have in common: a place for messages, and attributes.
class Object {
 public:
  Object(Handle handle, std::string place) : handle_(std::move(handle)), place_(std::move(place)) {}

  const std::string& place() const { return place_; }  ///< "file.h5: /particles/all"
  Id id() const { return handle_.id(); }

  /// Values of an attribute, one if it is a scalar; none if there is no such attribute.
  std::vector<std::string> texts(const std::string& name) const;
  std::vector<std::int64_t> integers(const std::string& name) const;
  std::vector<double> reals(const std::string& name) const;

  void set_text(const std::string& name, const std::string& value);
  void set_texts(const std::string& name, std::span<const std::string> values);
  void set_integer(const std::string& name, std::int64_t value);
  void set_integers(const std::string& name, std::span<const std::int64_t> values);

 private:
  Handle handle_;
  std::string place_;
};

class Dataset : public Object {
 public:
  using Object::Object;

  Kind kind() const;
  Shape shape() const;
  std::optional<std::int64_t> fill_integer() const;  ///< the fill value, if the file declares one

  /// Whether the element at this place was ever written: the others read as the fill value.
  bool stored(const Shape& place) const;

  /// Values of a slab in the order of C. Throws InputError, too, if an unsigned number is too large.
  void read(const Slab& slab, std::span<double> into) const;
  void read(const Slab& slab, std::span<std::int64_t> into) const;
  std::vector<std::string> read_texts(const Slab& slab) const;

  void write(const Slab& slab, std::span<const double> values);
  void write(const Slab& slab, std::span<const std::int64_t> values);
  void write(const Slab& slab, std::span<const std::string> values);
  void extend(const Shape& shape);
};

struct NewDataset {
  Kind kind = Kind::real;              ///< stored as 64 bit, little-endian; text padded by zeros
  Shape shape;                         ///< none: a scalar
  Shape chunk{};                       ///< not none: extendible along all axes
  std::size_t width = 1;               ///< bytes of a text
  std::optional<std::int64_t> fill{};  ///< of integers
  unsigned deflate = 0;                ///< 1 to 9: compressed, bytes shuffled
};

class Group : public Object {
 public:
  using Object::Object;

  std::vector<std::string> names() const;  ///< sorted; in the order of creation if that is tracked
  bool has_group(const std::string& name) const;
  bool has_dataset(const std::string& name) const;

  Group group(const std::string& name) const;
  /// Its cache holds at least the chunks that one row of the first axis needs, within a limit; throws
  /// InputError if one compressed chunk exceeds that.
  Dataset dataset(const std::string& name) const;

  Group make_group(const std::string& name, bool track_order = false);
  Dataset make_dataset(const std::string& name, const NewDataset& wanted);
  void link(const std::string& name, const Object& object);  ///< another name for an object
};

/// An open file, which is its root group. A file that ends early throws TruncatedInput.
Group open_file(const std::filesystem::path& path);
/// A new file, the same bytes for the same contents; an older one is replaced.
Group create_file(const std::filesystem::path& path);
/// Writes what is still in memory.
void flush(const Object& object);

}  // namespace mdana::hdf5
