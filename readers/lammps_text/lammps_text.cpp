// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "readers/format.hpp"
#include "readers/input_error.hpp"
#include "readers/lammps_text/atoms.hpp"
#include "readers/lammps_text/header.hpp"
#include "readers/lammps_text/writer.hpp"
#include "readers/line_reader.hpp"

namespace mdana {
namespace {

using lammps_text::AtomLayout;

class LammpsText final : public FrameSource {
 public:
  LammpsText(std::unique_ptr<ByteSource> bytes, const std::filesystem::path& path,
             const ColumnSet& wanted)
      : lines_(std::move(bytes)), path_(path.string()), wanted_(wanted) {}

  bool next(FrameHeader& header) override {
    expect_lines(lines_.skip(lines_left_), lines_left_);
    lines_left_ = 0;
    const auto found = lammps_text::read_header(lines_, path_, frames_);
    if (!found) {
      check_bytes();
      return false;
    }
    header_ = *found;
    layout_ = std::make_shared<AtomLayout>(header_, wanted_, path_);
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

  mutable LineReader lines_;
  std::string path_;
  ColumnSet wanted_;
  FrameHeader header_;
  std::shared_ptr<const AtomLayout> layout_;
  std::uint64_t frames_ = 0;
  std::uint64_t lines_left_ = 0;
};

/// The first line that is neither blank nor a comment begins with ITEM.
bool recognises(std::string_view head) {
  while (!head.empty()) {
    const std::size_t start = head.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return false;
    head.remove_prefix(start);
    if (head.front() != '#') return head.starts_with("ITEM: ");
    head.remove_prefix(std::min(head.find('\n'), head.size()));
  }
  return false;
}

std::unique_ptr<FrameSource> open(std::unique_ptr<ByteSource> bytes,
                                  const std::filesystem::path& path, const ColumnSet& wanted) {
  return std::make_unique<LammpsText>(std::move(bytes), path, wanted);
}

}  // namespace

extern const Format lammps_text_format;
const Format lammps_text_format{
    "lammps_text",
    "LAMMPS text dump (styles atom and custom)",
    recognises,
    open,
    "lammpstrj lammpstrj.gz lammpstrj.zst dump dump.gz dump.zst",
    lammps_text::create_writer};

}  // namespace mdana
