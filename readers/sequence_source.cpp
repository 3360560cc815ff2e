// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/sequence_source.hpp"

#include "readers/raw_file.hpp"

namespace mdana {
namespace {

void append(std::vector<InputRecord>& all, const std::vector<InputRecord>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

class SequenceSource final : public FrameSource {
 public:
  SequenceSource(FileSet files, OpenPieces open)
      : files_(std::move(files)), open_(std::move(open)) {
    open_next();
  }

  bool next(FrameHeader& header) override {
    while (current_ || open_next()) {
      in_next_ = true;
      if (current_->next(header)) {
        header.index += before_;
        frames_ = header.index + 1;
        in_next_ = false;
        return true;
      }
      pass_file();
    }
    return false;
  }

  bool cut(Chunk& chunk, std::size_t most) override {
    if (!current_ || !current_->cut(chunk, most)) return false;
    chunk.file = current_;  // which is left for the next one while its chunks are still in use
    return true;
  }

  std::optional<double> share() const override {
    const double within = current_ ? current_->share().value_or(0) : 1;
    return (static_cast<double>(opened_) - 1 + within) / static_cast<double>(files_.size());
  }

  void restart_frame() override { current_->restart_frame(); }

  void expect_faults() override {
    careful_ = true;
    if (current_) current_->expect_faults();
  }

  /// Within the file, else with the next one.
  bool recover() override {
    if (current_ && current_->recover()) return true;
    if (in_next_) ++frames_;
    if (current_) {
      pass_file();
    } else {
      for (const auto& file : files_[opened_]) passed_.push_back(RawFile(file).record());
      ++opened_;
    }
    return opened_ < files_.size();
  }

  /// Of all files, also those behind one that is damaged.
  std::vector<InputRecord> records() override {
    std::vector<InputRecord> all = passed_;
    if (current_) append(all, current_->records());
    for (std::size_t k = opened_; k < files_.size(); ++k)
      for (const auto& file : files_[k]) all.push_back(RawFile(file).record());
    return all;
  }

 private:
  void pass_file() {
    append(passed_, current_->records());
    current_.reset();
  }

  bool open_next() {
    if (opened_ == files_.size()) return false;
    in_next_ = true;
    current_ = open_(files_[opened_]);
    if (careful_) current_->expect_faults();
    ++opened_;
    before_ = frames_;
    return true;
  }

  FileSet files_;
  OpenPieces open_;
  std::size_t opened_ = 0;
  std::shared_ptr<FrameSource> current_;
  std::uint64_t frames_ = 0;  ///< so far
  std::uint64_t before_ = 0;  ///< the current file
  bool careful_ = false;      ///< faults are expected
  bool in_next_ = false;      ///< not within the atoms of a frame
  std::vector<InputRecord> passed_;
};

}  // namespace

std::unique_ptr<FrameSource> open_sequence(FileSet files, OpenPieces open) {
  return std::make_unique<SequenceSource>(std::move(files), std::move(open));
}

}  // namespace mdana
