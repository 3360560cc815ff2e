// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "analyses/defects.hpp"
#include "reports/extreme/judged.hpp"

namespace mdana {
namespace {

/// Close-packed hexagonal layers, nearest neighbours 1 apart, in which one layer is left out: an intrinsic fault.
struct FaultedCrystal {
  std::string_view stacking = "ABCABCBCABCA";
  int rows = 10;                ///< atoms along half a layer
  double length = 1;            ///< all lengths times this
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  double noise = 0;             ///< of each component [spacings]
  std::size_t atoms = std::string_view::npos;  ///< the first so many of them
  std::size_t doubled = 0;      ///< atoms once more at the same place
  double spoilt = 0;            ///< added to one coordinate

  double fault_area() const { return std::sqrt(3.0) / 2 * (3 * rows * (rows + 1) + 1) * length * length; }

  std::shared_ptr<FrameAtoms> made() const {
    const auto made = std::make_shared<FrameAtoms>();
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0, 1);
    const auto add = [&](const Eigen::Vector3d& place) {
      Eigen::Vector3d shaken = place;
      if (noise > 0) shaken += noise * Eigen::Vector3d(normal(random), normal(random), normal(random));
      const Eigen::Vector3d x = origin + length * (turn * shaken);
      made->x.push_back(x[0]), made->y.push_back(x[1]), made->z.push_back(x[2]);
      made->body.push_back(1);
    };
    for (std::size_t layer = 0; layer < stacking.size(); ++layer)
      for (int i = -rows; i <= rows; ++i)
        for (int k = -rows; k <= rows; ++k)
          if (std::abs(i + k) <= rows && made->x.size() < atoms) add(place(layer, i, k));
    for (std::size_t i = 0; i < doubled; ++i) add(place(0, -rows, static_cast<int>(i)));
    made->x.back() += spoilt;
    return made;
  }

 private:
  Eigen::Vector3d place(std::size_t layer, int i, int k) const {
    const int shift = stacking[layer] - 'A';
    const double row = std::sqrt(3.0) / 2;
    return {i + 0.5 * k + 0.5 * shift, row * k + row / 3 * shift, std::sqrt(2.0 / 3) * static_cast<double>(layer)};
  }
};

/// What mdana defects finds of it.
struct Found {
  double fcc = 0, hcp = 0, spacing = 0;
  Value fault_area{0, {}, dimension::area}, surface_volume{0, {}, dimension::volume}, line_length{0, {}, dimension::length};
};

Found look_at(const FaultedCrystal& crystal) {
  DefectSettings settings;
  settings.ids = false;
  settings.surface = settings.lines = true;
  Found found;
  settings.product = [&](const FrameHeader&, const FrameDefects& defects) {
    for (const FaultPlane& plane : defects.planes) {
      if (plane.kind != PlanarFault::intrinsic) continue;
      found.fault_area.value += plane.area;
      found.fault_area.error = found.fault_area.error.value_or(0) + plane.error;
    }
    found.surface_volume.value = defects.surfaces.body[0].volume();
    found.line_length = defects.lines.length(0);
  };
  const auto analysis = make_defects(settings);
  std::vector<double> row(analysis->columns().size());
  const auto product = dynamic_cast<const FrameAnalysis&>(*analysis).look({}, FrameStore(crystal.made()), 1, row);
  if (product) product->give();
  Table table(analysis->columns());
  table.add_row(row);
  found.fcc = table.column("fcc")[0], found.hcp = table.column("hcp")[0], found.spacing = table.column("spacing")[0];
  return found;
}

constexpr double all_digits = 15;     ///< of counts
constexpr double single_digits = 6;   ///< of places within a frame, which are kept in single precision

class StructureCases {
 public:
  StructureCases() : plain_(look_at({})) {}

  /// The same crystal as seen from elsewhere: the same counts, lengths as single precision has them.
  void same(std::string what, const FaultedCrystal& c) {
    add(std::move(what), {}, [&] {
      const Found found = look_at(c);
      Judged judged;
      judged.number("fcc atoms", found.fcc, plain_.fcc, all_digits);
      judged.number("hcp atoms", found.hcp, plain_.hcp, all_digits);
      judged.number("spacing", found.spacing, c.length, single_digits);
      judged.number("fault area", found.fault_area.value, c.fault_area(), single_digits - 0.5);
      judged.number("volume", found.surface_volume.value, plain_.surface_volume.value * std::pow(c.length, 3), single_digits - 1);
      judged.number("length of lines", found.line_length.value, 0, all_digits);
      return judged;
    });
  }

  /// Atoms that shake change no number by more than its error and make no lines.
  void shaken(double noise) {
    add(fmt::format("noise of {:g} spacings", noise), {}, [&] {
      const Found found = look_at({.noise = noise});
      Judged judged;
      judged.within_error("fault area", found.fault_area, FaultedCrystal{}.fault_area());
      judged.number("length of lines", found.line_length.value, 0, all_digits);
      judged.number("spacing", found.spacing, 1, -std::log10(noise));
      return judged;
    });
  }

  /// Too few for a structure.
  void few(std::size_t atoms) {
    add(fmt::format("{} atoms", atoms), {}, [&] {
      const Found found = look_at({.atoms = atoms});
      Judged judged;
      judged.number("fcc atoms", found.fcc, 0, all_digits);
      judged.number("hcp atoms", found.hcp, 0, all_digits);
      judged.number("length of lines", found.line_length.value, 0, all_digits);
      return judged;
    });
  }

  void refused(std::string what, const FaultedCrystal& c, const std::string& words) {
    add(std::move(what), words, [&] {
      const Found found = look_at(c);
      Judged judged;
      judged.must_be_refused(words, found.fcc);
      return judged;
    });
  }

  std::vector<ExtremeCase> cases;

 private:
  template <class Work>
  void add(std::string what, const std::string& words, Work&& work) {
    cases.push_back(judge("defects", std::move(what), words, work));
  }

  Found plain_;
};

}  // namespace

std::vector<ExtremeCase> extreme_structures() {
#ifdef MDANA_WITH_DEFECTS
  StructureCases cases;
  for (const double length : {1e-60, 1e-30, 1e-10, 1e10, 1e30, 1e60}) cases.same(fmt::format("lengths times {:g}", length), {.length = length});
  for (const double far : {1e3, 1e7}) cases.same(fmt::format("{:g} from the origin", far), {.origin = {far, -far, far}});
  cases.same("turned", {.turn = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix()});
  for (const double noise : {1e-6, 0.01, 0.03, 0.05}) cases.shaken(noise);
  for (const std::size_t atoms : {2, 4, 13}) cases.few(atoms);
  cases.refused("one atom", {.atoms = 1}, "fewer than two atoms");
  cases.refused("two atoms at one place", {.doubled = 1}, "at the same place");
  cases.refused("a coordinate nan", {.spoilt = std::nan("")}, "finite");
  cases.refused("a coordinate inf", {.spoilt = std::numeric_limits<double>::infinity()}, "finite");
  return std::move(cases.cases);
#else
  return {};
#endif
}

}  // namespace mdana
