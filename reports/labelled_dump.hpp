// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "analyses/defects.hpp"
#include "readers/format.hpp"
#include "reports/output_file.hpp"
#include "reports/run.hpp"

namespace mdana {

/// A dump of the bodies' atoms with their labels, frame by frame, whole or not at all. Columns: id,
/// type (if the dump has it), x y z (xu yu zu in a periodic box), and c_mdana_body, _structure (0 other,
/// 1 fcc, 2 hcp, 3 bcc, 4 ico), _site (0 crystal, 1 surface, 2 contact, 3 bulk defect), _margin,
/// _cluster, _csp, _coordination as far as they were asked for.
class LabelledDump {
 public:
  /// Throws InputError if the format cannot be written there, or the place is that of the input.
  LabelledDump(const std::filesystem::path& place, const Format& format, const Run& run);

  void add(const FrameHeader& header, const LabelledAtoms& atoms);
  void commit();  ///< after the last frame

 private:
  void write(const FrameHeader& header, const LabelledAtoms& atoms);
  void add_block(const std::array<std::string, 3>& axes, const FrameAtoms& atoms, const AtomLabels& labels);

  OutputFile file_;
  std::unique_ptr<FrameWriter> writer_;
  Units units_;
  std::optional<double> timestep_;
  std::uint64_t blocks_ = 0;  ///< of the frame
};

}  // namespace mdana
