// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "analyses/table.hpp"
#include "reports/document.hpp"

namespace mdana {

/// A kind of file that results are written to. The list of sinks is in CMakeLists.txt (MDANA_SINKS);
/// each defines `extern const Sink <name>_sink`.
struct Sink {
  std::string_view name;
  std::string_view ending;   ///< of file names, with its point: ".csv"
  std::string_view summary;  ///< what it holds, for help: "the table"
  bool needs_table;          ///< no use without a table

  bool all_tables;  ///< it holds the document's other tables, too

  /// Writes the file whole or not at all; the table may be missing unless it is needed. Throws
  /// std::runtime_error.
  void (*write)(const std::filesystem::path& path, const Document& document, const Table* table);
};

/// All sinks of this build.
std::span<const Sink* const> sinks();

}  // namespace mdana
