// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace mdana {

/// Version and hash of the program that is running.
const std::string& program_identity();

/// What results were made by: command line, program, system, processor, libraries, seeds.
nlohmann::ordered_json provenance();

}  // namespace mdana
