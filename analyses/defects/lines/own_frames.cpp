// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/own_frames.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "analyses/defects/planes.hpp"

namespace mdana::defects {
namespace {

constexpr double farthest = 0.45;  ///< [spacings] of a neighbour from its ideal place, as in repair

// Until a frame is finished its neighbours are places.

/// Fills the places of a template; false if one stays empty.
bool fill(OwnFrame& frame, int kind, const Eigen::Matrix3d& map, const Neighbours& found) {
  std::uint64_t taken = 0;
  const auto& ideal = templates()[static_cast<std::size_t>(kind)].neighbours;
  for (std::size_t k = 0; k < 12; ++k) {
    const Eigen::Vector3d at = map * ideal[k];
    double least = farthest * farthest;
    std::size_t filler = 64;
    for (std::size_t n = 0; n < std::min<std::size_t>(found.size(), 64); ++n) {
      const double d2 = (found[n].offset.cast<double>() - at).squaredNorm();
      if (!(d2 < least)) continue;
      least = d2;
      filler = n;
    }
    if (filler == 64 || (taken >> filler & 1)) return false;
    taken |= std::uint64_t{1} << filler;
    frame.neighbours[k] = found[filler].place;
  }
  frame.kind = kind;
  frame.map = map;
  return true;
}

/// Map from the template's neighbours to those that fill it, by least squares, and its misfit.
void fit(OwnFrame& frame, const Neighbours& found) {
  const auto& ideal = templates()[static_cast<std::size_t>(frame.kind)].neighbours;
  Eigen::Matrix<double, 3, 12> at;
  Eigen::Matrix3d measured = Eigen::Matrix3d::Zero(), square = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 12; ++k) {
    const auto n = std::ranges::find(found, frame.neighbours[k], &Neighbour::place);
    at.col(static_cast<Eigen::Index>(k)) = n->offset.cast<double>();
    measured += n->offset.cast<double>() * ideal[k].transpose();
    square += ideal[k] * ideal[k].transpose();
  }
  frame.map = measured * square.inverse();
  double sum = 0;
  for (std::size_t k = 0; k < 12; ++k)
    sum += (at.col(static_cast<Eigen::Index>(k)) - frame.map * ideal[k]).squaredNorm();
  frame.misfit = std::sqrt(sum / 12);
}

/// The map of a hcp atom: three neighbours on one side of its layer are primitive vectors of fcc.
std::optional<Eigen::Matrix3d> hcp_map(const Neighbours& found) {
  const auto twelve = nearest_twelve(found);
  if (!twelve) return std::nullopt;
  const HcpLayer layer = hcp_layer(*twelve);
  Eigen::Matrix3d side;
  int count = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    const Eigen::Vector3d u = (*twelve)[k].offset.cast<double>();
    if (layer.in_plane[k] || u.dot(layer.normal) < 0) continue;
    if (count == 3) return std::nullopt;
    side.col(count++) = u;
  }
  if (count != 3) return std::nullopt;
  if (side.determinant() < 0) side.col(1).swap(side.col(2));
  Eigen::Matrix3d ideal;  // the upper neighbours of the template, whose normal is [111]
  ideal << 0, 1, 1, 1, 0, 1, 1, 1, 0;
  return Eigen::Matrix3d(side * (ideal / std::sqrt(2.0)).inverse());
}

/// From the neighbours alone.
bool find_own(OwnFrame& frame, const Neighbours& found) {
  std::optional<Eigen::Matrix3d> map;
  if (frame.structure == Structure::hcp) {
    map = hcp_map(found);
  } else {
    const auto twelve = nearest_twelve(found);
    if (twelve) map = deformation(*twelve);
  }
  return map && fill(frame, frame.structure == Structure::hcp ? 1 : 0, *map, found);
}

/// From the lattice of the first fcc neighbour that fits.
bool find_beside(OwnFrame& frame, const Sites& sites, const Neighbours& found, NeighbourSearch& search) {
  Neighbours theirs;
  for (const Neighbour& n : found) {
    if (n.d2 > touching * touching || sites.structure[n.place] != Structure::fcc) continue;
    search.about(n.place, theirs);
    const auto twelve = nearest_twelve(theirs);
    const auto map = twelve ? deformation(*twelve) : std::nullopt;
    if (!map) continue;
    if (frame.structure == Structure::fcc && fill(frame, 0, *map, found)) return true;
    for (int kind = 1; frame.structure == Structure::hcp && kind < 9; ++kind)
      if (fill(frame, kind, *map, found)) return true;
  }
  return false;
}

}  // namespace

std::vector<OwnFrame> own_frames(const Sites& sites, const std::vector<std::uint32_t>& places) {
  std::vector<OwnFrame> frames(places.size());
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& found, NeighbourSearch& search) {
    OwnFrame& frame = frames[k];
    frame.index = sites.index(places[k]);
    frame.site = sites.site[places[k]];
    frame.structure = sites.structure[places[k]];
    if (frame.structure != Structure::fcc && frame.structure != Structure::hcp) return;
    if (!find_own(frame, found) && !find_beside(frame, sites, found, search)) return;
    fit(frame, found);
    for (std::uint32_t& place : frame.neighbours) place = sites.index(place);
  });
  return frames;
}

}  // namespace mdana::defects
