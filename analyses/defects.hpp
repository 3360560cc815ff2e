// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "analyses/analysis.hpp"
#include "analyses/dislocation_lines.hpp"
#include "analyses/value.hpp"

namespace mdana {

/// Crystal structure about an atom, from its nearest neighbours; numbered as OVITO does.
enum class Structure : std::uint8_t { other, fcc, hcp, bcc, ico };

/// Where an atom of no crystal structure is; see analyses/defects/defects.md.
enum class Site : std::uint8_t { crystal, surface, contact, bulk_defect };

/// Faults of the stacking of {111} layers, and what is left of hcp atoms.
enum class PlanarFault : std::uint8_t { none, intrinsic, extrinsic, twin };
std::string_view name(PlanarFault kind);

/// A connected piece of a planar fault.
struct FaultPlane {
  PlanarFault kind = PlanarFault::none;
  BodyIndex body = 0;
  Eigen::Vector3d normal, centre;  ///< unit vector of either sign; [length]
  double area = 0;                 ///< [length^2]
  double error = 0;                ///< [length^2]: each atom at the edge is cut anywhere in its cell
  std::size_t atoms = 0;           ///< hcp atoms

  template <class P>
  void pass(P& parcel) {
    parcel(kind, body, normal, centre, area, error, atoms);
  }
};

/// A closed part of a surface, through the centres of the atoms at it.
struct SurfacePart {
  double area = 0;    ///< [length^2]
  double volume = 0;  ///< enclosed [length^3]; negative for the wall of a void
  std::size_t triangles = 0;

  template <class P>
  void pass(P& parcel) {
    parcel(area, volume, triangles);
  }
};

/// A surface as triangles between atoms, corners against the clock seen from outside.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> points;                  ///< atoms at the surface [length]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points
  std::vector<std::uint32_t> part;                      ///< of each triangle
  std::vector<SurfacePart> parts;                       ///< greatest area first
  double area_error = 0, volume_error = 0;              ///< what other limits for what is filled change

  double area() const;         ///< of the outer parts [length^2]
  double volume() const;       ///< within them, voids included [length^3]
  std::size_t voids() const;   ///< parts with a negative volume
  double void_volume() const;  ///< [length^3]
  /// Of the ball of that volume, and half a {111} layer more, spacing/sqrt 6, since the mesh runs
  /// through the centres of atoms [length]; 0 without a volume.
  double radius(double spacing) const;
  /// Of half a layer, 0.1 spacings on other faces, and of the volume [length].
  double radius_error(double spacing) const;

  template <class P>
  void pass(P& parcel) {
    parcel(points, triangles, part, parts, area_error, volume_error);
  }
};

/// The surfaces of bodies 1 and 2, each as if it were alone, and where they cover each other.
struct BodySurfaces {
  std::array<SurfaceMesh, 2> body;
  Value patch{0, {}, dimension::area};  ///< where they cover each other

  template <class P>
  void pass(P& parcel) {
    parcel(body, patch);
  }
};

/// What is known of each of some atoms; what was not asked for is empty.
struct AtomLabels {
  std::vector<Structure> structure;
  std::vector<Site> site;
  std::vector<float> margin;                ///< 0 to 1: confidence of the structure
  std::vector<std::uint32_t> cluster;       ///< connected fcc atoms: 1, 2, ... by lowest id; 0 is none
  std::vector<float> centro_symmetry;       ///< [length^2]
  std::vector<std::uint8_t> coordination;   ///< atoms within 1.2071 spacings

  template <class P>
  void pass(P& parcel) {
    parcel(structure, site, margin, cluster, centro_symmetry, coordination);
  }
};

/// All atoms of a frame with their labels, in memory or in a temporary file.
class LabelledAtoms {
 public:
  virtual ~LabelledAtoms() = default;
  virtual std::size_t size() const = 0;
  /// Calls use(atoms, labels) for all atoms, by id (in the order of the file without), block by block: of
  /// AtomBlock::capacity atoms, the last one fewer.
  virtual void for_blocks(const std::function<void(const FrameAtoms&, const AtomLabels&)>& use) const = 0;
};

/// What a frame shows beyond its row.
struct FrameDefects {
  std::int64_t step = 0;
  std::shared_ptr<const LabelledAtoms> atoms;  ///< if labels are asked for
  std::vector<FaultPlane> planes;  ///< greatest first
  BodySurfaces surfaces;           ///< if they are asked for
  DislocationLines lines;          ///< likewise
  double spacing = 0;              ///< [length]
  /// Of bodies 1 and 2, with lines: turn of the lattice, mean place [length] and, as fcc, volume [length^3] of the atoms.
  std::array<std::optional<Eigen::Quaterniond>, 2> lattice;
  std::array<Eigen::Vector3d, 2> centre;
  std::array<double, 2> volume{};

  /// Without the atoms.
  template <class P>
  void pass(P& parcel) {
    parcel(step, planes, surfaces, lines, spacing, lattice, centre, volume);
  }
};

struct DefectSettings {
  std::optional<double> spacing;  ///< distance of nearest neighbours [length]; else of each frame
  bool bcc = false, ico = false;  ///< label these, too
  bool surface = false;           ///< of each body, and the patch where they cover each other
  bool lines = false;             ///< dislocation lines
  bool lines_everywhere = false;  ///< look for them among all atoms: the same, slower
  bool centro_symmetry = false, coordination = false;
  bool by_cgal = false;           ///< neighbours by CGAL's k-d tree: slower, same labels
  bool ids = true;                ///< the dump has the column id
  bool types = false;             ///< the types of the atoms go into the product
  bool labels = false;            ///< margins and clusters, too: for a product with the atoms
  /// Called for each frame in order, one late.
  std::function<void(const FrameHeader&, const FrameDefects&)> product = {};
};

/// Structure of all atoms, planar faults and lattice of the bodies; analyses/defects/defects.md.
/// Columns: spacing [length]; atoms of fcc, hcp, bcc, ico, other, surface, contact, bulk_defect
/// and repaired; fault_area, twin_area [length^2] of all and of body 1, 2; defect_x, defect_y,
/// defect_z, the mean place of bulk defects and hcp atoms [length]; lattice_w1 ... the turn of the
/// lattice of body 1, 2 against the cube axes, a quaternion, and lattice_share1, 2 of the sampled
/// atoms that have it (zeros without a lattice). With a surface: surface_area1 [length^2],
/// surface_volume1 [length^3], surface_radius1 [length], an ..._error of each (surface_area_error1), voids1, void_volume1, radius_atoms1 and
/// radius_gyration1 [length] ..., zeros without one, and patch_area with patch_area_error [length^2].
/// With lines: the columns of analyses/defects/lines/columns.hpp.
std::unique_ptr<Analysis> make_defects(DefectSettings settings = {});

/// Turn of the lattice of a body (1, 2) in a row; nothing without one.
std::optional<Eigen::Quaterniond> lattice_turn(const Table& table, std::size_t row, int body);

/// The turn among those of the same lattice that is nearest to another, with its sign.
Eigen::Quaterniond nearest_turn(const Eigen::Quaterniond& turn, const Eigen::Quaterniond& to);

/// Least angle [rad] by which one lattice is turned against another: turns of the cube into itself
/// do not count.
double misorientation(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

}  // namespace mdana
