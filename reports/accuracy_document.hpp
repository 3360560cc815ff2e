// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/accuracy.hpp"
#include "reports/document.hpp"

namespace mdana {

/// A ladder as lines, the number with the greatest error at each value.
void add_ladder_lines(Document& document, const Ladder& ladder);

/// What is fixed as a line, and its knob, value, reason.
void add_fixed_line(Document& document, const std::string& subject, const FixedChoice& fixed);
nlohmann::ordered_json to_json(const FixedChoice& fixed);

/// knob, meaning, reference, order, draws, rows, left_out.
nlohmann::ordered_json to_json(const Ladder& ladder);

/// wanted, met, error, quantity, settings (by knob), seconds, exceeds (times the wanted error).
nlohmann::ordered_json to_json(const Recommendation& recommendation);

/// "1 of 2 frames: error 0.0031 (F_max), wanted 0.01", or by how much it is missed.
std::string to_text(const Recommendation& recommendation);

/// What a command chose for --error: `accuracy`, a line, and a warning if the error cannot be met.
void add_choice(Document& document, const Recommendation& recommendation);

}  // namespace mdana
