// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "readers/format.hpp"
#include "readers/frame_index.hpp"
#include "readers/input_error.hpp"
#include "readers/lammps_binary/atoms.hpp"
#include "readers/lammps_binary/byte_order.hpp"
#include "readers/lammps_binary/header.hpp"
#include "readers/lammps_binary/stretches.hpp"

namespace mdana {
namespace {

using lammps_binary::AtomLayout;
using lammps_binary::Header;
using lammps_binary::Stretches;

/// The atoms of a frame stand in one block a rank, each behind the number of its doubles; chunks
/// are cut regardless of them.
class LammpsBinary final : public FrameSource {
 public:
  LammpsBinary(std::unique_ptr<ByteSource> bytes, const std::filesystem::path& path,
               const ColumnSet& wanted)
      : file_(std::move(bytes), path.string()), wanted_(wanted), indexing_(path) {}

  bool next(FrameHeader& header) override {
    skip_atoms();
    const auto offset = file_.offset();
    const auto found = lammps_binary::read_header(file_, frames_);
    if (!found) {
      file_.check_damage();
      if (offset && indexing_.wanted(frames_, *offset))
        indexing_.write(file_.bytes().record().hash);
      return false;
    }
    header_ = *found;
    if (offset) indexing_.met(frames_, {*offset, 0, header_.frame.step, header_.frame.atoms});
    layout_ = std::make_shared<AtomLayout>(header_, wanted_, file_.path());
    ++frames_;
    file_.mark();
    at_first_atom();
    if (atoms_left_ == 0) expect_no_more();
    header = header_.frame;
    return true;
  }

  bool cut(Chunk& chunk, std::size_t most) override {
    if (atoms_left_ == 0) return false;
    const std::uint64_t first = header_.frame.atoms - atoms_left_;
    chunk.number = first / AtomBlock::capacity;
    chunk.first_line = first + 1;
    chunk.atoms = static_cast<std::size_t>(std::min<std::uint64_t>(atoms_left_, most));
    chunk.layout = layout_;
    find_rank();
    if (!view(chunk)) gather(chunk);
    if (atoms_left_ == 0) expect_no_more();
    return true;
  }

  void seek(std::uint64_t index) override {
    const auto found = index > frames_ && file_.offset() ? indexing_.find(index) : std::nullopt;
    if (!found || found->number <= frames_) return;
    const std::uint64_t offset = *file_.offset();
    file_.jump(found->frame.offset);
    if (is_there(*found)) {
      frames_ = found->number;
      atoms_left_ = 0;
      ranks_left_ = 0;
      file_.bytes().assume_hash(found->hash);
    } else {
      indexing_.discard();
      file_.jump(offset);
    }
  }

  std::optional<double> share() const override { return file_.bytes().share(); }

  void restart_frame() override {
    file_.reset();
    at_first_atom();
  }

  std::vector<InputRecord> records() override { return {file_.bytes().record()}; }

 private:
  /// Whether a frame begins here, and is the one that the index says; stays here.
  bool is_there(const FrameIndexing::Found& found) {
    bool same = false;
    try {
      const auto header = lammps_binary::read_header(file_, found.number);
      same = header && header->frame.step == found.frame.step &&
             header->frame.atoms == found.frame.atoms;
    } catch (const InputError&) {  // no frame begins here: the index is not used
    }
    file_.jump(found.frame.offset);
    return same;
  }

  std::size_t bytes_of_atom() const { return header_.frame.columns.size() * sizeof(double); }

  void at_first_atom() {
    atoms_left_ = header_.frame.atoms;
    atoms_left_in_rank_ = 0;
    ranks_left_ = header_.ranks;
  }

  /// The chunk as it stands in a mapped file, if it is within one rank's block.
  bool view(Chunk& chunk) {
    if (atoms_left_in_rank_ < chunk.atoms) return false;
    const auto bytes = file_.view(chunk.atoms * bytes_of_atom(), Chunk::padding);
    if (!bytes) return false;
    chunk.bytes = *bytes;
    passed(chunk.atoms);
    return true;
  }

