// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/writer.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/h5md/column_groups.hpp"
#include "readers/hdf5.hpp"
#include "readers/input_error.hpp"

namespace mdana::h5md {
namespace {

constexpr std::uint64_t rows_of_chunk = AtomBlock::capacity;  ///< 3 x 8 bytes x it: below 1 MB
constexpr std::uint64_t frames_of_chunk = 256;                ///< of what is small
constexpr std::int64_t no_atom = -1;                          ///< fill value of `id`
constexpr std::size_t text_bytes = 32;

/// `unit` attributes in the words of H5MD's module units, where MDAnalysis knows them, too: it
/// refuses files with others.
struct UnitWords {
  Units units;
  std::string_view time, length, velocity, force;
};
constexpr std::array<UnitWords, 3> unit_words{
    {{Units::real, "fs", "Angstrom", "Angstrom fs-1", "kcal mol-1 Angstrom-1"},
     {Units::metal, "ps", "Angstrom", "Angstrom ps-1", ""},
     {Units::nano, "ns", "nm", "nm ns-1", ""}}};

void set_unit(hdf5::Dataset& dataset, std::string_view unit) {
  if (!unit.empty()) dataset.set_text("unit", std::string(unit));
}

/// An element that is written, and its values.
struct Series {
  ColumnGroup group;
  hdf5::Dataset value;
};

class H5mdWriter final : public FrameWriter {
 public:
  explicit H5mdWriter(const std::filesystem::path& path)
      : path_(path), file_(hdf5::create_file(path)) {}

  void begin(const FrameHeader& header) override {
    end_frame();
    if (series_.empty())
      set_up(header);
    else
      check(header);
    current_ = header;
    rows_ = std::max(rows_, header.atoms);
    for (Series& s : series_) s.value.extend(shape_of(s, frames_ + 1));
    written_ = 0;
    open_frame_ = true;
  }

  void add(const AtomBlock& block) override {
    if (!open_frame_ || written_ + block.atoms() > current_.atoms)
      throw std::logic_error("h5md: more atoms than the frame has");
    if (block.atoms() == 0) return;
    check_ids(block);
    for (Series& s : series_) write(s, block);
    written_ += block.atoms();
  }

  void finish() override {
    end_frame();
    if (series_.empty()) describe(std::nullopt);
    hdf5::flush(*file_);
    series_.clear();
    step_.reset(), time_.reset(), edges_.reset(), origin_.reset(), file_.reset();
  }

 private:
  // What the first frame says.

  void describe(std::optional<Units> units) {
    hdf5::Group h5md = file_->make_group("h5md");
    h5md.set_integers("version", std::array<std::int64_t, 2>{1, 1});
    h5md.make_group("author").set_text("name", "not stated");
    hdf5::Group creator = h5md.make_group("creator");
    creator.set_text("name", "mdana");
    creator.set_text("version", MDANA_VERSION);
    if (!units) return;
    const auto it = std::ranges::find(unit_words, *units, &UnitWords::units);
    if (it == unit_words.end()) return;
    words_ = *it;
    h5md.make_group("modules").make_group("units").set_integers("version",
                                                               std::array<std::int64_t, 2>{1, 0});
  }

  void set_up(const FrameHeader& header) {
    const auto groups = column_groups(header);
    describe(header.units);
    first_ = header;
    rows_ = header.atoms;
    hdf5::Group all = file_->make_group("particles").make_group("all");
    if (header.units) all.set_text("mdana_units", std::string(name(*header.units)));
    for (const ColumnGroup& group : groups) add_series(all, group);
    add_box(all);
  }

  void add_series(hdf5::Group& all, const ColumnGroup& group) {
    hdf5::Group element = all.make_group(group.element);
    if (group.columns.front() == "xu")
      element.set_text("mdana_columns", fmt::format("{}", fmt::join(group.columns, " ")));
    add_clock(element);
    hdf5::NewDataset wanted{group.kind == ColumnKind::real      ? hdf5::Kind::real
                            : group.kind == ColumnKind::integer ? hdf5::Kind::integer
                                                                : hdf5::Kind::text,
                            {0, rows_},
                            {1, std::clamp<std::uint64_t>(rows_, 1, rows_of_chunk)},
                            text_bytes};
    if (group.columns.size() > 1)
      for (hdf5::Shape* shape : {&wanted.shape, &wanted.chunk}) shape->push_back(group.columns.size());
    if (group.element == "id") wanted.fill = no_atom;
    series_.push_back({group, element.make_dataset("value", wanted)});
    set_unit(series_.back().value, group.element == "position"   ? words_.length
                                   : group.element == "velocity" ? words_.velocity
                                   : group.element == "force"    ? words_.force
                                                                 : "");
  }

  /// Step and time, which all elements share.
  void add_clock(hdf5::Group& element) {
    if (step_) {
      element.link("step", *step_);
      if (time_) element.link("time", *time_);
      return;
    }
    step_ = element.make_dataset("step", {hdf5::Kind::integer, {0}, {frames_of_chunk}});
    if (!first_.time) return;
    time_ = element.make_dataset("time", {hdf5::Kind::real, {0}, {frames_of_chunk}});
    set_unit(*time_, words_.time);
  }

