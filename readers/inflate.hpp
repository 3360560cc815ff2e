// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace mdana {

/// Decompresses one gzip member (RFC 1952) after another, checksums verified.
class Inflate {
 public:
  enum class State { more, member_ended, corrupt };
  struct Result {
    State state = State::more;
    std::size_t unused = 0;  ///< when a member ended: bytes at the end of what was taken, not its own
    std::string what;        ///< when corrupt: how, if it is known
  };

  virtual ~Inflate() = default;

  /// Takes bytes off the front of `in` and fills the front of `out`; both shrink by as much. Returns
  /// with `more` only when one of them is empty.
  virtual Result step(std::string_view& in, std::span<char>& out) = 0;

  virtual void start_member() = 0;

  /// Goes on from here independently of this one.
  virtual std::unique_ptr<Inflate> copy() const = 0;
};

std::unique_ptr<Inflate> make_zlib_inflate();
std::unique_ptr<Inflate> make_isal_inflate();  ///< nothing if mdana was built without ISA-L

}  // namespace mdana
