// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include <fmt/format.h>

#include "readers/byte_sink.hpp"

#ifdef MDANA_WITH_ZSTD
#include <vector>

#include <zstd.h>
#endif

namespace mdana {

#ifdef MDANA_WITH_ZSTD
namespace {

/// One zstd frame with a checksum (RFC 8878), at zstd's own default level.
class Zstd final : public ByteSink {
 public:
  Zstd(std::unique_ptr<ByteSink> file, std::string name)
      : file_(std::move(file)), name_(std::move(name)) {
    if (!stream_) throw std::runtime_error(fmt::format("{}: no memory for zstd", name_));
    check(ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_compressionLevel, ZSTD_CLEVEL_DEFAULT));
    check(ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_checksumFlag, 1));
  }

  void write(std::string_view bytes) override {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    while (in.pos < in.size) step(in, ZSTD_e_continue);
  }

  void finish() override {
    ZSTD_inBuffer none{nullptr, 0, 0};
    while (step(none, ZSTD_e_end) != 0) {
    }
    file_->finish();
  }

 private:
  std::size_t check(std::size_t result) const {
    if (ZSTD_isError(result))
      throw std::runtime_error(fmt::format("{}: zstd: {}", name_, ZSTD_getErrorName(result)));
    return result;
  }

  /// What is left to be flushed.
  std::size_t step(ZSTD_inBuffer& in, ZSTD_EndDirective how) {
    ZSTD_outBuffer out{packed_.data(), packed_.size(), 0};
    const std::size_t left = check(ZSTD_compressStream2(stream_.get(), &out, &in, how));
    file_->write({packed_.data(), out.pos});
    return left;
  }

  struct Free {
    void operator()(ZSTD_CStream* stream) const { ZSTD_freeCStream(stream); }
  };
  std::unique_ptr<ByteSink> file_;
  std::string name_;
  std::unique_ptr<ZSTD_CStream, Free> stream_{ZSTD_createCStream()};
  std::vector<char> packed_ = std::vector<char>(ZSTD_CStreamOutSize());
};

}  // namespace

std::unique_ptr<ByteSink> zstd_into(std::unique_ptr<ByteSink> file, const std::string& name) {
  return std::make_unique<Zstd>(std::move(file), name);
}

#else

std::unique_ptr<ByteSink> zstd_into(std::unique_ptr<ByteSink>, const std::string& name) {
  throw std::runtime_error(fmt::format(
      "{}: this mdana was built without zstd; choose .gz, or build with libzstd", name));
}

#endif

}  // namespace mdana
