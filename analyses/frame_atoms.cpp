// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/frame_atoms.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "analyses/analysis.hpp"

namespace mdana {
namespace {

constexpr bool counts(BodyIndex body) { return body == 1 || body == 2; }

/// Appends the values of atoms of the two bodies.
template <class From, class To>
void append(const From& values, std::span<const BodyIndex> bodies, To& to) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (counts(bodies[i])) to.push_back(static_cast<typename To::value_type>(values[i]));
}

template <class T>
void reordered(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  if (values.empty()) return;
  std::vector<T> sorted(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = values[order[i]];
  values = std::move(sorted);
}

}  // namespace

std::unique_ptr<Partial> FrameAnalysis::begin(const FrameContext&) const {
  throw std::logic_error("an analysis of whole frames has no partials");
}

void FrameAtoms::reserve(std::uint64_t atoms, bool ids, bool types) {
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(atoms, 1u << 24));
  for (auto* axis : {&x, &y, &z}) axis->reserve(count);
  body.reserve(count);
  if (ids) id.reserve(count);
  if (types) type.reserve(count);
}

void FrameAtoms::clear() {
  for (auto* axis : {&x, &y, &z}) axis->clear();
  body.clear();
  id.clear();
  type.clear();
}

void FrameAtoms::add(const AtomBlock& block, std::span<const BodyIndex> bodies, bool ids,
                     bool types) {
  append(block.real("x"), bodies, x);
  append(block.real("y"), bodies, y);
  append(block.real("z"), bodies, z);
  if (ids) append(block.integer("id"), bodies, id);
  if (types) append(block.integer("type"), bodies, type);
  append(bodies, bodies, body);
}

void FrameAtoms::sort_by_id() {
  if (std::is_sorted(id.begin(), id.end())) return;
  std::vector<std::uint32_t> order(id.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return id[a] < id[b]; });
  reorder(order);
}

void FrameAtoms::reorder(const std::vector<std::uint32_t>& order) {
  for (auto* axis : {&x, &y, &z}) reordered(*axis, order);
  reordered(body, order);
  reordered(type, order);
  reordered(id, order);
}

}  // namespace mdana
