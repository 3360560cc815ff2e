// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/labelled_dump.hpp"

#include <algorithm>

#include "reports/conversion.hpp"

namespace mdana {
namespace {

constexpr const char* prefix = "c_mdana_";

/// A column of the labels: its name, and the value of each atom; empty if it was not asked for.
struct LabelColumn {
  std::string name;
  std::vector<double> values;
};

template <class T>
LabelColumn column(const char* name, const std::vector<T>& values) {
  LabelColumn made{std::string(prefix) + name, {}};
  made.values.reserve(values.size());
  for (const T& value : values) made.values.push_back(static_cast<double>(value));
  return made;
}

std::vector<LabelColumn> label_columns(const FrameAtoms& atoms, const AtomLabels& labels) {
  std::vector<LabelColumn> all{column("body", atoms.body),
                               column("structure", labels.structure),
                               column("site", labels.site),
                               column("margin", labels.margin),
                               column("cluster", labels.cluster),
                               column("csp", labels.centro_symmetry),
                               column("coordination", labels.coordination)};
  std::erase_if(all, [](const LabelColumn& c) { return c.values.empty(); });
  return all;
}

void put(std::span<const double> values, std::size_t first, std::span<double> block) {
  std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), block.size(), block.begin());
}

std::array<std::string, 3> axes(const Box& box) {
  if (box.any_periodic()) return {"xu", "yu", "zu"};
  return {"x", "y", "z"};
}

const std::filesystem::path& checked(const std::filesystem::path& place, const Run& run) {
  check_new_file(run.dump, place);
  return place;
}

}  // namespace

LabelledDump::LabelledDump(const std::filesystem::path& place, const Format& format, const Run& run)
    : file_(checked(place, run)),
      writer_(format.create(file_.path())),
      units_(run.units),
      timestep_(run.timestep_source == "dump" ? std::nullopt : run.timestep) {}

void LabelledDump::add(const FrameHeader& header, const FrameAtoms& atoms,
                       const AtomLabels& labels) {
  const auto columns = label_columns(atoms, labels);
  const auto axis = axes(header.box);
  FrameHeader out = header;
  out.atoms = atoms.size();
  out.units = units_;
  if (timestep_) out.time = static_cast<double>(header.step) * *timestep_;
  out.columns.clear();
  if (!atoms.id.empty()) out.columns.push_back("id");
  if (!atoms.type.empty()) out.columns.push_back("type");
  out.columns.insert(out.columns.end(), axis.begin(), axis.end());
  for (const LabelColumn& c : columns) out.columns.push_back(c.name);
  writer_->begin(out);
  AtomBlock block;
  for (std::size_t first = 0; first < atoms.size(); first += AtomBlock::capacity) {
    block.reset(first / AtomBlock::capacity, std::min(AtomBlock::capacity, atoms.size() - first));
    const auto at = static_cast<std::ptrdiff_t>(first);
    const auto count = static_cast<std::ptrdiff_t>(block.atoms());
    if (!atoms.id.empty()) std::copy_n(atoms.id.begin() + at, count, block.make_integer("id").begin());
    if (!atoms.type.empty())
      std::copy_n(atoms.type.begin() + at, count, block.make_integer("type").begin());
    put(atoms.x, first, block.make_real(axis[0]));
    put(atoms.y, first, block.make_real(axis[1]));
    put(atoms.z, first, block.make_real(axis[2]));
    for (const LabelColumn& c : columns) put(c.values, first, block.make_real(c.name));
    writer_->add(block);
  }
}

void LabelledDump::commit() {
  writer_->finish();
  writer_.reset();
  file_.commit();
}

}  // namespace mdana
