// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/atom_lines.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

class AtomLineFrames final : public FrameSource {
 public:
  AtomLineFrames(const AtomLineDump& dump, std::unique_ptr<ByteSource> bytes,
                 const std::filesystem::path& path, const ColumnSet& wanted)
      : dump_(dump), lines_(std::move(bytes)), path_(path.string()), wanted_(wanted) {}

  bool next(FrameHeader& header) override {
    expect_lines(lines_.skip(lines_left_), lines_left_);
    lines_left_ = 0;
    const auto found = dump_.read_header(lines_, path_, frames_);
    if (!found) {
      check_bytes();
      return false;
    }
    header_ = *found;
    layout_ = dump_.layout(header_, wanted_, path_);
    ++frames_;
    lines_left_ = header_.atoms;
    lines_.mark();
    header = header_;
    return true;
  }

  bool cut(Chunk& chunk, std::size_t most) override {
    if (lines_left_ == 0) return false;
    chunk.layout = layout_;
    chunk.number = (header_.atoms - lines_left_) / AtomBlock::capacity;
    chunk.first_line = lines_.number() + 1;
    chunk.atoms = std::min<std::size_t>(lines_left_, most);
    const LineReader::Lines lines = lines_.take(chunk.atoms, chunk.storage, Chunk::padding);
    chunk.bytes = lines.text;
    expect_lines(lines.count, chunk.atoms);
    lines_left_ -= chunk.atoms;
    return true;
  }

  void restart_frame() override {
    lines_.reset();
    lines_left_ = header_.atoms;
  }

  std::vector<InputRecord> records() override { return {lines_.bytes().record()}; }

 private:
  void expect_lines(std::size_t got, std::size_t wanted) const {
    if (got == wanted) return;
    check_bytes();
    throw TruncatedInput(fmt::format(
        "{}:{}: the file ends within the atoms of frame {} (step {}): {} whole lines are missing{}",
        path_, lines_.number(), header_.index, header_.step, lines_left_ - got,
        lines_.unfinished() ? ", the last one has no end" : ""));
  }

  void check_bytes() const {
    const std::string damage = lines_.bytes().damage();
    if (!damage.empty())
      throw TruncatedInput(fmt::format("{}: {} in frame {}", path_, damage, frames_));
  }

  AtomLineDump dump_;
  mutable LineReader lines_;
  std::string path_;
  ColumnSet wanted_;
  FrameHeader header_;
  std::shared_ptr<const FrameLayout> layout_;
  std::uint64_t frames_ = 0;
  std::uint64_t lines_left_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_atom_lines(const AtomLineDump& dump,
                                             std::unique_ptr<ByteSource> bytes,
                                             const std::filesystem::path& path,
                                             const ColumnSet& wanted) {
  return std::make_unique<AtomLineFrames>(dump, std::move(bytes), path, wanted);
}

}  // namespace mdana
