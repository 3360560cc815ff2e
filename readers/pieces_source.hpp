// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "readers/format.hpp"

namespace mdana {

/// Frames whose atoms are spread over several files, as LAMMPS writes them for `%`: the atoms of
/// the pieces one after another, cut into the same blocks as those of a single file. Pieces of a
/// frame that differ in step, time, units, box or columns are an InputError; a piece with fewer
/// frames than the others is a TruncatedInput.
std::unique_ptr<FrameSource> join_pieces(std::vector<std::unique_ptr<FrameSource>> pieces);

}  // namespace mdana
