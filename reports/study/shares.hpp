// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reports/study/states.hpp"

namespace mdana {

/// The runs of a study that one task does, in the order of the study.
struct Share {
  std::vector<std::size_t> runs;
  std::vector<std::size_t> besides;  ///< those of other tasks whose E* and R its runs take
};

/// Each run into one of so many shares: the heaviest first, where it ends soonest. The same in every process, since it
/// depends on the study and the sizes of its dumps alone.
std::vector<Share> share_out(const std::vector<StudyRun>& runs, std::size_t tasks);

}  // namespace mdana
