// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "analyses/value.hpp"

namespace mdana {

/// Values on their way to another rank, as bytes: the same program on the same kind of machine unpacks them, into fresh ones.
/// One list of members does both, `parcel(a, b, c)`; a type of its own tells its members by `pass(parcel)`.
class Parcel {
 public:
  Parcel() = default;  ///< to be filled
  explicit Parcel(std::string bytes) : bytes_(std::move(bytes)), unpacks_(true) {}

  template <class... Values>
  void operator()(Values&... values) {
    (pass(values), ...);
  }

  bool unpacks() const { return unpacks_; }
  std::string take() { return std::move(bytes_); }  ///< what it was filled with

 private:
  template <class T>
  void pass(T& value) {
    if constexpr (requires { value.pass(*this); })
      value.pass(*this);
    else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      pass_bytes(&value, sizeof value);
    else if constexpr (requires { T::SizeAtCompileTime; })  // a matrix
      pass_bytes(value.data(), sizeof(typename T::Scalar) * static_cast<std::size_t>(T::SizeAtCompileTime));
    else
      pass(value.coeffs());  // a quaternion
  }

  template <class T, std::size_t n>
  void pass(std::array<T, n>& values) {
    for (T& value : values) pass(value);
  }

  template <class T>
  void pass(std::optional<T>& value) {
    bool there = value.has_value();
    pass(there);
    if (there && !value) value.emplace();
    if (there) pass(*value);
  }

  void pass(Value& v) { (*this)(v.value, v.error, v.dimension.mass, v.dimension.length, v.dimension.time); }
  void pass(std::string& text) { pass_list(text); }
  template <class T>
  void pass(std::vector<T>& values) {
    pass_list(values);
  }

  template <class List>
  void pass_list(List& values) {
    using T = typename List::value_type;
    std::uint64_t size = values.size();
    pass(size);
    if (unpacks_ && size > bytes_.size()) fail();  // none takes less than a byte
    if (unpacks_) values.resize(size);
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      pass_bytes(values.data(), sizeof(T) * size);
    else
      for (T& value : values) pass(value);
  }

  void pass_bytes(void* value, std::size_t size);
  [[noreturn]] static void fail();

  std::string bytes_;
  std::size_t next_ = 0;  ///< to be unpacked
  bool unpacks_ = false;
};

}  // namespace mdana