  void add_box(hdf5::Group& all) {
    hdf5::Group box = all.make_group("box");
    box.set_integer("dimension", 3);
    std::vector<std::string> boundary;
    for (const bool periodic : first_.box.periodic)
      boundary.push_back(periodic ? "periodic" : "none");
    box.set_texts("boundary", boundary);
    hdf5::Group edges = box.make_group("edges"), origin = box.make_group("origin");
    for (hdf5::Group* element : {&edges, &origin}) add_clock(*element);
    edges_ = edges.make_dataset("value", {hdf5::Kind::real, {0, 3, 3}, {frames_of_chunk, 3, 3}});
    origin_ = origin.make_dataset("value", {hdf5::Kind::real, {0, 3}, {frames_of_chunk, 3}});
    for (hdf5::Dataset* value : {&*edges_, &*origin_}) set_unit(*value, words_.length);
  }

  // What later frames must keep.

  [[noreturn]] void fail(const FrameHeader& header, const std::string& what) const {
    throw InputError(fmt::format("{}: {}; H5MD cannot hold both in {}", header.place, what,
                                 path_.string()));
  }

  void check(const FrameHeader& header) const {
    if (header.columns != first_.columns) fail(header, "other columns than in the first frame");
    if (header.box.periodic != first_.box.periodic)
      fail(header, "other periodic faces than in the first frame");
    if (header.units && header.units != first_.units)
      fail(header, "other units than in the first frame");
    if (header.time.has_value() != first_.time.has_value())
      fail(header, "frames with a time and without");
    if (header.atoms != first_.atoms && !header.has_column("id"))
      fail(header, fmt::format("{} atoms after {}, and no column id to tell which are there",
                               header.atoms, first_.atoms));
  }

  void check_ids(const AtomBlock& block) const {
    if (!first_.has_column("id")) return;
    if (std::ranges::find(block.integer("id"), no_atom) != block.integer("id").end())
      throw InputError(fmt::format("{}: an atom has the id {}, which means no atom in H5MD",
                                   current_.place, no_atom));
  }

  // Values.

  hdf5::Shape shape_of(const Series& s, std::uint64_t frames) const {
    hdf5::Shape shape{frames, rows_};
    if (s.group.columns.size() > 1) shape.push_back(s.group.columns.size());
    return shape;
  }

  void write(Series& s, const AtomBlock& block) {
    hdf5::Slab slab{shape_of(s, 1), shape_of(s, 1)};
    std::ranges::fill(slab.first, 0);
    slab.first[0] = frames_;
    slab.first[1] = written_;
    slab.count[1] = block.atoms();
    const auto& columns = s.group.columns;
    switch (s.group.kind) {
      case ColumnKind::text: return s.value.write(slab, block.text(columns.front()));
      case ColumnKind::integer:
        return s.value.write(slab, side_by_side<std::int64_t>(
                                       columns, block.atoms(),
                                       [&](const auto& name) { return block.integer(name); }));
      case ColumnKind::real:
        return s.value.write(
            slab, side_by_side<double>(columns, block.atoms(),
                                       [&](const auto& name) { return block.real(name); }));
    }
  }

  template <class T, class ColumnOf>
  static std::vector<T> side_by_side(const std::vector<std::string>& columns, std::size_t atoms,
                                     ColumnOf&& column_of) {
    std::vector<T> values(columns.size() * atoms);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::span<const T> column = column_of(columns[k]);
      for (std::size_t i = 0; i < atoms; ++i) values[i * columns.size() + k] = column[i];
    }
    return values;
  }

  /// A frame's step is written last: without it the frame is not whole.
  void end_frame() {
    if (!open_frame_) return;
    if (written_ != current_.atoms) throw std::logic_error("h5md: fewer atoms than the frame has");
    append(*edges_, {1, 3, 3}, std::span<const double>(current_.box.edges.data(), 9));
    append(*origin_, {1, 3}, std::span<const double>(current_.box.origin.data(), 3));
    if (time_) append(*time_, {1}, std::span<const double>(&*current_.time, 1));
    append(*step_, {1}, std::span<const std::int64_t>(&current_.step, 1));
    ++frames_;
    open_frame_ = false;
  }

  template <class T>
  void append(hdf5::Dataset& dataset, hdf5::Shape shape, std::span<const T> values) {
    hdf5::Slab slab{hdf5::Shape(shape.size(), 0), shape};
    slab.first[0] = frames_;
    shape[0] = frames_ + 1;
    dataset.extend(shape);
    dataset.write(slab, values);
  }

  std::filesystem::path path_;
  std::optional<hdf5::Group> file_;
  UnitWords words_{};
  std::vector<Series> series_;
  std::optional<hdf5::Dataset> step_, time_, edges_, origin_;
  FrameHeader first_, current_;
  std::uint64_t rows_ = 0;     ///< places for atoms in a frame
  std::uint64_t frames_ = 0;   ///< that are whole
  std::uint64_t written_ = 0;  ///< atoms of the frame that is begun
  bool open_frame_ = false;
};

}  // namespace

std::unique_ptr<FrameWriter> create(const std::filesystem::path& path) {
  return std::make_unique<H5mdWriter>(path);
}

}  // namespace mdana::h5md
