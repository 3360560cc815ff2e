// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/failure.hpp"

#include <fmt/format.h>

#include "analyses/frame_run.hpp"
#include "readers/input_error.hpp"
#include "readers/ranks.hpp"

namespace mdana {

Failure Failure::current() {
  try {
    throw;
  } catch (const RankLeft&) {
    throw;
  } catch (const TruncatedInput& error) {
    return {0, Kind::truncated_input, error.what(), 0};
  } catch (const InputError& error) {
    return {0, Kind::input, error.what(), 0};
  } catch (const Interrupted& stopped) {
    return {0, Kind::interrupted, {}, stopped.signal};
  } catch (const std::exception& error) {
    return {0, Kind::other, fmt::format("rank {}: {}", rank(), error.what()), 0};
  }
}

void Failure::raise() const {
  if (kind == Kind::truncated_input) throw TruncatedInput(what);
  if (kind == Kind::interrupted) throw Interrupted(signal);
  throw InputError(what);
}

}  // namespace mdana
