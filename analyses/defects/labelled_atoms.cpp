// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/labelled_atoms.hpp"

#include <algorithm>

#include "analyses/sorted_runs.hpp"

namespace mdana::defects {
namespace {

using Use = std::function<void(const FrameAtoms&, const AtomLabels&)>;

constexpr std::size_t atoms_at_once = 32768;

/// Values by place, in the order of the slab's atoms.
template <class T>
void by_atom(const CellGrid& grid, std::vector<T>& values) {
  std::vector<T> sorted(values.size());
  for (std::size_t p = 0; p < values.size(); ++p) sorted[grid.atom[p]] = values[p];
  values = std::move(sorted);
}

template <class T>
std::vector<T> part(const std::vector<T>& values, std::size_t first, std::size_t end) {
  if (values.empty()) return {};
  return {values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// Of a frame in memory.
class WholeFrame final : public LabelledAtoms, public LabelCollector, public std::enable_shared_from_this<WholeFrame> {
 public:
  explicit WholeFrame(std::shared_ptr<const FrameAtoms> atoms) : atoms_(std::move(atoms)) {}

  void add(const Sites& sites, AtomLabels labels) override {
    labels_ = std::move(labels);
    by_atom(sites.grid, labels_.structure);
    by_atom(sites.grid, labels_.site);
    by_atom(sites.grid, labels_.margin);
    by_atom(sites.grid, labels_.cluster);
    by_atom(sites.grid, labels_.centro_symmetry);
    by_atom(sites.grid, labels_.coordination);
  }

  std::shared_ptr<const LabelledAtoms> finish(std::vector<std::uint32_t> numbers) override {
    for (std::uint32_t& cluster : labels_.cluster) cluster = numbers[cluster];
    return shared_from_this();
  }

  std::size_t size() const override { return atoms_->size(); }

  void for_blocks(const Use& use) const override {
    for (std::size_t first = 0; first < size(); first += AtomBlock::capacity) {
      const std::size_t end = std::min(size(), first + AtomBlock::capacity);
      const FrameAtoms& a = *atoms_;
      const AtomLabels& l = labels_;
      use({part(a.x, first, end), part(a.y, first, end), part(a.z, first, end), part(a.body, first, end),
           part(a.id, first, end), part(a.type, first, end)},
          {part(l.structure, first, end), part(l.site, first, end), part(l.margin, first, end),
           part(l.cluster, first, end), part(l.centro_symmetry, first, end), part(l.coordination, first, end)});
    }
  }

 private:
  std::shared_ptr<const FrameAtoms> atoms_;
  AtomLabels labels_;
};

/// An atom with its labels; those that were not asked for mean nothing.
struct LabelledAtom {
  StoredAtom atom;
  float margin, centro_symmetry;
  std::uint32_t piece;
  Structure structure;
  Site site;
  std::uint8_t coordination;
};

/// Of a frame in slabs, each of which is a run of the file.
class FrameOfSlabs final : public LabelledAtoms, public LabelCollector, public std::enable_shared_from_this<FrameOfSlabs> {
 public:
  explicit FrameOfSlabs(const FrameStore& frame) : ids_(frame.has_ids()), types_(frame.has_types()) {}

  void add(const Sites& sites, AtomLabels labels) override {
    centro_symmetry_ = !labels.centro_symmetry.empty();
    coordination_ = !labels.coordination.empty();
    std::vector<std::uint32_t> place(sites.grid.atom.size());  // of the atoms in their order
    for (std::uint32_t p = 0; p < place.size(); ++p) place[sites.grid.atom[p]] = p;
    std::erase_if(place, [&](std::uint32_t p) { return !sites.is_own(p); });
    runs_.begin_run();
    std::vector<LabelledAtom> records;
    for (std::size_t first = 0; first < place.size(); first += atoms_at_once) {
      records.clear();
      for (std::size_t k = first; k < std::min(place.size(), first + atoms_at_once); ++k)
        records.push_back(record(sites, labels, place[k]));
      runs_.append(records);
    }
  }

  std::shared_ptr<const LabelledAtoms> finish(std::vector<std::uint32_t> numbers) override {
    numbers_ = std::move(numbers);
    return shared_from_this();
  }

  std::size_t size() const override { return static_cast<std::size_t>(runs_.size()); }

  void for_blocks(const Use& use) const override {
    FrameAtoms atoms;
    AtomLabels labels;
    const auto give = [&] {
      if (atoms.size() > 0) use(atoms, labels);
      atoms.clear();
      labels = {};
    };
    runs_.merge([](const LabelledAtom& record) { return record.atom.index; },
                [&](const LabelledAtom& record) {
                  record.atom.append_to(atoms, ids_, types_);
                  append(record, labels);
                  if (atoms.size() == AtomBlock::capacity) give();
                });
    give();
  }

 private:
  LabelledAtom record(const Sites& sites, const AtomLabels& labels, std::uint32_t p) const {
    return {{*sites.slab.atoms, sites.grid.atom[p], sites.index(p)},
            labels.margin[p],
            centro_symmetry_ ? labels.centro_symmetry[p] : 0,
            labels.cluster[p],
            labels.structure[p],
            labels.site[p],
            coordination_ ? labels.coordination[p] : std::uint8_t{0}};
  }

  void append(const LabelledAtom& record, AtomLabels& labels) const {
    labels.structure.push_back(record.structure);
    labels.site.push_back(record.site);
    labels.margin.push_back(record.margin);
    labels.cluster.push_back(numbers_[record.piece]);
    if (centro_symmetry_) labels.centro_symmetry.push_back(record.centro_symmetry);
    if (coordination_) labels.coordination.push_back(record.coordination);
  }

  bool ids_, types_, centro_symmetry_ = false, coordination_ = false;
  SortedRuns<LabelledAtom> runs_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace

std::shared_ptr<LabelCollector> collect_labels(const FrameStore& frame) {
  if (frame.whole()) return std::make_shared<WholeFrame>(frame.whole());
  return std::make_shared<FrameOfSlabs>(frame);
}

}  // namespace mdana::defects