  void gather(Chunk& chunk) {
    chunk.storage.clear();
    for (std::size_t left = chunk.atoms; left > 0;) {
      find_rank();
      const auto atoms =
          static_cast<std::size_t>(std::min<std::uint64_t>(left, atoms_left_in_rank_));
      const std::size_t bytes = atoms * bytes_of_atom();
      expect_bytes(file_.append(bytes, chunk.storage), bytes);
      passed(atoms);
      left -= atoms;
    }
    const std::size_t size = chunk.storage.size();
    chunk.storage.resize(size + Chunk::padding);
    chunk.bytes = {chunk.storage.data(), size};
  }

  void skip_atoms() {
    while (atoms_left_ > 0) {
      find_rank();
      const std::uint64_t bytes = atoms_left_in_rank_ * bytes_of_atom();
      expect_bytes(file_.skip(bytes), bytes);
      passed(atoms_left_in_rank_);
    }
    expect_no_more();
  }

  void passed(std::uint64_t atoms) {
    atoms_left_in_rank_ -= atoms;
    atoms_left_ -= atoms;
  }

  /// Moves on to a rank that has atoms left.
  void find_rank() {
    while (atoms_left_in_rank_ == 0) {
      if (ranks_left_ == 0)
        file_.fail(
            fmt::format("frame {} (step {}): the blocks of its {} ranks hold {} atoms; the "
                        "header says {}",
                        header_.frame.index, header_.frame.step, header_.ranks,
                        header_.frame.atoms - atoms_left_, header_.frame.atoms));
      next_rank();
    }
  }

  /// Ranks without atoms may follow the last atom.
  void expect_no_more() {
    while (ranks_left_ > 0) next_rank();
  }

  void next_rank() {
    std::array<char, sizeof(std::int32_t)> bytes;
    expect_bytes(file_.read(bytes), bytes.size());
    const auto numbers = lammps_binary::load<std::int32_t>(bytes.data(), header_.swapped);
    const auto columns = static_cast<std::int64_t>(header_.frame.columns.size());
    if (numbers < 0 || numbers % columns != 0)
      file_.fail(fmt::format("frame {} (step {}): a rank's block of {} numbers, {} an atom",
                             header_.frame.index, header_.frame.step, numbers, columns));
    --ranks_left_;
    atoms_left_in_rank_ = static_cast<std::uint64_t>(numbers / columns);
    if (atoms_left_in_rank_ > atoms_left_)
      file_.fail(
          fmt::format("frame {} (step {}): a rank's block of {} atoms, but only {} of the "
                      "header's {} are left",
                      header_.frame.index, header_.frame.step, atoms_left_in_rank_, atoms_left_,
                      header_.frame.atoms));
  }

  void expect_bytes(std::uint64_t got, std::uint64_t wanted) const {
    if (got < wanted)
      file_.ended(
          fmt::format("within the atoms of frame {} (step {}): of {} atoms at most {} are "
                      "there",
                      header_.frame.index, header_.frame.step, header_.frame.atoms,
                      header_.frame.atoms - atoms_left_ + got / bytes_of_atom()));
  }

  Stretches file_;
  ColumnSet wanted_;
  Header header_;
  std::shared_ptr<const AtomLayout> layout_;
  FrameIndexing indexing_;
  std::uint64_t frames_ = 0;  ///< begun
  std::uint64_t atoms_left_ = 0;
  std::uint64_t atoms_left_in_rank_ = 0;
  std::int32_t ranks_left_ = 0;
};

bool recognises(std::string_view head) {
  return lammps_binary::begins_header(head) || lammps_binary::begins_old_header(head);
}

std::unique_ptr<FrameSource> open(std::unique_ptr<ByteSource> bytes,
                                  const std::filesystem::path& path, const ColumnSet& wanted) {
  return std::make_unique<LammpsBinary>(std::move(bytes), path, wanted);
}

}  // namespace

extern const Format lammps_binary_format;
const Format lammps_binary_format{"lammps_binary", "LAMMPS binary dump (styles atom and custom)",
                                  recognises, open};

}  // namespace mdana
