// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "analyses/defects.hpp"

namespace mdana::defects {

/// Atoms of a frame with their labels to another rank: their number, then block by block.
void send_atoms(const LabelledAtoms& atoms, const std::function<void(const std::string&)>& to);

/// Such atoms on their way: each block can be looked at once.
class SentAtoms final : public LabelledAtoms {
 public:
  explicit SentAtoms(const std::function<std::string()>& from);
  std::size_t size() const override { return size_; }
  /// The blocks that have not been looked at.
  void for_blocks(const std::function<void(const FrameAtoms&, const AtomLabels&)>& use) const override;

 private:
  const std::function<std::string()>& from_;
  std::size_t size_ = 0;
  mutable std::size_t left_ = 0;
};

}  // namespace mdana::defects
