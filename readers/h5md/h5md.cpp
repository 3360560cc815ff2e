// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>
#include <fstream>
#include <numeric>

#include <fmt/format.h>

#include "readers/format.hpp"
#include "readers/h5md/atoms.hpp"
#include "readers/h5md/particles.hpp"
#include "readers/h5md/writer.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using h5md::AtomLayout;
using h5md::Element;
using h5md::Particles;

constexpr std::string_view signature{"\x89HDF\r\n\x1a\n", 8};

/// Deflate makes at most about a thousandth of constant numbers.
constexpr std::uint64_t most_compression = 1100;

hdf5::Group open_h5md(const std::filesystem::path& path) {
  hdf5::Group file = hdf5::open_file(path);
  if (!file.has_group("h5md"))
    throw InputError(fmt::format("{}: an HDF5 file, but not one of H5MD (it has no group 'h5md')",
                                 path.string()));
  const auto version = file.group("h5md").integers("version");
  if (version.size() != 2 || version.front() != 1)
    throw InputError(fmt::format("{}: /h5md: the attribute 'version' must be 1.0 or 1.1",
                                 path.string()));
  return file;
}

/// HDF5 opens files itself, and only plain ones. Throws InputError unless the file is one.
const std::filesystem::path& plain(const std::filesystem::path& path) {
  std::string head(signature.size(), '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head != signature)
    throw InputError(fmt::format("{}: HDF5 within a compressed file cannot be read; decompress it "
                                 "first (HDF5 can compress within its files)",
                                 path.string()));
  return path;
}

/// Rows of the file in which there is an atom, of a window of rows.
struct Window {
  std::uint64_t first = 0;
  std::size_t rows = 0;
  std::vector<std::size_t> kept;  ///< counted from the first
};

class H5md final : public FrameSource {
 public:
  H5md(std::unique_ptr<ByteSource> bytes, const std::filesystem::path& path,
       const ColumnSet& wanted)
      : bytes_(std::move(bytes)),
        wanted_(wanted),
        particles_(open_h5md(plain(path))),
        absent_(particles_.absent()) {
    expect_room(std::filesystem::file_size(path) * most_compression);
  }

  bool next(FrameHeader& header) override {
    atoms_left_ = 0;
    const Particles::Frames frames = particles_.frames(needed_);
    if (frames_ >= frames.whole) return end(frames);
    header_ = particles_.header(frames_);
    set_layout();
    if (frames_ >= particles_.frames(needed_).whole) return end(particles_.frames(needed_));
    for (const Element* element : needed_) particles_.check_step(*element, frames_, header_.step);
    if (absent_)
      count_atoms();
    else if (header_.atoms > 0)
      particles_.position().element.check_stored(frames_, 0, header_.atoms - 1);
    frame_ = frames_++;
    restart_frame();
    header = header_;
    return true;
  }

  bool cut(Chunk& chunk, std::size_t most) override {
    if (atoms_left_ == 0) return false;
    const std::uint64_t first = header_.atoms - atoms_left_;
    chunk.number = first / AtomBlock::capacity;
    chunk.first_line = first + 1;
    chunk.atoms = static_cast<std::size_t>(std::min<std::uint64_t>(atoms_left_, most));
    chunk.layout = layout_;
    const std::size_t size = chunk.atoms * layout_->bytes_of_atom();
    chunk.storage.resize(size + Chunk::padding);
    chunk.bytes = {chunk.storage.data(), size};
    for (std::size_t filled = 0; filled < chunk.atoms;) {
      const Window window = next_window(chunk.atoms - filled);
      read(window, chunk, filled);
      filled += window.kept.size();
    }
    atoms_left_ -= chunk.atoms;
    return true;
  }

  void restart_frame() override {
    atoms_left_ = header_.atoms;
    row_ = 0;
  }

  std::vector<InputRecord> records() override { return {bytes_->record()}; }

 private:
  /// Of so many numbers in the file.
  void expect_room(std::uint64_t numbers) const {
    const std::uint64_t frames = std::max<std::uint64_t>(particles_.frames({}).begun, 1);
    const std::uint64_t rows = std::max<std::uint64_t>(particles_.rows(), 1);
    if (frames > numbers / rows)
      throw InputError(fmt::format("{}: {} frames of {} atoms, more than a file of its size can hold",
                                   particles_.place(), frames, rows));
  }

  bool end(const Particles::Frames& frames) const {
    if (frames.begun > frames.whole)
      throw TruncatedInput(fmt::format("{}: of {} frames {} have all their data", particles_.place(),
                                       frames.begun, frames.whole));
    return false;
  }

  void set_layout() {
    layout_ = std::make_shared<AtomLayout>(header_, particles_, wanted_);
    needed_.clear();
    for (const auto& part : layout_->parts()) needed_.push_back(part.element);
  }

  void count_atoms() {
    particles_.check_step(particles_.id(), frames_, header_.step);
    frame_ = frames_;
    row_ = 0;
    header_.atoms = 0;
    while (row_ < particles_.rows()) header_.atoms += next_window(AtomBlock::capacity).kept.size();
  }

  /// The next rows, with at most so many atoms, and moves on behind them.
  Window next_window(std::size_t most) {
    Window window{row_, 0, {}};
    const std::uint64_t left = particles_.rows() - row_;
    if (left == 0) throw std::logic_error("h5md: atoms are left but no rows");
    window.rows = static_cast<std::size_t>(std::min<std::uint64_t>(
        left, absent_ ? AtomBlock::capacity : most));
    if (absent_)
      keep_present(window, most);
    else {
      window.kept.resize(window.rows);
      std::iota(window.kept.begin(), window.kept.end(), std::size_t{0});
    }
    row_ += window.rows;
    return window;
  }

  void keep_present(Window& window, std::size_t most) const {
    std::vector<std::int64_t> ids(window.rows);
    particles_.id().value().read(particles_.id().slab(frame_, window.first, window.rows), ids);
    for (std::size_t i = 0; i < ids.size() && window.kept.size() < most; ++i)
      if (ids[i] != *absent_) window.kept.push_back(i);
    if (window.kept.size() == most) window.rows = window.kept.back() + 1;
  }

  /// Puts a window's atoms into the chunk, behind those that it has.
  void read(const Window& window, Chunk& chunk, std::size_t filled) const {
    if (window.kept.empty()) return;
    char* start = chunk.storage.data();
    for (const AtomLayout::Part& part : layout_->parts()) {
      part.element->check_stored(frame_, window.first + window.kept.front(),
                                 window.first + window.kept.back());
      read(part, window, start + filled * part.bytes_of_atom());
      start += chunk.atoms * part.bytes_of_atom();
    }
  }

  void read(const AtomLayout::Part& part, const Window& window, char* to) const {
    const hdf5::Slab slab = part.element->slab(frame_, window.first, window.rows);
    const hdf5::Dataset& values = part.element->value();
    if (part.kind == ColumnKind::text) return put(values.read_texts(slab), part, window, to);
    if (part.kind == ColumnKind::integer) {
      std::vector<std::int64_t> numbers(window.rows * part.components);
      values.read(slab, numbers);
      return put(numbers, part, window, to);
    }
    std::vector<double> numbers(window.rows * part.components);
    values.read(slab, numbers);
    put(numbers, part, window, to);
  }

  template <class T>
  void put(const std::vector<T>& numbers, const AtomLayout::Part& part, const Window& window,
           char* to) const {
    for (std::size_t i = 0; i < window.kept.size(); ++i)
      std::memcpy(to + i * part.bytes_of_atom(), &numbers[window.kept[i] * part.components],
                  part.bytes_of_atom());
  }

  void put(const std::vector<std::string>& texts, const AtomLayout::Part& part,
           const Window& window, char* to) const {
    for (std::size_t i = 0; i < window.kept.size(); ++i) {
      const std::string& text = texts[window.kept[i]];
      if (text.size() > AtomLayout::text_bytes)
        throw InputError(fmt::format("{}: a text of {} bytes (at most {} are read)", part.place,
                                     text.size(), AtomLayout::text_bytes));
      char* room = to + i * AtomLayout::text_bytes;
      std::memset(room, 0, AtomLayout::text_bytes);
      std::memcpy(room, text.data(), text.size());
    }
  }

  std::unique_ptr<ByteSource> bytes_;
  ColumnSet wanted_;
  Particles particles_;
  std::optional<std::int64_t> absent_;
  std::vector<const Element*> needed_;
  FrameHeader header_;
  std::shared_ptr<const AtomLayout> layout_;
  std::uint64_t frames_ = 0;  ///< passed
  std::uint64_t frame_ = 0;
  std::uint64_t atoms_left_ = 0;
  std::uint64_t row_ = 0;
};

bool recognises(std::string_view head) { return head.starts_with(signature); }

std::unique_ptr<FrameSource> open(std::unique_ptr<ByteSource> bytes,
                                  const std::filesystem::path& path, const ColumnSet& wanted) {
  return std::make_unique<H5md>(std::move(bytes), path, wanted);
}

}  // namespace

extern const Format h5md_format;
const Format h5md_format{"h5md",     "H5MD 1.1 (HDF5 for molecular data)", recognises, open, "h5",
                         h5md::create};

}  // namespace mdana
