// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "readers/hdf5/call.hpp"
#include "readers/input_error.hpp"

namespace mdana::hdf5 {
namespace {

constexpr std::size_t most_values = 1 << 12;      ///< of an attribute
constexpr std::size_t longest_text = 1 << 20;     ///< in bytes

struct Attribute {
  Handle id, type, space;
  std::string place;
  std::size_t count = 0;
};

std::optional<Attribute> open_attribute(const Object& object, const std::string& name) {
  quiet();
  if (H5Aexists(object.id(), name.c_str()) <= 0) return std::nullopt;
  Attribute a;
  a.place = fmt::format("{}, attribute '{}'", object.place(), name);
  a.id = Handle(read_ok(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), a.place));
  a.type = Handle(read_ok(H5Aget_type(a.id.id()), a.place));
  a.space = Handle(read_ok(H5Aget_space(a.id.id()), a.place));
  a.count = elements_of(a.space.id(), most_values, a.place);
  return a;
}

std::vector<std::string> any_length(const Attribute& a) {
  std::vector<char*> pointers(a.count, nullptr);
  read_ok(H5Aread(a.id.id(), a.type.id(), pointers.data()), a.place);
  std::vector<std::string> values;
  for (const char* text : pointers) values.emplace_back(text ? text : "");
  H5Dvlen_reclaim(a.type.id(), a.space.id(), H5P_DEFAULT, pointers.data());
  return values;
}

template <class T>
std::vector<T> numbers(const Object& object, const std::string& name, Id memory_type, bool whole) {
  const auto a = open_attribute(object, name);
  if (!a) return {};
  const Kind kind = kind_of(a->type.id());
  if (kind != Kind::integer && (whole || kind != Kind::real))
    throw InputError(fmt::format("{}: {} expected", a->place, whole ? "whole numbers" : "numbers"));
  std::vector<T> values(a->count);
  read_ok(H5Aread(a->id.id(), memory_type, values.data()), a->place);
  return values;
}

void write_attribute(const Object& object, const std::string& name, Id file_type, Id memory_type,
                     Handle space, const void* values) {
  quiet();
  const std::string place = fmt::format("{}, attribute '{}'", object.place(), name);
  const Handle id(write_ok(H5Acreate2(object.id(), name.c_str(), file_type, space.id(), H5P_DEFAULT,
                                      H5P_DEFAULT),
                           place));
  write_ok(H5Awrite(id.id(), memory_type, values), place);
}

Handle any_length_type() {
  Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

Handle row_of(std::size_t count) {
  const hsize_t size = count;
  return Handle(H5Screate_simple(1, &size, nullptr));
}

}  // namespace

std::vector<std::string> Object::texts(const std::string& name) const {
  const auto a = open_attribute(*this, name);
  if (!a) return {};
  if (kind_of(a->type.id()) != Kind::text)
    throw InputError(fmt::format("{}: text expected", a->place));
  if (H5Tis_variable_str(a->type.id()) > 0) return any_length(*a);
  const std::size_t width = H5Tget_size(a->type.id());
  if (width > longest_text) throw InputError(fmt::format("{}: the text is too long", a->place));
  std::string bytes(a->count * width, '\0');
  read_ok(H5Aread(a->id.id(), a->type.id(), bytes.data()), a->place);
  return unpadded(bytes, a->type.id());
}

std::vector<std::int64_t> Object::integers(const std::string& name) const {
  return numbers<std::int64_t>(*this, name, H5T_NATIVE_INT64, true);
}

std::vector<double> Object::reals(const std::string& name) const {
  return numbers<double>(*this, name, H5T_NATIVE_DOUBLE, false);
}

// Of any length, which h5py gives as str.
void Object::set_text(const std::string& name, const std::string& value) {
  const Handle type = any_length_type();
  const char* pointer = value.c_str();
  write_attribute(*this, name, type.id(), type.id(), Handle(H5Screate(H5S_SCALAR)), &pointer);
}

void Object::set_texts(const std::string& name, std::span<const std::string> values) {
  const Handle type = any_length_type();
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  write_attribute(*this, name, type.id(), type.id(), row_of(values.size()), pointers.data());
}

void Object::set_integer(const std::string& name, std::int64_t value) {
  write_attribute(*this, name, H5T_STD_I64LE, H5T_NATIVE_INT64, Handle(H5Screate(H5S_SCALAR)),
                  &value);
}

void Object::set_integers(const std::string& name, std::span<const std::int64_t> values) {
  write_attribute(*this, name, H5T_STD_I64LE, H5T_NATIVE_INT64, row_of(values.size()),
                  values.data());
}

}  // namespace mdana::hdf5
