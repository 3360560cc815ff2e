// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "readers/byte_sink.hpp"

namespace mdana {
namespace {

/// The numbers of dumps have little that repeats: level 6 takes six times as long as level 1 for
/// files that are 6 to 9 % smaller.
constexpr int level = 1;

/// One gzip member (RFC 1952).
class Gzip final : public ByteSink {
 public:
  Gzip(std::unique_ptr<ByteSink> file, std::string name)
      : file_(std::move(file)), name_(std::move(name)) {
    if (deflateInit2(&z_, level, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::runtime_error(fmt::format("{}: no memory for zlib", name_));
  }
  ~Gzip() override { deflateEnd(&z_); }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;

  void write(std::string_view bytes) override {
    while (!bytes.empty()) {
      const auto part = bytes.substr(0, std::numeric_limits<uInt>::max());
      pack(part, Z_NO_FLUSH);
      bytes.remove_prefix(part.size());
    }
  }

  void finish() override {
    pack({}, Z_FINISH);
    file_->finish();
  }

 private:
  void pack(std::string_view bytes, int how) {
    z_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    z_.avail_in = static_cast<uInt>(bytes.size());
    do {
      z_.next_out = reinterpret_cast<Bytef*>(packed_.data());
      z_.avail_out = static_cast<uInt>(packed_.size());
      if (deflate(&z_, how) == Z_STREAM_ERROR)
        throw std::runtime_error(fmt::format("{}: zlib fails", name_));
      file_->write({packed_.data(), packed_.size() - z_.avail_out});
    } while (z_.avail_out == 0);
  }

  std::unique_ptr<ByteSink> file_;
  std::string name_;
  z_stream z_{};
  std::vector<char> packed_ = std::vector<char>(std::size_t{1} << 17);
};

}  // namespace

std::unique_ptr<ByteSink> gzip_into(std::unique_ptr<ByteSink> file, const std::string& name) {
  return std::make_unique<Gzip>(std::move(file), name);
}

}  // namespace mdana
