// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects.hpp"

#include <fmt/format.h>

#include "analyses/defects/frame_look.hpp"
#include "analyses/defects/lines/columns.hpp"
#include "analyses/defects/sent_atoms.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

using namespace defects;

void add_surface_columns(std::vector<ColumnSpec>& all) {
  const ColumnSpec parts[] = {{"surface_area", dimension::area},
                              {"surface_area_error", dimension::area},
                              {"surface_volume", dimension::volume},
                              {"surface_volume_error", dimension::volume},
                              {"surface_radius", dimension::length},
                              {"surface_radius_error", dimension::length},
                              {"voids", dimension::none},
                              {"void_volume", dimension::volume},
                              {"radius_atoms", dimension::length},
                              {"radius_gyration", dimension::length}};
  for (const char* body : {"1", "2"})
    for (const ColumnSpec& part : parts) all.push_back({part.name + body, part.dimension});
  all.push_back({"patch_area", dimension::area});
  all.push_back({"patch_area_error", dimension::area});
}

/// A product on its way to the settings' function.
class DefectProduct final : public Product {
 public:
  DefectProduct(const DefectSettings& settings, const FrameHeader& header, FrameDefects found)
      : settings_(settings), header_(header), found_(std::move(found)) {}
  void give() override { settings_.product(header_, found_); }

  void send(const std::function<void(const std::string&)>& to) override {
    Parcel parcel;
    parcel(header_, found_);
    to(parcel.take());
    if (settings_.labels) send_atoms(*found_.atoms, to);
  }

 private:
  const DefectSettings& settings_;
  FrameHeader header_;
  FrameDefects found_;
};

class Defects final : public FrameAnalysis {
 public:
  explicit Defects(DefectSettings settings) : settings_(std::move(settings)) {}

  Needs needs() const override {
    Needs needs{{"x", "y", "z"}, false, /*whole_frame=*/true};
    if (settings_.ids) needs.columns.add("id");
    if (settings_.types) needs.columns.add("type");
    return needs;
  }

  std::vector<ColumnSpec> columns() const override {
    std::vector<ColumnSpec> all{{"spacing", dimension::length}};
    for (const char* name : {"fcc", "hcp", "bcc", "ico", "other", "surface", "contact",
                             "bulk_defect", "repaired"})
      all.push_back({name, dimension::none});
    for (const char* of : {"", "1", "2"})
      for (const char* kind : {"fault_area", "twin_area"})
        all.push_back({std::string(kind) + of, dimension::area});
    for (const char* axis : {"x", "y", "z"})
      all.push_back({std::string("defect_") + axis, dimension::length});
    for (const char* body : {"1", "2"})
      for (const char* part : {"lattice_w", "lattice_x", "lattice_y", "lattice_z", "lattice_share"})
        all.push_back({std::string(part) + body, dimension::none});
    if (settings_.surface) add_surface_columns(all);
    if (settings_.lines) add_line_columns(all);
    return all;
  }

  /// As measured: 57 in a whole frame, 6 more in a slab; labels are kept until the next frame is done.
  std::size_t bytes_an_atom() const override { return settings_.labels ? 128 : 64; }

  std::unique_ptr<Product> look(const FrameHeader& header, const FrameStore& atoms, std::size_t threads,
                                std::span<double> row) const override {
    FrameDefects found = FrameLook(settings_, header, atoms, threads).fill(row);
    if (!settings_.product) return nullptr;
    return std::make_unique<DefectProduct>(settings_, header, std::move(found));
  }

  void give_sent(const std::function<std::string()>& from) const override {
    Parcel parcel(from());
    FrameHeader header;
    FrameDefects found;
    parcel(header, found);
    const auto atoms = settings_.labels ? std::make_shared<const SentAtoms>(from) : nullptr;
    found.atoms = atoms;
    settings_.product(header, found);
    if (atoms) atoms->for_blocks([](const FrameAtoms&, const AtomLabels&) {});  // what is left of them
  }

 private:
  DefectSettings settings_;
};

}  // namespace

std::string_view name(PlanarFault kind) {
  switch (kind) {
    case PlanarFault::intrinsic: return "intrinsic";
    case PlanarFault::extrinsic: return "extrinsic";
    case PlanarFault::twin: return "twin";
    case PlanarFault::none: break;
  }
  return "none";
}

std::unique_ptr<Analysis> make_defects(DefectSettings settings) {
  return std::make_unique<Defects>(std::move(settings));
}

std::optional<Eigen::Quaterniond> lattice_turn(const Table& table, std::size_t row, int body) {
  const auto value = [&](const char* part) {
    return table.column(fmt::format("lattice_{}{}", part, body))[row];
  };
  const Eigen::Quaterniond turn(value("w"), value("x"), value("y"), value("z"));
  if (turn.squaredNorm() == 0) return std::nullopt;
  return turn;
}

extern const AnalysisMember defects_analysis;
const AnalysisMember defects_analysis{
    "defects", "crystal structure of the atoms, stacking faults and twins",
    [](const AnalysisSetup& setup) {
      DefectSettings settings;
      settings.ids = setup.first.has_column("id");
      return make_defects(std::move(settings));
    }};

}  // namespace mdana
