// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "analyses/frame_atoms.hpp"

namespace mdana {

/// All atoms of bodies 1 and 2 in one frame, sorted by id (in the order of the file if ids were not
/// asked for); the index of an atom is its place in this order. In memory, or, if they are more than
/// are allowed there, in a temporary file of 48 bytes an atom.
class FrameStore {
 public:
  /// `most`: atoms in memory.
  FrameStore(std::size_t most, bool ids, bool types);
  /// Atoms that are in order.
  explicit FrameStore(std::shared_ptr<const FrameAtoms> atoms);
  ~FrameStore();

  void reserve(std::uint64_t atoms);  ///< a hint, as a header says it
  /// Atoms of no or another body are left out. Throws InputError beyond 2^31 atoms.
  void add(const AtomBlock& block, std::span<const BodyIndex> bodies);
  void sort();  ///< once, after the last atom

  std::size_t size() const;
  bool has_ids() const { return ids_; }
  bool has_types() const { return types_; }
  std::size_t most() const { return most_; }  ///< atoms allowed in memory
  /// All atoms; null if they are in a file.
  std::shared_ptr<const FrameAtoms> whole() const { return spilled_ ? nullptr : whole_; }
  /// Calls use(atoms, index of the first of them) for all atoms in order: once if they are in memory.
  void for_blocks(const std::function<void(const FrameAtoms& atoms, std::size_t first)>& use) const;

 private:
  void spill();

  std::size_t most_;
  bool ids_, types_;
  std::shared_ptr<FrameAtoms> atoms_;        ///< while they are added
  std::shared_ptr<const FrameAtoms> whole_;  ///< sorted
  struct Spilled;
  std::unique_ptr<Spilled> spilled_;
};

/// An atom in a temporary file.
struct StoredAtom {
  StoredAtom() = default;
  StoredAtom(const FrameAtoms& atoms, std::size_t i, std::uint32_t index);
  void append_to(FrameAtoms& atoms, bool ids, bool types) const;

  double x, y, z;
  std::int64_t id;      ///< 0 if it is not known
  std::int32_t type;    ///< likewise
  std::uint32_t index;  ///< in the frame
  BodyIndex body;
};

}  // namespace mdana
