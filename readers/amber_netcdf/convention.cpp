// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/amber_netcdf/convention.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "readers/amber_netcdf/unit_words.hpp"
#include "readers/column_names.hpp"
#include "readers/columns.hpp"
#include "readers/input_error.hpp"

namespace mdana::amber_netcdf {
namespace {

constexpr std::size_t most_numbers_of_atom = 128;  ///< of a variable; LAMMPS writes up to 100

/// Vectors whose components have names of their own.
struct Vector {
  std::string_view name;
  std::array<std::string_view, 3> columns;
};
constexpr Vector vectors[] = {
    {"coordinates", {"x", "y", "z"}},
    {"unwrapped_coordinates", {"xu", "yu", "zu"}},
    {"scaled_coordinates", {"xs", "ys", "zs"}},
    {"velocities", {"vx", "vy", "vz"}},
    {"forces", {"fx", "fy", "fz"}},
    {"mu", {"mux", "muy", "muz"}},
};

bool holds_word(std::string text, const std::string& word) {
  std::ranges::replace(text, ',', ' ');
  std::istringstream stream(text);
  for (std::string found; stream >> found;)
    if (found == word) return true;
  return false;
}

bool is_plain(const std::string& name) {
  return std::ranges::all_of(name, [](char c) { return c > ' ' && c <= '~'; });
}

class ContentReader {
 public:
  ContentReader(const ClassicHeader& header, const NetcdfFile& file, const std::string& path)
      : header_(header), file_(file), path_(path) {}

