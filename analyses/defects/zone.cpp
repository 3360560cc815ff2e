// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/zone.hpp"

#include <algorithm>
#include <functional>

namespace mdana::defects {
namespace {

constexpr double halo = 2 * widest_limit;  ///< [spacings]
constexpr int cells_away = 2;              ///< of the grid
static_assert(halo < cells_away * reach);

/// Marks all places within the halo of a seed.
class Halo {
 public:
  Halo(const Sites& sites, BodyIndex body) : sites_(sites), body_(body), marked_(sites.body.size()) {}

  void mark_about(std::size_t cell, const std::vector<std::uint32_t>& seeds) {
    for (int dz = -cells_away; dz <= cells_away; ++dz)
      for (int dy = -cells_away; dy <= cells_away; ++dy) {
        const std::uint64_t key = sites_.grid.key[cell];
        const std::size_t first = sites_.grid.at_or_after(key_beside(key, -cells_away, dy, dz));
        const std::size_t end = sites_.grid.at_or_after(key_beside(key, cells_away + 1, dy, dz));
        mark_row(sites_.grid.start[first], sites_.grid.start[end], seeds);
      }
  }

  const std::vector<char>& marked() const { return marked_; }

 private:
  void mark_row(std::uint32_t first, std::uint32_t end, const std::vector<std::uint32_t>& seeds) {
    for (std::uint32_t p = first; p < end; ++p) {
      if (marked_[p] || (body_ != 0 && sites_.body[p] != body_)) continue;
      marked_[p] = std::ranges::any_of(seeds, [&](std::uint32_t s) { return near(p, s); });
    }
  }

  /// Coordinates are whole numbers modulo 2^32; their differences are right for neighbours.
  bool near(std::uint32_t a, std::uint32_t b) const {
    const auto part = [&](const std::vector<std::int32_t>& axis) {
      const auto whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(axis[a]) -
                                                   static_cast<std::uint32_t>(axis[b]));
      return whole / units_a_spacing;
    };
    const double x = part(sites_.grid.x), y = part(sites_.grid.y), z = part(sites_.grid.z);
    return x * x + y * y + z * z <= halo * halo;
  }

  const Sites& sites_;
  BodyIndex body_;
  std::vector<char> marked_;
};

}  // namespace

std::vector<std::uint32_t> ZoneParts::add(const Sites& sites, const std::vector<char>& seeds, BodyIndex body) {
  Halo halo_of(sites, body);
  std::vector<std::uint32_t> here;
  for (std::size_t cell = 0; cell < sites.grid.cells(); ++cell) {
    here.clear();
    for (std::uint32_t p = sites.grid.start[cell]; p < sites.grid.start[cell + 1]; ++p)
      if (seeds[p] && (body == 0 || sites.body[p] == body)) here.push_back(p);
    if (!here.empty()) halo_of.mark_about(cell, here);
  }
  std::vector<std::uint32_t> places;
  const auto count = static_cast<std::size_t>(std::ranges::count_if(halo_of.marked(), std::identity()));
  places.reserve(count);
  atoms_.reserve(atoms_.size() + count);
  for (std::uint32_t p = 0; p < seeds.size(); ++p) {
    if (!halo_of.marked()[p] || !sites.is_own(p)) continue;
    atoms_.push_back({sites.position(p), sites.number(p), sites.index(p), sites.body[p], seeds[p]});
    places.push_back(p);
  }
  return places;
}

Zone ZoneParts::zone(const Eigen::Vector3d& origin, double spacing) && {
  std::ranges::sort(atoms_, {}, &Atom::index);
  Zone zone;
  zone.spacing = spacing;
  zone.origin = origin;
  for (const Atom& atom : atoms_) {
    zone.atom.push_back(atom.index);
    zone.at.push_back((atom.at - origin) / spacing);
    zone.number.push_back(atom.number);
    zone.body.push_back(atom.body);
    zone.seed.push_back(atom.seed);
  }
  atoms_ = {};
  return zone;
}

}  // namespace mdana::defects
