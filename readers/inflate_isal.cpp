// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/inflate.hpp"

#ifdef MDANA_WITH_ISAL
#include <algorithm>
#include <limits>

#include <isa-l/igzip_lib.h>
#endif

namespace mdana {

#ifdef MDANA_WITH_ISAL
namespace {

const char* meaning(int result) {
  switch (result) {
    case ISAL_INVALID_BLOCK: return "invalid block";
    case ISAL_INVALID_SYMBOL: return "invalid symbol";
    case ISAL_INVALID_LOOKBACK: return "invalid distance too far back";
    case ISAL_INVALID_WRAPPER: return "incorrect header check";
    case ISAL_UNSUPPORTED_METHOD: return "unknown compression method";
    case ISAL_INCORRECT_CHECKSUM: return "incorrect data check";
    default: return "";
  }
}

/// Intel's library. Its state holds no pointers into itself, so that a copy of it is a copy.
class IsalInflate final : public Inflate {
 public:
  IsalInflate() { start_member(); }

  Result step(std::string_view& in, std::span<char>& out) override {
    const std::size_t most = std::size_t{1} << 30;
    const std::size_t given = std::min(in.size(), most), room = std::min(out.size(), most);
    state_.next_in = reinterpret_cast<std::uint8_t*>(const_cast<char*>(in.data()));
    state_.avail_in = static_cast<std::uint32_t>(given);
    state_.next_out = reinterpret_cast<std::uint8_t*>(out.data());
    state_.avail_out = static_cast<std::uint32_t>(room);
    const int result = isal_inflate(&state_);
    // Of corrupt data it may count more as taken than there is.
    in.remove_prefix(given - std::min<std::size_t>(state_.avail_in, given));
    out = out.subspan(room - std::min<std::size_t>(state_.avail_out, room));
    if (result != ISAL_DECOMP_OK) return {State::corrupt, 0, meaning(result)};
    if (state_.block_state != ISAL_BLOCK_FINISH) return {};
    // Whole bytes in its bit buffer belong to what follows the member.
    return {State::member_ended, static_cast<std::size_t>(state_.read_in_length) / 8, {}};
  }

  void start_member() override {
    isal_inflate_init(&state_);
    state_.crc_flag = ISAL_GZIP;
  }

  std::unique_ptr<Inflate> copy() const override { return std::make_unique<IsalInflate>(*this); }

 private:
  inflate_state state_;
};

}  // namespace

std::unique_ptr<Inflate> make_isal_inflate() { return std::make_unique<IsalInflate>(); }

#else

std::unique_ptr<Inflate> make_isal_inflate() { return nullptr; }

#endif

}  // namespace mdana