  Content read() {
    check_conventions();
    find_axes();
    units();
    for (std::size_t k = 0; k < header_.variables.size(); ++k) atom_variable(k);
    ids();
    check_columns();
    frame_variables();
    return std::move(content_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", path_, what));
  }

  void check_conventions() const {
    const std::string conventions = file_.text(NetcdfFile::whole_file, "Conventions").value_or("");
    if (holds_word(conventions, "AMBERRESTART"))
      fail("an AMBER restart file (of one frame); give a trajectory");
    if (!holds_word(conventions, "AMBER"))
      fail(
          "a netCDF file whose attribute Conventions does not name AMBER: of netCDF files, "
          "trajectories by AMBER's convention are read");
    const auto version = file_.text(NetcdfFile::whole_file, "ConventionVersion");
    if (version && *version != "1.0")
      fail(
          "the attribute ConventionVersion is not 1.0, the version of AMBER's convention that is "
          "read");
  }

  void find_axes() {
    const auto frame = header_.axis("frame"), atom = header_.axis("atom");
    if (!frame) fail("no dimension 'frame'");
    if (!atom) fail("no dimension 'atom'");
    frame_ = *frame;
    atom_ = *atom;
    content_.atoms = header_.axes[atom_].length;
    content_.frames_are_records = header_.axes[frame_].length == 0;
    content_.frames = content_.frames_are_records ? header_.records : header_.axes[frame_].length;
    if (content_.atoms == 0)
      fail("the dimension 'atom' is unlimited; that of the frames should be");
    if (content_.frames_are_records && content_.frames > 0 && header_.record_bytes == 0)
      fail("the frames hold no numbers");
    // Of records as many are read as are there.
    const std::uint64_t fixed_frames = content_.frames_are_records ? 0 : content_.frames;
    if (std::max(content_.atoms, fixed_frames) > header_.file_bytes)
      fail(fmt::format("{} frames of {} atoms, more than a file of {} bytes can hold", content_.frames,
                       content_.atoms, header_.file_bytes));
  }

  bool in_frames(const Variable& v) const { return !v.axes.empty() && v.axes[0] == frame_; }

  double scale(int id) const {
    const double scale = file_.number(id, "scale_factor").value_or(1);
    const std::string& name = header_.variables[static_cast<std::size_t>(id)].name;
    if (!std::isfinite(scale) || scale == 0)
      fail(fmt::format("{}: a scale_factor of {}", name, scale));
    if (file_.number(id, "add_offset").value_or(0) != 0)
      fail(fmt::format("{}: the attribute add_offset is not of AMBER's convention", name));
    return scale;
  }

  /// Variables over atoms (and frames, and a few numbers of each atom) are columns.
  void atom_variable(std::size_t k) {
    const Variable& v = header_.variables[k];
    const std::size_t before = in_frames(v);
    if (v.type == Type::character || !is_plain(v.name)) return;
    if (v.axes.size() <= before || v.axes.size() > before + 2 || v.axes[before] != atom_) return;
    const std::uint64_t numbers =
        v.axes.size() == before + 2 ? header_.axes[v.axes[before + 1]].length : 1;
    if (numbers > most_numbers_of_atom || numbers == 0) return;
    const int id = static_cast<int>(k);
    content_.variables.push_back({id, v.name, v.type, static_cast<std::size_t>(numbers),
                                  before == 1, scale(id), file_.fill(id, v.type)});
    columns_of(v, v.axes.size() == before + 2);
    if (content_.columns.size() > most_columns)
      fail(fmt::format("more than {} columns", most_columns));
  }

  void columns_of(const Variable& v, bool several) {
    const std::size_t numbers = content_.variables.back().numbers;
    const auto vector = std::ranges::find(vectors, v.name, &Vector::name);
    const bool named = vector != std::end(vectors) && (v.name != "forces" || forces_fit_);
    if (named && numbers != 3)
      fail(fmt::format("{}: {} numbers an atom instead of 3", v.name, numbers));
    for (std::size_t place = 0; place < numbers; ++place)
      add_column(named     ? std::string(vector->columns[place])
                 : several ? fmt::format("{}[{}]", v.name, place + 1)
                           : v.name,
                 place);
  }

  void add_column(const std::string& name, std::size_t place) {
    if (kind_of_column(name) == ColumnKind::text) return;  // numbers are no words
    content_.columns.push_back({name, content_.variables.size() - 1, place});
  }

  void ids() {
    if (std::ranges::find(content_.columns, "id", &AtomColumn::name) == content_.columns.end())
      content_.columns.insert(content_.columns.begin(), {"id", std::nullopt, 0});
  }

  void check_columns() const {
    std::set<std::string_view> seen;
    for (const AtomColumn& column : content_.columns) {
      if (!seen.insert(column.name).second)
        fail(fmt::format("two variables are the column '{}'", column.name));
      if (kind_of_column(column.name) == ColumnKind::integer && column.variable &&
          content_.variables[*column.variable].scale != 1)
        fail(fmt::format("whole numbers in column '{}' have a scale_factor", column.name));
    }
  }

  std::optional<FrameVariable> frame_variable(std::string_view name, std::size_t numbers) const {
    const auto k = header_.variable(name);
    if (!k) return std::nullopt;
    const Variable& v = header_.variables[*k];
    const std::size_t before = in_frames(v);
    const bool shaped = numbers == 1 ? v.axes.size() == before
                                     : v.axes.size() == before + 1 &&
                                           header_.axes[v.axes[before]].length == numbers;
    if (!shaped || v.type == Type::character)
      fail(fmt::format("{}: not {} of numbers a frame", name, numbers == 1 ? "one" : "three"));
    const int id = static_cast<int>(*k);
    return FrameVariable{id, v.type, numbers, before == 1, scale(id), file_.fill(id, v.type)};
  }

  void frame_variables() {
    content_.lengths = frame_variable("cell_lengths", 3);
    content_.angles = frame_variable("cell_angles", 3);
    content_.origin = frame_variable("cell_origin", 3);
    if (content_.lengths && !content_.angles) fail("cell_lengths, but no cell_angles");
    if (content_.angles) {
      const auto unit = file_.text(content_.angles->id, "units").value_or("degree");
      if (!unit.starts_with("degree")) fail("the units of cell_angles are not degree");
    }
    content_.time = frame_variable("time", 1);
    content_.step = frame_variable("Step", 1);  // of LAMMPS' dump_modify thermo yes
    content_.time_counts_steps = content_.time &&
                                 file_.text(NetcdfFile::whole_file, "program") == "LAMMPS" &&
                                 file_.number(content_.time->id, "scale_factor").has_value();
  }

  /// Narrows the systems down by the attribute of a variable that is there and has it.
  void narrow(UnitSystems& systems, std::string_view name, mdana::Dimension dimension) const {
    const auto k = header_.variable(name);
    const auto unit = k ? file_.text(static_cast<int>(*k), "units") : std::nullopt;
    if (unit && !unit->empty()) systems = common(systems, systems_with(dimension, *unit));
  }

  /// Forces beside other units (AMBER's kcal/mol/angstrom beside picoseconds) do not decide, but
  /// they are no forces of the system, either.
  void units() {
    UnitSystems systems = all_systems();
    narrow(systems, "time", dimension::time);
    for (const char* name : {"coordinates", "unwrapped_coordinates", "cell_lengths", "cell_origin"})
      narrow(systems, name, dimension::length);
    narrow(systems, "velocities", dimension::velocity);
    UnitSystems with_forces = systems;
    narrow(with_forces, "forces", dimension::force);
    forces_fit_ = systems.empty() || !with_forces.empty();
    content_.units = only(forces_fit_ ? with_forces : systems);
  }

  const ClassicHeader& header_;
  const NetcdfFile& file_;
  const std::string& path_;
  Content content_;
  std::size_t frame_ = 0, atom_ = 0;
  bool forces_fit_ = true;
};

}  // namespace

Content read_content(const ClassicHeader& header, const NetcdfFile& file, const std::string& path) {
  return ContentReader(header, file, path).read();
}

}  // namespace mdana::amber_netcdf
