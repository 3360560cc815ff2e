// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "reports/study.hpp"

namespace mdana {

/// The study as one self-contained page. Figures are drawn into `figures` (an existing directory).
std::string study_page(const Study& study, const std::filesystem::path& figures);

}  // namespace mdana
