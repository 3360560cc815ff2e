// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <fstream>

#include <fmt/format.h>

#include "readers/amber_netcdf/atoms.hpp"
#include "readers/amber_netcdf/classic_header.hpp"
#include "readers/amber_netcdf/convention.hpp"
#include "readers/amber_netcdf/frames.hpp"
#include "readers/amber_netcdf/netcdf_file.hpp"
#include "readers/format.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using namespace amber_netcdf;

[[noreturn]] void ended(const std::string& path, const ClassicHeader& header, std::uint64_t whole) {
  throw TruncatedInput(fmt::format(
      "{}: the file ends within frame {}: {} bytes are there; the header needs {} for {} frames",
      path, whole, header.file_bytes, header.end_of_records(header.records), header.records));
}

/// Of a file that is whole as far as its first frame; the library need not open others.
ClassicHeader header_of_some_frame(const std::filesystem::path& path) {
  ClassicHeader header = read_classic_header(path);
  const bool none = header.records > 0 && header.whole_records() == 0;
  if (none || !header.fixed_part_is_whole()) ended(path.string(), header, 0);
  return header;
}

class AmberNetcdf final : public FrameSource {
 public:
  AmberNetcdf(std::unique_ptr<ByteSource> bytes, const std::filesystem::path& path,
              const ColumnSet& wanted)
      : bytes_(std::move(bytes)),
        path_(path.string()),
        wanted_(wanted),
        header_(header_of_some_frame(path)),
        file_(path),
        content_(std::make_shared<Content>(read_content(header_, file_, path_))),
        whole_frames_(count_whole_frames()) {}

  bool next(FrameHeader& header) override {
    atoms_left_ = 0;
    if (frames_ == content_->frames) {
      expect_end();
      return false;
    }
    if (frames_ >= whole_frames_) ended(path_, header_, whole_frames_);
    frame_ = read_frame(*content_, file_, path_, frames_);
    check_scaled();
    layout_ = std::make_shared<AtomLayout>(frame_, content_, wanted_);
    ++frames_;
    restart_frame();
    header = frame_;
    return true;
  }

  bool cut(Chunk& chunk, std::size_t most) override {
    if (atoms_left_ == 0) return false;
    const std::uint64_t first = content_->atoms - atoms_left_;
    chunk.number = first / AtomBlock::capacity;
    chunk.first_line = first + 1;
    chunk.atoms = static_cast<std::size_t>(std::min<std::uint64_t>(atoms_left_, most));
    chunk.layout = layout_;
    const std::size_t size = layout_->bytes(chunk.atoms);
    chunk.storage.resize(size + Chunk::padding);
    for (const auto& [variable, offset] : layout_->parts(chunk.atoms))
      read(*variable, first, chunk.atoms, chunk.storage.data() + offset);
    chunk.bytes = {chunk.storage.data(), size};
    atoms_left_ -= chunk.atoms;
    return true;
  }

  void restart_frame() override { atoms_left_ = content_->atoms; }

  std::vector<InputRecord> records() override { return {bytes_->record()}; }

 private:
  std::uint64_t count_whole_frames() const {
    return content_->frames_are_records ? header_.whole_records() : content_->frames;
  }

  void read(const AtomVariable& v, std::uint64_t first, std::size_t atoms, char* into) const {
    const std::array<std::size_t, 3> start{frame_.index, first, 0}, count{1, atoms, v.numbers};
    const std::size_t skip = v.in_frames ? 0 : 1;
    file_.read(v.id, std::span(start).subspan(skip), std::span(count).subspan(skip), into);
  }

  /// Whole frames behind those that the header counts: their writer came to no end.
  void expect_end() const {
    const std::uint64_t end = header_.end_of_records(header_.records);
    if (header_.record_bytes == 0 || header_.file_bytes - end < header_.record_bytes) return;
    throw TruncatedInput(fmt::format(
        "{}: the header counts {} frames, but {} bytes follow them: the file was not closed, or is "
        "still being written",
        path_, content_->frames, header_.file_bytes - end));
  }

  /// Positions cannot be made of fractions of a length that is not stated.
  void check_scaled() const {
    const bool positions = wanted_.has("x") || wanted_.has("y") || wanted_.has("z");
    const auto source = position_source(frame_.columns);
    const Eigen::Vector3d lengths = frame_.box.edges.colwise().norm();
    if (positions && source && source->scaled && !(lengths.minCoeff() > 0))
      throw InputError(
          fmt::format("{}: scaled_coordinates, but cell_lengths are not stated or 0, as LAMMPS "
                      "writes them where "
                      "the box is not periodic; dump x y z or xu yu zu",
                      frame_.place));
  }

  std::unique_ptr<ByteSource> bytes_;
  std::string path_;
  ColumnSet wanted_;
  ClassicHeader header_;
  NetcdfFile file_;
  std::shared_ptr<const Content> content_;
  std::uint64_t whole_frames_;
  std::uint64_t frames_ = 0;
  std::uint64_t atoms_left_ = 0;
  FrameHeader frame_;
  std::shared_ptr<const AtomLayout> layout_;
};

bool recognises(std::string_view head) {
  return head.size() >= 4 && head.starts_with("CDF") &&
         (head[3] == 1 || head[3] == 2 || head[3] == 5);
}

std::unique_ptr<FrameSource> open(std::unique_ptr<ByteSource> bytes,
                                  const std::filesystem::path& path, const ColumnSet& wanted) {
  std::array<char, 4> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  if (!recognises({head.data(), head.size()}))
    throw InputError(
        fmt::format("{}: a compressed netCDF file, which netCDF's library cannot read; "
                    "decompress it first",
                    path.string()));
  return std::make_unique<AmberNetcdf>(std::move(bytes), path, wanted);
}

}  // namespace

extern const Format amber_netcdf_format;
const Format amber_netcdf_format{
    "amber_netcdf", "AMBER netCDF trajectory (also by LAMMPS' dump netcdf)", recognises, open};

}  // namespace mdana
