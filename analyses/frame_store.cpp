// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/frame_store.hpp"

#include <algorithm>
#include <limits>

#include "analyses/sorted_runs.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::size_t most_atoms = std::size_t{1} << 31;
constexpr std::size_t atoms_at_once = 32768;

std::vector<StoredAtom> records(const FrameAtoms& atoms, std::size_t first, std::size_t end) {
  std::vector<StoredAtom> all;
  all.reserve(end - first);
  for (std::size_t i = first; i < end; ++i) all.emplace_back(atoms, i, static_cast<std::uint32_t>(i));
  return all;
}

}  // namespace

StoredAtom::StoredAtom(const FrameAtoms& atoms, std::size_t i, std::uint32_t of_frame)
    : x(atoms.x[i]),
      y(atoms.y[i]),
      z(atoms.z[i]),
      id(atoms.id.empty() ? 0 : atoms.id[i]),
      type(atoms.type.empty() ? 0 : atoms.type[i]),
      index(of_frame),
      body(atoms.body[i]) {}

void StoredAtom::append_to(FrameAtoms& atoms, bool ids, bool types) const {
  atoms.x.push_back(x);
  atoms.y.push_back(y);
  atoms.z.push_back(z);
  atoms.body.push_back(body);
  if (ids) atoms.id.push_back(id);
  if (types) atoms.type.push_back(type);
}

struct FrameStore::Spilled {
  SortedRuns<StoredAtom> runs;
};

FrameStore::FrameStore(std::size_t most, bool ids, bool types)
    : most_(std::max<std::size_t>(1, most)), ids_(ids), types_(types), atoms_(std::make_shared<FrameAtoms>()) {}

FrameStore::FrameStore(std::shared_ptr<const FrameAtoms> atoms)
    : most_(std::numeric_limits<std::size_t>::max()),
      ids_(!atoms->id.empty()),
      types_(!atoms->type.empty()),
      whole_(std::move(atoms)) {}

FrameStore::~FrameStore() = default;

void FrameStore::reserve(std::uint64_t atoms) {
  atoms_->reserve(std::min<std::uint64_t>(atoms, most_), ids_, types_);
}

void FrameStore::add(const AtomBlock& block, std::span<const BodyIndex> bodies) {
  if (size() + bodies.size() >= most_atoms)
    throw InputError("more than 2^31 atoms in a frame; choose some by --select");
  atoms_->add(block, bodies, ids_, types_);
  if (atoms_->size() > most_) spill();
}

void FrameStore::sort() {
  if (spilled_) {
    spill();
    atoms_.reset();
    return;
  }
  atoms_->sort_by_id();
  whole_ = std::move(atoms_);
}

std::size_t FrameStore::size() const {
  const std::size_t in_file = spilled_ ? static_cast<std::size_t>(spilled_->runs.size()) : 0;
  return in_file + (atoms_ ? atoms_->size() : whole_ ? whole_->size() : 0);
}

void FrameStore::spill() {
  if (!spilled_) spilled_ = std::make_unique<Spilled>();
  atoms_->sort_by_id();
  spilled_->runs.begin_run();
  for (std::size_t first = 0; first < atoms_->size(); first += atoms_at_once)
    spilled_->runs.append(records(*atoms_, first, std::min(atoms_->size(), first + atoms_at_once)));
  atoms_->clear();
}

void FrameStore::for_blocks(const std::function<void(const FrameAtoms& atoms, std::size_t first)>& use) const {
  if (!spilled_) return use(*whole_, 0);
  FrameAtoms block;
  std::size_t first = 0;
  const auto give = [&] {
    if (block.size() > 0) use(block, first);
    first += block.size();
    block.clear();
  };
  // Without ids all keys are equal: the order of the runs is that of the file.
  spilled_->runs.merge([](const StoredAtom& atom) { return atom.id; },
                       [&](const StoredAtom& atom) {
                         atom.append_to(block, ids_, types_);
                         if (block.size() == atoms_at_once) give();
                       });
  give();
}

}  // namespace mdana
