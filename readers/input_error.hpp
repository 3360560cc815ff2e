// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace mdana {

/// Input that cannot be used as it stands. The text says where (file:line, frame), what is wrong
/// and what to do about it.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The input ends inside a frame: everything before that frame is whole and usable.
class TruncatedInput : public InputError {
 public:
  using InputError::InputError;
};

/// A frame has more or fewer atoms than its header says.
class WrongAtomCount : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace mdana
