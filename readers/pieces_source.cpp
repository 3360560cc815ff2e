// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pieces_source.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// What pieces of one frame have to agree in and do not; else empty.
std::string difference(const FrameHeader& a, const FrameHeader& b) {
  if (a.step != b.step) return fmt::format("step {}", b.step);
  if (a.time != b.time) return "another time";
  if (a.columns != b.columns) return "other columns";
  if (a.box.origin != b.box.origin || a.box.edges != b.box.edges ||
      a.box.periodic != b.box.periodic)
    return "another box";
  if (a.units != b.units) return "other units";
  return {};
}

/// Blocks out of parts that the pieces' own layouts convert.
class JoinedLayout final : public FrameLayout {
 public:
  void convert(const Chunk& chunk, AtomBlock& block) const override {
    if (chunk.parts.size() == 1) return mdana::convert(chunk.parts.front(), block);
    block.reset(chunk.number, chunk.atoms);
    AtomBlock converted;
    std::size_t at = 0;
    for (const Chunk& part : chunk.parts) {
      mdana::convert(part, converted);
      block.put(converted, at);
      at += part.atoms;
    }
  }

  void check(const Chunk& chunk, AtomBlock& block, BlockFaults& faults) const override {
    block.reset(chunk.number, chunk.atoms);
    AtomBlock converted;
    std::size_t at = 0;
    for (const Chunk& part : chunk.parts) {
      BlockFaults of_part(faults.faults.limit());
      part.layout->check(part, converted, of_part);
      faults.faults.add(of_part.faults);
      for (std::size_t i = 0; i < part.atoms; ++i)
        if (!of_part.usable(i)) faults.spoil(at + i, chunk.atoms);
      if (!of_part.all_unusable) block.put(converted, at);
      faults.all_unusable = of_part.all_unusable && (at == 0 || faults.all_unusable);
      at += part.atoms;
    }
  }

  PrintedPrecision printed_precision(const Chunk& chunk, std::string_view column) const override {
    PrintedPrecision all{0, 0, true};
    for (const Chunk& part : chunk.parts) {
      const PrintedPrecision one = part.layout->printed_precision(part, column);
      if (one.digits == 0) continue;
      const bool same_decimals = all.digits == 0 || one.decimals == all.decimals;
      all = {std::max(all.digits, one.digits), std::max(all.decimals, one.decimals),
             all.fixed && one.fixed && same_decimals};
    }
    return all.digits == 0 ? PrintedPrecision{} : all;
  }
};

class PiecesSource final : public FrameSource {
 public:
  explicit PiecesSource(std::vector<std::unique_ptr<FrameSource>> pieces)
      : pieces_(std::move(pieces)), headers_(pieces_.size()) {}

  bool next(FrameHeader& header) override {
    if (!all_next()) return false;
    header = headers_.front();
    for (std::size_t k = 1; k < headers_.size(); ++k) {
      header.atoms += headers_[k].atoms;
      const std::string what = difference(headers_.front(), headers_[k]);
      if (!what.empty())
        throw InputError(fmt::format("{}: {}, unlike the piece {} of the same frame",
                                     headers_[k].place, what, headers_.front().place));
    }
    atoms_ = header.atoms;
    ++frames_;
    at_first_atom();
    return true;
  }

  bool cut(Chunk& chunk, std::size_t most) override {
    if (atoms_left_ == 0) return false;
    chunk.number = (atoms_ - atoms_left_) / AtomBlock::capacity;
    chunk.atoms = static_cast<std::size_t>(std::min<std::uint64_t>(atoms_left_, most));
    chunk.bytes = {};
    chunk.layout = layout_;
    cut_parts(chunk);
    chunk.first_line = chunk.parts.front().first_line;
    atoms_left_ -= chunk.atoms;
    return true;
  }

  std::optional<double> share() const override { return pieces_.front()->share(); }

  void expect_faults() override {
    for (const auto& piece : pieces_) piece->expect_faults();
  }

  void restart_frame() override {
    for (const auto& piece : pieces_) piece->restart_frame();
    at_first_atom();
  }

  std::vector<InputRecord> records() override {
    std::vector<InputRecord> all;
    for (const auto& piece : pieces_)
      for (InputRecord& record : piece->records()) all.push_back(std::move(record));
    return all;
  }

 private:
  /// Moves every piece on; false if all of them are at their end.
  bool all_next() {
    std::optional<std::size_t> with, without;
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      (pieces_[k]->next(headers_[k]) ? with : without) = k;
    if (with && without)
      throw TruncatedInput(fmt::format("{}: the file ends before frame {}, which is at {}",
                                       pieces_[*without]->records().front().path, frames_,
                                       headers_[*with].place));
    return with.has_value();
  }

  void at_first_atom() {
    atoms_left_ = atoms_;
    piece_ = 0;
  }

  void cut_parts(Chunk& chunk) {
    std::size_t used = 0;
    for (std::size_t left = chunk.atoms; left > 0;) {
      if (used == chunk.parts.size()) chunk.parts.emplace_back();
      Chunk& part = chunk.parts[used];
      if (!pieces_[piece_]->cut(part, left)) {
        ++piece_;
        continue;
      }
      part.number = chunk.number;
      left -= part.atoms;
      ++used;
    }
    chunk.parts.resize(used);
  }

  std::vector<std::unique_ptr<FrameSource>> pieces_;
  std::vector<FrameHeader> headers_;
  std::shared_ptr<const FrameLayout> layout_ = std::make_shared<JoinedLayout>();
  std::uint64_t frames_ = 0;
  std::uint64_t atoms_ = 0;
  std::uint64_t atoms_left_ = 0;
  std::size_t piece_ = 0;  ///< that the next atom is in
};

}  // namespace

std::unique_ptr<FrameSource> join_pieces(std::vector<std::unique_ptr<FrameSource>> pieces) {
  return std::make_unique<PiecesSource>(std::move(pieces));
}

}  // namespace mdana
