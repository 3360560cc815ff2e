// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "analyses/analysis.hpp"

namespace mdana {

/// Crystal structure about an atom, from its nearest neighbours; numbered as OVITO does.
enum class Structure : std::uint8_t { other, fcc, hcp, bcc, ico };

/// Where an atom of no crystal structure is; see analyses/defects/defects.md.
enum class Site : std::uint8_t { crystal, surface, contact, bulk_defect };

/// Planar faults of fcc, made of layers of hcp atoms.
enum class FaultKind3 : std::uint8_t { none, intrinsic, extrinsic, twin };

}  // namespace mdana
