// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/check_ids.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyses/check_values.hpp"

namespace mdana {
namespace {

constexpr std::size_t named = 5;  ///< ids told of a frame that lost or gained more

std::string list(const std::vector<std::int64_t>& first, std::uint64_t count) {
  return fmt::format("{} ids: {}{}", count, fmt::join(first, " "),
                     count > first.size() ? " ..." : "");
}

std::string twice(std::int64_t id) { return fmt::format("id {} stands twice in the frame", id); }

}  // namespace

void IdCheck::begin() {
  seen_.assign(reference_.size(), false);
  others_.clear();
  places_.clear();
  atoms_ = 0;
  too_many_ = any_unusable_ = false;
}

/// Those of the reference and of its marks, and what growing of the others may hold.
std::size_t IdCheck::bytes() const {
  return reference_.size() * sizeof(std::int64_t) + reference_.size() / 8 +
         others_.size() * (sizeof(Met) + (has_reference_ ? 0 : sizeof(std::int64_t)));
}

void IdCheck::remember_places(const Chunk& chunk) {
  if (chunk.parts.empty()) places_.push_back({atoms_, place_of(chunk, 0)});
  std::uint64_t first = atoms_;
  for (const Chunk& part : chunk.parts) {
    places_.push_back({first, place_of(part, 0)});
    first += part.atoms;
  }
}

void IdCheck::add(const Chunk& chunk, const AtomBlock& block, BlockFaults& faults) {
  remember_places(chunk);
  any_unusable_ = any_unusable_ || !faults.whole();
  const auto ids = faults.all_unusable ? std::span<const std::int64_t>() : block.integer("id");
  for (std::size_t i = 0; i < ids.size() && !too_many_; ++i)
    if (faults.usable(i)) add_id(ids[i], chunk, i, faults);
  atoms_ += chunk.atoms;
  if (bytes() <= memory_) return;
  too_many_ = true;
  others_ = {};
}

bool IdCheck::in_reference(std::int64_t id, std::size_t& at) const {
  if (reference_.empty() || id < reference_.front() || id > reference_.back()) return false;
  const auto offset = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(reference_.front());
  if (offset < reference_.size() && reference_[offset] == id) {  // ids without gaps
    at = offset;
    return true;
  }
  const auto it = std::ranges::lower_bound(reference_, id);
  at = static_cast<std::size_t>(it - reference_.begin());
  return *it == id;
}

void IdCheck::add_id(std::int64_t id, const Chunk& chunk, std::size_t atom, BlockFaults& faults) {
  std::size_t at = 0;
  if (!in_reference(id, at)) return others_.push_back({id, atoms_ + atom});
  if (seen_[at])
    faults.faults.add(fault_at(FaultKind::duplicate_id, chunk, atom, twice(id), "id"));
  seen_[at] = true;
}

Fault IdCheck::at_frame(FaultKind kind, const FrameHeader& header, std::string what) const {
  Fault fault = located(kind, header.place, dump_);
  fault.what = std::move(what);
  fault.frame = header.index;
  fault.step = header.step;
  fault.column = "id";
  return fault;
}

/// Of ids that are not in the reference, in their order; leaves each once.
void IdCheck::tell_duplicates(const FrameHeader& header, Faults& faults) {
  const auto before = [](const Met& a, const Met& b) {
    return a.id != b.id ? a.id < b.id : a.atom < b.atom;
  };
  std::ranges::sort(others_, before);
  for (std::size_t i = 1; i < others_.size(); ++i) {
    if (others_[i].id != others_[i - 1].id) continue;
    Fault fault = at_frame(FaultKind::duplicate_id, header, twice(others_[i].id));
    settle_place(others_[i].atom, fault);
    faults.add(std::move(fault));
  }
  const auto same = [](const Met& a, const Met& b) { return a.id == b.id; };
  others_.erase(std::unique(others_.begin(), others_.end(), same), others_.end());
}

void IdCheck::settle_place(std::uint64_t atom, Fault& fault) const {
  const auto after = std::ranges::upper_bound(places_, atom, {}, &Stretch::first);
  const Stretch& stretch = *std::prev(after);
  if (!stretch.place.file.empty()) fault.file = stretch.place.file;
  fault.line.reset();
  if (stretch.place.line) fault.line = stretch.place.line + (atom - stretch.first);
  if (stretch.place.atom) fault.atom = stretch.place.atom + (atom - stretch.first);
}

void IdCheck::compare(const FrameHeader& header, Faults& faults) {
  std::vector<std::int64_t> lost, gained;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (!seen_[i] && ++count <= named) lost.push_back(reference_[i]);
  for (std::size_t i = 0; i < std::min(named, others_.size()); ++i)
    gained.push_back(others_[i].id);
  if (count > 0) faults.add(at_frame(FaultKind::ids_lost, header, "lost " + list(lost, count)));
  if (!gained.empty())
    faults.add(at_frame(FaultKind::ids_gained, header, "gained " + list(gained, others_.size())));
  compared_ = true;
}

void IdCheck::adopt() {
  reference_.reserve(others_.size());
  for (const Met& met : others_) reference_.push_back(met.id);
  has_reference_ = true;
}

void IdCheck::end(const FrameHeader& header, bool whole, Faults& faults) {
  if (too_many_) {
    if (!told_too_many_)
      faults.add(at_frame(FaultKind::ids_unchecked, header,
                          fmt::format("more ids than {} MB hold: from this frame on some are not "
                                      "compared; raise --memory", memory_ >> 20)));
    told_too_many_ = true;
    return;
  }
  tell_duplicates(header, faults);
  if (!whole || any_unusable_) return;
  if (has_reference_)
    compare(header, faults);
  else
    adopt();
}

}  // namespace mdana
