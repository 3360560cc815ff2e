// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace mdana {

/// What went wrong on one rank, told to all: where in the order of the work, and the exception as far as ranks act on it.
struct Failure {
  enum class Kind : std::uint8_t { truncated_input, input, interrupted, other };

  std::uint64_t at = 0;  ///< block or frame
  Kind kind = Kind::other;
  std::string what;
  int signal = 0;  ///< that interrupted

  /// What `work` throws; nothing if it does not.
  template <class Work>
  static std::optional<Failure> of(Work&& work) {
    try {
      work();
      return std::nullopt;
    } catch (...) {
      return current();
    }
  }

  /// Throws it again. What is not of the input and no signal is an InputError, too, which names the rank: what came before
  /// it is kept, as it is before damage.
  [[noreturn]] void raise() const;

  template <class P>
  void pass(P& parcel) {
    parcel(at, kind, what, signal);
  }

 private:
  static Failure current();
};

/// Raises the first failure in the order of the work (of the lowest rank, if several are there), if there is one.
template <class Told, class Of>
void raise_first(const Told& told, const Of& of) {
  std::optional<Failure> first;
  for (const auto& rank : told)
    if (const std::optional<Failure>& failure = of(rank); failure && (!first || failure->at < first->at)) first = failure;
  if (first) first->raise();
}

}  // namespace mdana
