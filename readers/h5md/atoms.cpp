// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/atoms.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::h5md {
namespace {

void check_kind(const Element& element, ColumnKind kind) {
  const hdf5::Kind found = element.value().kind();
  const bool fits = kind == ColumnKind::text      ? found == hdf5::Kind::text
                    : kind == ColumnKind::integer ? found == hdf5::Kind::integer
                                                  : found != hdf5::Kind::text;
  if (!fits)
    throw InputError(fmt::format("{}: {} expected", element.place(),
                                 kind == ColumnKind::text      ? "texts"
                                 : kind == ColumnKind::integer ? "whole numbers"
                                                               : "numbers"));
}

template <class T>
void spread(const char* from, std::size_t stride, std::span<T> to) {
  for (std::size_t i = 0; i < to.size(); ++i) std::memcpy(&to[i], from + i * stride, sizeof(T));
}

void spread(const char* from, std::size_t stride, std::span<std::string> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    const std::string_view room(from + i * stride, AtomLayout::text_bytes);
    to[i] = room.substr(0, room.find('\0'));
  }
}

}  // namespace

AtomLayout::AtomLayout(const FrameHeader& header, const Particles& particles,
                       const ColumnSet& wanted)
    : choice_(header, wanted) {
  for (const auto& column : choice_.columns())
    for (const AtomElement& element : particles.elements()) {
      const auto it = std::ranges::find(element.columns, column.name);
      if (it == element.columns.end()) continue;
      targets_.push_back({part_of(element, column.kind),
                          static_cast<std::size_t>(it - element.columns.begin()), column.name});
    }
}

/// The part that holds the element; the columns of one element are all of one kind.
std::size_t AtomLayout::part_of(const AtomElement& element, ColumnKind kind) {
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].element == &element.element && parts_[k].kind == kind) return k;
  check_kind(element.element, kind);
  parts_.push_back({&element.element, element.element.place(), kind, element.columns.size()});
  return parts_.size() - 1;
}

std::size_t AtomLayout::bytes_of_atom() const {
  std::size_t bytes = 0;
  for (const Part& part : parts_) bytes += part.bytes_of_atom();
  return bytes;
}

void AtomLayout::convert(const Chunk& chunk, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  std::vector<const char*> starts;
  const char* at = chunk.bytes.data();
  for (const Part& part : parts_) {
    starts.push_back(at);
    at += part.bytes_of_atom() * chunk.atoms;
  }
  for (const Target& target : targets_) {
    const Part& part = parts_[target.part];
    const std::size_t stride = part.bytes_of_atom();
    const char* from = starts[target.part] + target.component * (stride / part.components);
    switch (part.kind) {
      case ColumnKind::real: spread(from, stride, block.make_real(target.name)); break;
      case ColumnKind::integer: spread(from, stride, block.make_integer(target.name)); break;
      case ColumnKind::text: spread(from, stride, block.make_text(target.name)); break;
    }
  }
  choice_.finish(block);
}

}  // namespace mdana::h5md
