// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include <zlib.h>

#include "readers/inflate.hpp"

namespace mdana {
namespace {

void check(int result) {
  if (result != Z_OK) throw std::runtime_error("zlib: no memory");
}

class ZlibInflate final : public Inflate {
 public:
  ZlibInflate() { check(inflateInit2(&stream_, 15 + 16)); }  // 16: gzip headers only
  ZlibInflate(const ZlibInflate& other) {
    check(inflateCopy(&stream_, const_cast<z_stream*>(&other.stream_)));
  }
  ZlibInflate& operator=(const ZlibInflate&) = delete;
  ~ZlibInflate() override { inflateEnd(&stream_); }

  Result step(std::string_view& in, std::span<char>& out) override {
    const std::size_t most = std::size_t{1} << 30;
    const std::size_t given = std::min(in.size(), most), room = std::min(out.size(), most);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data()));
    stream_.avail_in = static_cast<uInt>(given);
    stream_.next_out = reinterpret_cast<Bytef*>(out.data());
    stream_.avail_out = static_cast<uInt>(room);
    const int result = ::inflate(&stream_, Z_NO_FLUSH);
    in.remove_prefix(given - stream_.avail_in);
    out = out.subspan(room - stream_.avail_out);
    if (result == Z_STREAM_END) return {State::member_ended, 0, {}};
    if (result == Z_OK || result == Z_BUF_ERROR) return {};
    return {State::corrupt, 0, stream_.msg ? stream_.msg : ""};
  }

  void start_member() override { inflateReset(&stream_); }
  std::unique_ptr<Inflate> copy() const override { return std::make_unique<ZlibInflate>(*this); }

 private:
  z_stream stream_{};
};

}  // namespace

std::unique_ptr<Inflate> make_zlib_inflate() { return std::make_unique<ZlibInflate>(); }

}  // namespace mdana
