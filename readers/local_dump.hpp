// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "readers/line_reader.hpp"

namespace mdana {

/// A pair of grains that a simulation lists, the smaller id first.
struct ListedContact {
  std::int64_t id1 = 0, id2 = 0;
  double force = 0;  ///< normal, repulsive > 0 [force]; 0 if none acts
};

struct LocalFrame {
  std::int64_t step = 0;
  std::vector<ListedContact> contacts;  ///< sorted by ids
};

/// Contacts as LAMMPS' `dump local` writes them, plain or compressed: pairs of ids (compute
/// property/local patom1 patom2) and their force (compute pair/local force).
class LocalDump {
 public:
  /// Names of the columns of both ids and the force, as the dump has them.
  using Columns = std::array<std::string, 3>;

  /// Throws InputError if the file cannot be opened.
  LocalDump(const std::filesystem::path& path, Columns columns);

  /// The next frame; nothing at the end. Throws InputError naming the line, TruncatedInput if the
  /// file ends within a frame. Steps must ascend.
  std::optional<LocalFrame> next();

  InputRecord record() { return lines_.bytes().record(); }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  std::string_view needed_line();
  bool pass_blank_lines();  ///< false at the end of the file
  std::int64_t whole(std::string_view text) const;
  void find_columns(std::string_view names);
  ListedContact entry(std::string_view line) const;
  void entries(std::int64_t count, LocalFrame& frame);

  std::string path_;
  LineReader lines_;
  Columns columns_;
  std::array<std::size_t, 3> place_{};  ///< of the columns in a line
  std::size_t width_ = 0;               ///< columns of a line
  std::optional<std::int64_t> step_;    ///< of the frame before
};

}  // namespace mdana
