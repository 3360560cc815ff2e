// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/slabs.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "analyses/temporary_file.hpp"

namespace mdana::defects {
namespace {

/// What is found of an atom depends on atoms up to so many cells away: its structure on 1, repaired on 2;
/// its site on 3 (whether a neighbour is at the surface); the kind of its fault on 5 (structures of atoms
/// two neighbours from one in its layer), and as many whether it is in the zone of a seed of the surface; on 6 whether
/// it is in the zone of an atom beside one at the rim of its hcp layer.
constexpr std::uint64_t halo_cells = 6;
constexpr std::size_t buffered = 65536;  ///< atoms on their way to the file
constexpr std::size_t atoms_at_once = 32768;

const std::vector<double>& along(const FrameAtoms& atoms, std::size_t axis) {
  return axis == 0 ? atoms.x : axis == 1 ? atoms.y : atoms.z;
}

}  // namespace

/// Atoms by layer, those of a layer in their order in the frame.
struct Slabs::Layers {
  struct Layer {
    std::uint64_t cell, atoms, first;  ///< first atom in the file
  };

  Layers(const FrameStore& frame, const CellSpace& space)
      : axis(static_cast<std::size_t>(std::max_element(space.count.begin(), space.count.end()) -
                                      space.count.begin())) {
    count(frame, space);
    write(frame, space);
    cut(frame.most());
  }

  void count(const FrameStore& frame, const CellSpace& space) {
    std::map<std::uint64_t, std::uint64_t> counts;
    frame.for_blocks([&](const FrameAtoms& atoms, std::size_t) {
      for (const double at : along(atoms, axis)) ++counts[space.cell(at, axis)];
    });
    for (const auto& [cell, atoms] : counts)
      all.push_back({cell, atoms, all.empty() ? 0 : all.back().first + all.back().atoms});
  }

  /// The layer of that cell, or the first one behind it.
  std::size_t layer_at(std::uint64_t cell) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(all, cell, {}, &Layer::cell) - all.begin());
  }

  void write(const FrameStore& frame, const CellSpace& space) {
    std::vector<std::uint64_t> next;  // place in the file, of each layer
    for (const Layer& layer : all) next.push_back(layer.first);
    std::vector<Waiting> waiting;
    frame.for_blocks([&](const FrameAtoms& atoms, std::size_t first) {
      for (std::size_t i = 0; i < atoms.size(); ++i) {
        const std::size_t layer = layer_at(space.cell(along(atoms, axis)[i], axis));
        waiting.push_back({layer, {atoms, i, static_cast<std::uint32_t>(first + i)}});
        if (waiting.size() == buffered) flush(waiting, next);
      }
    });
    flush(waiting, next);
  }

  /// An atom on its way to the file.
  struct Waiting {
    std::size_t layer;
    StoredAtom atom;
  };

  void flush(std::vector<Waiting>& waiting, std::vector<std::uint64_t>& next) {
    std::ranges::stable_sort(waiting, {}, &Waiting::layer);
    std::vector<StoredAtom> some;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      some.push_back(waiting[i].atom);
      const std::size_t layer = waiting[i].layer;
      if (i + 1 < waiting.size() && waiting[i + 1].layer == layer) continue;
      file.write(next[layer], some);
      next[layer] += some.size();
      some.clear();
    }
    waiting.clear();
  }

  /// First atom in the file, and the end, of the layers from one to before another with their halo.
  std::pair<std::uint64_t, std::uint64_t> atoms_of(std::size_t from, std::size_t to) const {
    const std::uint64_t low = all[from].cell, high = all[to - 1].cell;
    const std::size_t first = layer_at(low < halo_cells ? 0 : low - halo_cells);
    const std::size_t last = layer_at(high + halo_cells + 1) - 1;
    return {all[first].first, all[last].first + all[last].atoms};
  }

  void cut(std::size_t most) {
    for (std::size_t from = 0; from < all.size();) {
      std::size_t to = from + 1;
      const auto fits = [&](std::size_t end) {
        const auto [first, behind] = atoms_of(from, end);
        return behind - first <= most;
      };
      while (to < all.size() && fits(to + 1)) ++to;
      starts.push_back(from);
      from = to;
    }
    starts.push_back(all.size());
  }

  std::size_t axis;
  std::vector<Layer> all;           ///< those with atoms, ascending
  std::vector<std::size_t> starts;  ///< first layer of each slab, and the end
  RecordFile<StoredAtom> file;
};

Slabs::Slabs(const FrameStore& frame, const CellSpace& space) : frame_(frame) {
  if (!frame.whole()) layers_ = std::make_unique<Layers>(frame, space);
}

Slabs::~Slabs() = default;

std::size_t Slabs::count() const { return layers_ ? layers_->starts.size() - 1 : 1; }

Slab Slabs::slab(std::size_t k) const {
  Slab slab;
  slab.atoms = frame_.whole();
  if (!layers_) return slab;
  const std::size_t from = layers_->starts[k], to = layers_->starts[k + 1];
  const auto [first, end] = layers_->atoms_of(from, to);
  const auto atoms = std::make_shared<FrameAtoms>();
  atoms->reserve(end - first, frame_.has_ids(), frame_.has_types());
  slab.index.reserve(static_cast<std::size_t>(end - first));
  std::vector<StoredAtom> some;
  for (std::uint64_t at = first; at < end; at += some.size()) {
    some.resize(static_cast<std::size_t>(std::min<std::uint64_t>(atoms_at_once, end - at)));
    layers_->file.read(at, some);
    for (const StoredAtom& atom : some) {
      atom.append_to(*atoms, frame_.has_ids(), frame_.has_types());
      slab.index.push_back(atom.index);
    }
  }
  std::vector<std::uint32_t> order(slab.index.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return slab.index[i]; });
  atoms->reorder(order);
  std::ranges::sort(slab.index);
  slab.atoms = atoms;
  slab.axis = layers_->axis;
  slab.first = layers_->all[from].cell;
  slab.end = layers_->all[to - 1].cell + 1;
  return slab;
}

}  // namespace mdana::defects
