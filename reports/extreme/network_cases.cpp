// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "analyses/grain_contacts.hpp"
#include "reports/extreme/judged.hpp"

namespace mdana {
namespace {

/// Equal spheres of radius 1 on a cubic lattice, each overlapping its six neighbours.
struct CubicGrains {
  int rows = 6;
  double overlap = 0.1;   ///< of two neighbours [radii]
  double length = 1;      ///< all lengths times this
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::size_t doubled = 0;  ///< grains once more at the same place
  double spoilt = 0;      ///< added to a coordinate of the last grain
  double last_radius = 1;

  double contacts() const { return 3.0 * rows * rows * (rows - 1); }

  std::vector<Grain> made() const {
    std::vector<Grain> grains;
    const auto add = [&](int i, int j, int k) {
      const Eigen::Vector3d place = origin + (2 - overlap) * Eigen::Vector3d(i, j, k);
      grains.push_back({length * place, length, 1});
    };
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < rows; ++j)
        for (int k = 0; k < rows; ++k) add(i, j, k);
    for (std::size_t i = 0; i < doubled; ++i) add(0, 0, static_cast<int>(i));
    if (!grains.empty()) grains.back().position.x() += spoilt, grains.back().radius *= last_radius;
    return grains;
  }
};

class NetworkCases {
 public:
  /// All contacts that there are, and their overlaps to what the rounding of places leaves of them.
  void whole(std::string what, const CubicGrains& c) {
    add(std::move(what), {}, [&] {
      const std::vector<GrainContact> found = find_contacts(c.made());
      double sum = 0;
      for (const GrainContact& contact : found) sum += contact.overlap / c.length;
      const double far = 2 * c.rows + c.origin.cwiseAbs().maxCoeff();
      Judged judged;
      judged.number("contacts", static_cast<double>(found.size()), c.contacts(), 15);
      if (c.contacts() > 0) judged.number("overlaps", sum, c.contacts() * c.overlap, 15 - std::log10(far / c.overlap));
      return judged;
    });
  }

  /// A grain that lies on one that is so many times larger.
  void unequal(double ratio) {
    add(fmt::format("radii of 1 and {:g}", ratio), {}, [&] {
      const std::vector<GrainContact> found = find_contacts(std::vector<Grain>{{{0, 0, 0}, ratio, 1}, {{0, 0, ratio + 0.5}, 1, 2}});
      Judged judged;
      judged.number("contacts", static_cast<double>(found.size()), 1, 15);
      judged.number("overlap", found.empty() ? 0 : found[0].overlap, 0.5, 15 - std::log10(ratio));
      return judged;
    });
  }

  void refused(std::string what, const CubicGrains& c, const std::string& words) {
    add(std::move(what), words, [&] {
      const std::vector<GrainContact> found = find_contacts(c.made());
      Judged judged;
      judged.must_be_refused(words, static_cast<double>(found.size()));
      return judged;
    });
  }

  std::vector<ExtremeCase> cases;

 private:
  template <class Work>
  void add(std::string what, const std::string& words, Work&& work) {
    cases.push_back(judge("network", std::move(what), words, work));
  }
};

}  // namespace

std::vector<ExtremeCase> extreme_networks() {
  NetworkCases cases;
  for (const int rows : {0, 1, 2}) cases.whole(fmt::format("{} grains", rows * rows * rows), {.rows = rows});
  for (const double length : {1e-100, 1e-30, 1e-9, 1e9, 1e30, 1e100})
    cases.whole(fmt::format("lengths times {:g}", length), {.length = length});
  for (const double overlap : {1e-3, 1e-6, 1e-9}) cases.whole(fmt::format("overlaps of {:g} radii", overlap), {.overlap = overlap});
  for (const double far : {1e3, 1e7}) cases.whole(fmt::format("{:g} radii from the origin", far), {.origin = {far, -far, far}});
  for (const double ratio : {10.0, 100.0}) cases.unequal(ratio);
  cases.refused("two grains at one place", {.doubled = 1}, "coincide");
  cases.refused("a coordinate nan", {.spoilt = std::nan("")}, "not a place");
  cases.refused("a coordinate inf", {.spoilt = std::numeric_limits<double>::infinity()}, "not a place");
  for (const double radius : {0.0, -1.0, std::nan("")}) cases.refused(fmt::format("a radius of {:g}", radius), {.last_radius = radius}, "radius");
  return std::move(cases.cases);
}

}  // namespace mdana
