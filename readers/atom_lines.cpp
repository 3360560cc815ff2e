// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/atom_lines.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/frame_index.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// Blank lines and comments may stand before a frame.
bool is_between_frames(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos || line.starts_with('#');
}

class AtomLineFrames final : public FrameSource {
 public:
  AtomLineFrames(const AtomLineDump& dump, std::unique_ptr<ByteSource> bytes,
                 const std::filesystem::path& path, const ColumnSet& wanted)
      : dump_(dump),
        lines_(std::move(bytes)),
        path_(path.string()),
        wanted_(wanted),
        indexing_(path) {}

  bool next(FrameHeader& header) override {
    expect_lines(lines_.skip(lines_left_), lines_left_);
    lines_left_ = 0;
    if (careful_) expect_header();
    const auto offset = lines_.offset();
    const std::uint64_t line = lines_.number();
    const auto found = read_header();
    if (!found) {
      check_bytes();
      if (offset && indexing_.wanted(frames_, *offset))
        indexing_.write(lines_.bytes().record().hash);
      return false;
    }
    header_ = *found;
    if (offset) indexing_.met(frames_, {*offset, line, header_.step, header_.atoms});
    layout_ = dump_.layout(header_, wanted_, path_);
    ++frames_;
    in_header_ = false;
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
    const LineReader::Lines lines = lines_.take(chunk.atoms, chunk.storage, Chunk::padding,
                                                careful_ ? dump_.section_start : std::string_view());
    chunk.bytes = lines.text;
    if (careful_ && lines.count > 0) chunk.atoms = lines.count;
    expect_lines(lines.count, chunk.atoms);
    lines_left_ -= chunk.atoms;
    return true;
  }

  void seek(std::uint64_t index) override {
    const auto found = index > frames_ && lines_.offset() ? indexing_.find(index) : std::nullopt;
    if (!found || found->number <= frames_) return;
    const std::uint64_t offset = *lines_.offset(), line = lines_.number();
    lines_.jump(found->frame.offset, found->frame.line);
    if (is_there(*found)) {
      frames_ = found->number;
      lines_left_ = 0;
      lines_.bytes().assume_hash(found->hash);
    } else {
      indexing_.discard();
      lines_.jump(offset, line);
    }
  }

  std::optional<double> share() const override { return lines_.bytes().share(); }

  void restart_frame() override {
    lines_.reset();
    lines_left_ = header_.atoms;
  }

  void expect_faults() override { careful_ = !dump_.section_start.empty(); }

  bool recover() override {
    lines_left_ = 0;
    if (ended_ || !careful_ || lines_.met_too_long()) return false;
    if (!in_header_) return true;  // at the beginning of a header, or at the end
    in_header_ = false;
    ++frames_;
    lines_.reset();
    return dump_.to_next_header(lines_);
  }

  std::vector<InputRecord> records() override { return {lines_.bytes().record()}; }

 private:
  /// Whether a frame begins here, and is the one that the index says; stays here.
  bool is_there(const FrameIndexing::Found& found) {
    bool same = false;
    try {
      const auto header = dump_.read_header(lines_, path_, found.number);
      same = header && header->step == found.frame.step && header->atoms == found.frame.atoms;
    } catch (const InputError&) {  // no frame begins here: the index is not used
    }
    lines_.jump(found.frame.offset, found.frame.line);
    return same;
  }

  std::optional<FrameHeader> read_header() {
    try {
      return dump_.read_header(lines_, path_, frames_);
    } catch (const TruncatedInput&) {
      check_bytes();  // which tell more if they are damaged
      throw;
    }
  }

  /// Throws if there are more atoms than the frame's header says; notes where the next one begins.
  void expect_header() {
    std::uint64_t more = 0, first = 0;
    for (auto line = lines_.peek(); line && !line->starts_with(dump_.section_start);
         line = lines_.peek()) {
      if (!is_between_frames(*line) && ++more == 1) first = lines_.number() + 1;
      lines_.line();
    }
    if (more > 0)
      throw WrongAtomCount(fmt::format("{}:{}: {} lines more than the {} atoms of the header of "
                                       "frame {} (step {})", path_, first, more, header_.atoms,
                                       header_.index, header_.step));
    lines_.mark();
    in_header_ = true;
  }

  void expect_lines(std::size_t got, std::size_t wanted) {
    if (got == wanted) return;
    if (careful_ && lines_.peek())
      throw WrongAtomCount(fmt::format("{}:{}: frame {} (step {}) ends after {} lines of atoms; its "
                                       "header says {}", path_, lines_.number() + 1, header_.index,
                                       header_.step, header_.atoms - lines_left_ + got,
                                       header_.atoms));
    ended_ = true;
    check_bytes();
    throw TruncatedInput(fmt::format(
        "{}:{}: the file ends within the atoms of frame {} (step {}): {} whole lines are missing{}",
        path_, lines_.number(), header_.index, header_.step, lines_left_ - got,
        lines_.unfinished() ? ", the last one has no end" : ""));
  }

  void check_bytes() {
    const std::string damage = lines_.bytes().damage();
    if (damage.empty()) return;
    ended_ = true;
    throw TruncatedInput(fmt::format("{}: {} in frame {}", path_, damage, frames_));
  }

  AtomLineDump dump_;
  LineReader lines_;
  std::string path_;
  ColumnSet wanted_;
  FrameHeader header_;
  std::shared_ptr<const FrameLayout> layout_;
  FrameIndexing indexing_;
  std::uint64_t frames_ = 0;  ///< begun
  std::uint64_t lines_left_ = 0;
  bool careful_ = false;    ///< faults are expected
  bool in_header_ = false;  ///< careful: the place to go back to is the beginning of a header
  bool ended_ = false;      ///< the file, too early
};

}  // namespace

std::unique_ptr<FrameSource> open_atom_lines(const AtomLineDump& dump,
                                             std::unique_ptr<ByteSource> bytes,
                                             const std::filesystem::path& path,
                                             const ColumnSet& wanted) {
  return std::make_unique<AtomLineFrames>(dump, std::move(bytes), path, wanted);
}

}  // namespace mdana
