// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace mdana::test {

/// A file in netCDF's classic formats CDF-1, CDF-2 or CDF-5 (netCDF users' guide, "File format
/// specifications"), written byte by byte; every field of the header may be made wrong.
struct NetcdfBytes {
  enum Type : std::uint32_t {
    byte_ = 1,
    char_ = 2,
    short_ = 3,
    int_ = 4,
    float_ = 5,
    double_ = 6,
    int64_ = 10
  };

  struct Attribute {
    std::string name;
    Type type;
    std::string bytes;
  };
  struct Variable {
    std::string name;
    std::vector<std::uint64_t> axes;
    Type type;
    std::vector<std::string> records;  ///< bytes of each record; one for fixed variables
    std::vector<Attribute> attributes = {};
  };
  struct Axis {
    std::string name;
    std::uint64_t length;
  };

  int version = 1;
  std::uint64_t records = 0;
  std::vector<Axis> axes{{"frame", 0}, {"atom", 2}, {"spatial", 3}};
  std::vector<Attribute> attributes{text("Conventions", "AMBER"), text("ConventionVersion", "1.0")};
  std::vector<Variable> variables;

  static std::string number(std::uint64_t value, int bytes) {
    std::string text;
    for (int k = bytes - 1; k >= 0; --k) text += static_cast<char>(value >> (8 * k));
    return text;
  }
  static std::string floats(const std::vector<float>& values) {
    std::string bytes;
    for (const float v : values) bytes += number(std::bit_cast<std::uint32_t>(v), 4);
    return bytes;
  }
  static std::string doubles(const std::vector<double>& values) {
    std::string bytes;
    for (const double v : values) bytes += number(std::bit_cast<std::uint64_t>(v), 8);
    return bytes;
  }
  static std::string integers(const std::vector<std::int64_t>& values, int bytes) {
    std::string text;
    for (const auto v : values) text += number(static_cast<std::uint64_t>(v), bytes);
    return text;
  }
  static Attribute text(const std::string& name, const std::string& value) {
    return {name, char_, value};
  }
  static Attribute scale(double factor) { return {"scale_factor", double_, doubles({factor})}; }

  static std::uint64_t size_of(Type type) {
    return type == short_ ? 2 : type <= char_ ? 1 : type == double_ || type == int64_ ? 8 : 4;
  }
  static std::string padded(std::string bytes) {
    return bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
  }

  Variable& add(Variable variable) { return variables.emplace_back(std::move(variable)); }

  bool in_records(const Variable& v) const {
    return !v.axes.empty() && axes[v.axes[0]].length == 0;
  }

  /// The header with variables that begin at these bytes.
  std::string header(const std::vector<std::uint64_t>& begins) const {
    const int wide = version == 5 ? 8 : 4;
    const auto count = [&](std::uint64_t n) { return number(n, wide); };
    const auto name = [&](const std::string& n) { return count(n.size()) + padded(n); };
    const auto list = [&](std::uint64_t tag, std::size_t n) {
      return number(n ? tag : 0, 4) + count(n);
    };
    const auto all = [&](const std::vector<Attribute>& some) {
      std::string bytes = list(12, some.size());
      for (const auto& a : some)
        bytes += name(a.name) + number(a.type, 4) + count(a.bytes.size() / size_of(a.type)) +
                 padded(a.bytes);
      return bytes;
    };
    std::string bytes = std::string("CDF") + static_cast<char>(version) + count(records);
    bytes += list(10, axes.size());
    for (const auto& axis : axes) bytes += name(axis.name) + count(axis.length);
    bytes += all(attributes) + list(11, variables.size());
    for (std::size_t k = 0; k < variables.size(); ++k) {
      const Variable& v = variables[k];
      bytes += name(v.name) + count(v.axes.size());
      for (const auto axis : v.axes) bytes += count(axis);
      bytes += all(v.attributes) + number(v.type, 4) +
               count(v.records.empty() ? 0 : padded(v.records[0]).size());
      bytes += number(begins[k], version == 1 ? 4 : 8);
    }
    return bytes;
  }

  /// Header, fixed variables, then record by record those of each.
  std::string bytes() const {
    std::vector<std::uint64_t> begins(variables.size(), 0);
    std::uint64_t end = header(begins).size();
    std::string fixed;
    std::vector<std::string> rows;
    for (const bool of_records : {false, true})
      for (std::size_t k = 0; k < variables.size(); ++k) {
        const Variable& v = variables[k];
        if (in_records(v) != of_records) continue;
        begins[k] = end;
        end += v.records.empty() ? 0 : padded(v.records[0]).size();
        if (!of_records) fixed += padded(v.records[0]);
        rows.resize(std::max(rows.size(), of_records ? v.records.size() : 0));
        for (std::size_t r = 0; of_records && r < v.records.size(); ++r)
          rows[r] += padded(v.records[r]);
      }
    std::string all = header(begins) + fixed;
    for (const auto& row : rows) all += row;
    return all;
  }
};

}  // namespace mdana::test
