// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/parcel.hpp"

#include <stdexcept>

namespace mdana {

void Parcel::pass_bytes(void* value, std::size_t size) {
  if (!unpacks_) {
    bytes_.append(static_cast<const char*>(value), size);
    return;
  }
  if (size > bytes_.size() - next_) fail();
  bytes_.copy(static_cast<char*>(value), size, next_);
  next_ += size;
}

void Parcel::fail() { throw std::logic_error("Parcel: more is unpacked than was packed"); }

}  // namespace mdana
