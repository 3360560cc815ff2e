// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gzip.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace mdana {
namespace {

class Gzip final : public ByteSource {
 public:
  Gzip(std::unique_ptr<RawFile> file, std::unique_ptr<Inflate> inflate)
      : file_(std::move(file)), inflate_(std::move(inflate)), buffer_(1 << 18) {}

  std::size_t read(std::span<char> into) override {
    std::span<char> out = into;
    while (!out.empty() && !ended_) inside_member_ ? step(out) : start_member();
    return into.size() - out.size();
  }

  void mark() override {
    marked_ = inflate_->copy();
    marked_position_ = position();
    marked_inside_ = inside_member_;
    marked_ended_ = ended_;
  }

  void reset() override {
    if (!marked_) throw std::logic_error("reset without mark");
    inflate_ = marked_->copy();
    seek(marked_position_);
    inside_member_ = marked_inside_;
    ended_ = marked_ended_;
  }

  std::string damage() const override { return damage_; }
  double share() const override { return file_->share(); }
  const std::filesystem::path& path() const override { return file_->path(); }
  InputRecord record() override { return file_->record(); }

 private:
  std::uint64_t position() const { return file_->position() - input_.size(); }

  void seek(std::uint64_t position) {
    file_->seek(position);
    input_ = {};
  }

  void give_back(std::size_t bytes) {
    if (static_cast<std::size_t>(input_.data() - buffer_.data()) >= bytes)
      input_ = {input_.data() - bytes, input_.size() + bytes};
    else  // they came with the filling of the buffer before
      seek(position() - bytes);
  }

  /// True if there is input, from the file if need be.
  bool refill() {
    if (input_.empty()) input_ = {buffer_.data(), file_->read(buffer_)};
    return !input_.empty();
  }

  /// Between members: the next one, or the end.
  void start_member() {
    if (!refill()) {
      ended_ = true;
    } else if (input_.front() == '\x1f') {
      inflate_->start_member();
      inside_member_ = true;
    } else {
      pass_padding();
    }
  }

  void pass_padding() {
    while (refill()) {
      const std::size_t zeros = std::min(input_.find_first_not_of('\0'), input_.size());
      input_.remove_prefix(zeros);
      if (!input_.empty()) return fail("what follows the gzip data is neither gzip nor padding");
    }
    ended_ = true;
  }

  void step(std::span<char>& out) {
    const std::size_t before = input_.size() + out.size();
    const Inflate::Result result = inflate_->step(input_, out);
    if (result.state == Inflate::State::member_ended) {
      inside_member_ = false;
      give_back(result.unused);
    } else if (result.state == Inflate::State::corrupt) {
      corrupt(result.what);
    } else if (!out.empty() && input_.empty()) {
      if (!refill()) fail("the gzip data end early, the file was cut");
    } else if (input_.size() + out.size() == before) {
      corrupt("");
    }
  }

  void corrupt(const std::string& what) {
    fail(fmt::format("the gzip data are corrupt ({}); what was read before is not certain either",
                     what.empty() ? "unknown error" : what));
  }

  void fail(const std::string& what) {
    damage_ = fmt::format("{} (compressed byte {})", what, position());
    ended_ = true;
  }

  std::unique_ptr<RawFile> file_;
  std::unique_ptr<Inflate> inflate_;
  std::vector<char> buffer_;
  std::string_view input_;  ///< of the buffer, not yet taken
  bool inside_member_ = false;
  bool ended_ = false;
  std::string damage_;

  std::unique_ptr<Inflate> marked_;
  std::uint64_t marked_position_ = 0;
  bool marked_inside_ = false;
  bool marked_ended_ = false;
};

}  // namespace

std::unique_ptr<Inflate> fastest_inflate() {
  auto isal = make_isal_inflate();
  return isal ? std::move(isal) : make_zlib_inflate();
}

std::unique_ptr<ByteSource> open_gzip(std::unique_ptr<RawFile> file,
                                      std::unique_ptr<Inflate> inflate) {
  return std::make_unique<Gzip>(std::move(file), std::move(inflate));
}

}  // namespace mdana
