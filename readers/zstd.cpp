// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/zstd.hpp"

#include "readers/input_error.hpp"

#ifdef MDANA_WITH_ZSTD
#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <zstd.h>
#include <zstd_errors.h>
#endif

namespace mdana {

bool is_zstd(std::string_view head) {
  using namespace std::string_view_literals;
  if (head.starts_with("\x28\xb5\x2f\xfd"sv)) return true;
  return head.size() >= 4 && (head[0] & 0xf0) == 0x50 && head.substr(1, 3) == "\x2a\x4d\x18"sv;
}

#ifdef MDANA_WITH_ZSTD
namespace {

struct Place {
  std::uint64_t compressed = 0;
  std::uint64_t decompressed = 0;
};

std::string trouble(std::size_t error) {
  if (ZSTD_getErrorCode(error) == ZSTD_error_frameParameter_windowTooLarge)
    return "the zstd data need a window above 128 MB; recompress them without --long=28 and more";
  return fmt::format("the zstd data are corrupt ({}); what was read before is not certain either",
                     ZSTD_getErrorName(error));
}

/// One decompressor with its own place in the file.
class Unpacker {
 public:
  explicit Unpacker(RawFile& file) : file_(&file) {
    if (!stream_) throw std::runtime_error("zstd: no memory");
  }

  /// Fewer bytes than there is room for only at the end or at damage.
  std::size_t read(std::span<char> into) {
    ZSTD_outBuffer out{into.data(), into.size(), 0};
    while (out.pos < out.size && !ended_) step(out);
    offset_ += out.pos;
    return out.pos;
  }

  /// Passes over bytes up to the offset.
  void skip_to(std::uint64_t offset) {
    std::vector<char> scratch(1 << 17);
    while (offset_ < offset && !ended_)
      read(std::span(scratch).first(std::min<std::uint64_t>(scratch.size(), offset - offset_)));
  }

  /// At the start of a zstd frame.
  void restart(const Place& frame) {
    ZSTD_DCtx_reset(stream_.get(), ZSTD_reset_session_only);
    position_ = frame.compressed;
    offset_ = frame.decompressed;
    frame_ = frame;
    in_.pos = in_.size = 0;
    hint_ = 0;
    flushing_ = false;
    ended_ = false;
  }

  std::uint64_t offset() const { return offset_; }  ///< decompressed bytes before this place
  const Place& frame() const { return frame_; }     ///< where the zstd frame that it is in starts
  const std::string& damage() const { return damage_; }

 private:
  void step(ZSTD_outBuffer& out) {
    if (in_.pos == in_.size && !flushing_ && !refill()) return end();
    if (hint_ == 0) frame_ = {position_ - (in_.size - in_.pos), offset_ + out.pos};
    hint_ = ZSTD_decompressStream(stream_.get(), &out, &in_);
    if (ZSTD_isError(hint_))
      return fail(trouble(hint_));
    flushing_ = out.pos == out.size && hint_ != 0;  // there may be more that needs no input
  }

  bool refill() {
    file_->seek(position_);
    in_ = {buffer_.data(), file_->read(buffer_), 0};
    position_ += in_.size;
    return in_.size > 0;
  }

  void end() {
    if (hint_ != 0) fail("the zstd data end early, the file was cut");
    ended_ = true;
  }

  void fail(const std::string& what) {
    damage_ = fmt::format("{} (compressed byte {})", what, position_ - (in_.size - in_.pos));
    ended_ = true;
  }

  struct Free {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
  };
  RawFile* file_;
  std::unique_ptr<ZSTD_DStream, Free> stream_{ZSTD_createDStream()};
  std::vector<char> buffer_ = std::vector<char>(ZSTD_DStreamInSize());
  ZSTD_inBuffer in_{buffer_.data(), 0, 0};
  std::uint64_t position_ = 0;  ///< in the file, behind the buffer
  std::uint64_t offset_ = 0;
  Place frame_;
  std::size_t hint_ = 0;  ///< 0 between zstd frames
  bool flushing_ = false;
  bool ended_ = false;
  std::string damage_;
};

class Zstd final : public ByteSource {
 public:
  explicit Zstd(std::unique_ptr<RawFile> file)
      : file_(std::move(file)), reading_(*file_), waiting_(*file_) {}

  std::size_t read(std::span<char> into) override { return reading_.read(into); }

  void mark() override {
    marked_ = reading_.offset();
    marked_frame_ = reading_.frame();
  }

  void reset() override {
    std::swap(reading_, waiting_);
    if (reading_.offset() > marked_ || reading_.offset() < marked_frame_.decompressed)
      reading_.restart(marked_frame_);
    reading_.skip_to(marked_);
  }

  std::string damage() const override {
    return reading_.damage().empty() ? waiting_.damage() : reading_.damage();
  }
  double share() const override { return file_->share(); }
  const std::filesystem::path& path() const override { return file_->path(); }
  InputRecord record() override { return file_->record(); }

 private:
  std::unique_ptr<RawFile> file_;
  Unpacker reading_;
  Unpacker waiting_;
  std::uint64_t marked_ = 0;
  Place marked_frame_;
};

}  // namespace

std::unique_ptr<ByteSource> open_zstd(std::unique_ptr<RawFile> file) {
  return std::make_unique<Zstd>(std::move(file));
}

#else

std::unique_ptr<ByteSource> open_zstd(std::unique_ptr<RawFile> file) {
  throw InputError(file->record().path +
                   ": compressed by zstd, which this mdana was built without; decompress it by "
                   "'zstd -d' or build with libzstd");
}

#endif

}  // namespace mdana
