// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/labelled_dump.hpp"

#include <algorithm>

#include "reports/conversion.hpp"

namespace mdana {
namespace {

constexpr const char* prefix = "c_mdana_";

/// Calls use(name, values) for the columns that there are.
template <class Use>
void for_columns(const FrameAtoms& atoms, const AtomLabels& labels, const Use& use) {
  const auto column = [&](const char* name, const auto& values) {
    if (!values.empty()) use(std::string(prefix) + name, values);
  };
  column("body", atoms.body);
  column("structure", labels.structure);
  column("site", labels.site);
  column("margin", labels.margin);
  column("cluster", labels.cluster);
  column("csp", labels.centro_symmetry);
  column("coordination", labels.coordination);
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

void LabelledDump::add(const FrameHeader& header, const LabelledAtoms& all) {
  file_.writing([&] { write(header, all); });
}

void LabelledDump::write(const FrameHeader& header, const LabelledAtoms& all) {
  const auto axis = axes(header.box);
  blocks_ = 0;
  all.for_blocks([&](const FrameAtoms& atoms, const AtomLabels& labels) {
    if (blocks_ == 0) {
      FrameHeader out = header;
      out.atoms = all.size();
      out.units = units_;
      if (timestep_) out.time = static_cast<double>(header.step) * *timestep_;
      out.columns.clear();
      if (!atoms.id.empty()) out.columns.push_back("id");
      if (!atoms.type.empty()) out.columns.push_back("type");
      out.columns.insert(out.columns.end(), axis.begin(), axis.end());
      for_columns(atoms, labels, [&](const std::string& name, const auto&) { out.columns.push_back(name); });
      writer_->begin(out);
    }
    add_block(axis, atoms, labels);
  });
}

void LabelledDump::add_block(const std::array<std::string, 3>& axis, const FrameAtoms& atoms,
                             const AtomLabels& labels) {
  AtomBlock block;
  block.reset(blocks_++, atoms.size());
  if (!atoms.id.empty()) std::ranges::copy(atoms.id, block.make_integer("id").begin());
  if (!atoms.type.empty()) std::ranges::copy(atoms.type, block.make_integer("type").begin());
  std::ranges::copy(atoms.x, block.make_real(axis[0]).begin());
  std::ranges::copy(atoms.y, block.make_real(axis[1]).begin());
  std::ranges::copy(atoms.z, block.make_real(axis[2]).begin());
  for_columns(atoms, labels, [&](const std::string& name, const auto& values) {
    std::ranges::transform(values, block.make_real(name).begin(), [](auto value) { return static_cast<double>(value); });
  });
  writer_->add(block);
}

void LabelledDump::commit() {
  file_.writing([&] { writer_->finish(); });
  writer_.reset();
  file_.commit();
}

}  // namespace mdana
