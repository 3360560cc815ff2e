// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gzip.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

namespace mdana {
namespace {

/// zlib's decompressor; copies share nothing.
class Inflate {
 public:
  Inflate() {
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::runtime_error("zlib: no memory");
  }
  Inflate(const Inflate& other) {
    if (inflateCopy(&stream, const_cast<z_stream*>(&other.stream)) != Z_OK)
      throw std::runtime_error("zlib: no memory");
  }
  Inflate& operator=(const Inflate&) = delete;
  ~Inflate() { inflateEnd(&stream); }

  z_stream stream{};
};

class Gzip final : public ByteSource {
 public:
  explicit Gzip(std::unique_ptr<RawFile> file) : file_(std::move(file)), input_(1 << 18) {}

  std::size_t read(std::span<char> into) override {
    z_stream& z = inflate_->stream;
    z.next_out = reinterpret_cast<Bytef*>(into.data());
    z.avail_out = static_cast<uInt>(std::min<std::size_t>(into.size(), 1u << 30));
    while (z.avail_out > 0 && !ended_ && refill()) step();
    return static_cast<std::size_t>(reinterpret_cast<char*>(z.next_out) - into.data());
  }

  void mark() override {
    marked_ = std::make_unique<Inflate>(*inflate_);
    marked_position_ = file_->position() - inflate_->stream.avail_in;
    marked_inside_ = inside_member_;
    marked_ended_ = ended_;
  }

  void reset() override {
    if (!marked_) throw std::logic_error("reset without mark");
    inflate_ = std::make_unique<Inflate>(*marked_);
    inflate_->stream.avail_in = 0;
    file_->seek(marked_position_);
    inside_member_ = marked_inside_;
    ended_ = marked_ended_;
  }

  std::string damage() const override { return damage_; }
  InputRecord record() override { return file_->record(); }

 private:
  /// True while there are compressed bytes; notes a stream that ends in the middle.
  bool refill() {
    z_stream& z = inflate_->stream;
    if (z.avail_in > 0) return true;
    z.avail_in = static_cast<uInt>(file_->read(input_));
    z.next_in = reinterpret_cast<Bytef*>(input_.data());
    if (z.avail_in > 0) return true;
    if (inside_member_) fail("the gzip data end early, the file was cut");
    ended_ = true;
    return false;
  }

  void step() {
    z_stream& z = inflate_->stream;
    inside_member_ = true;
    const int result = inflate(&z, Z_NO_FLUSH);
    if (result == Z_STREAM_END) {
      inside_member_ = false;
      inflateReset(&z);
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      fail(fmt::format("the gzip data are corrupt ({}); what was read before is not certain either",
                       z.msg ? z.msg : "unknown error"));
    }
  }

  void fail(const std::string& what) {
    damage_ = fmt::format("{} (compressed byte {})", what,
                          file_->position() - inflate_->stream.avail_in);
    ended_ = true;
  }

  std::unique_ptr<RawFile> file_;
  std::vector<char> input_;
  std::unique_ptr<Inflate> inflate_ = std::make_unique<Inflate>();
  bool inside_member_ = false;
  bool ended_ = false;
  std::string damage_;

  std::unique_ptr<Inflate> marked_;
  std::uint64_t marked_position_ = 0;
  bool marked_inside_ = false;
  bool marked_ended_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> open_gzip(std::unique_ptr<RawFile> file) {
  return std::make_unique<Gzip>(std::move(file));
}

}  // namespace mdana
