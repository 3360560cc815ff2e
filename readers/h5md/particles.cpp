// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/particles.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/column_names.hpp"
#include "readers/input_error.hpp"

namespace mdana::h5md {
namespace {

constexpr std::uint64_t most_components = 64;  ///< of an element's value of one atom

struct KnownElement {
  std::string_view name;
  std::vector<std::string> columns;
};

/// Elements of H5MD 1.1 in the order of columns; all others follow under their own names.
const std::array<KnownElement, 8>& known_elements() {
  static const std::array<KnownElement, 8> known{{{"id", {"id"}},
                                                  {"species", {"type"}},
                                                  {"mass", {"mass"}},
                                                  {"charge", {"q"}},
                                                  {"position", {"x", "y", "z"}},
                                                  {"image", {"ix", "iy", "iz"}},
                                                  {"velocity", {"vx", "vy", "vz"}},
                                                  {"force", {"fx", "fy", "fz"}}}};
  return known;
}

const KnownElement* known(std::string_view name) {
  const auto it = std::ranges::find(known_elements(), name, &KnownElement::name);
  return it == known_elements().end() ? nullptr : &*it;
}

hdf5::Group choose(const hdf5::Group& file) {
  const hdf5::Group particles = file.group("particles");
  std::vector<std::string> groups;
  for (const std::string& name : particles.names())
    if (particles.has_group(name)) groups.push_back(name);
  if (groups.empty()) throw InputError(fmt::format("{}: no group in it", particles.place()));
  if (groups.size() == 1) return particles.group(groups.front());
  if (std::ranges::find(groups, "all") != groups.end()) return particles.group("all");
  throw InputError(fmt::format("{}: several groups of particles ({}); one of them alone or called "
                               "'all' is read",
                               particles.place(), fmt::join(groups, ", ")));
}

std::optional<Units> units_of(const hdf5::Group& particles) {
  const auto names = particles.texts("mdana_units");
  if (names.empty()) return std::nullopt;
  const auto units = parse_units(names.front());
  if (!units)
    throw InputError(fmt::format("{}: unknown mdana_units '{}' (known: {})", particles.place(),
                                 names.front(), units_names()));
  return units;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::vector<std::string> numbered(const std::string& name, std::uint64_t components) {
  if (components == 3) return {name + "_x", name + "_y", name + "_z"};
  std::vector<std::string> names;
  for (std::uint64_t k = 1; k <= components; ++k) names.push_back(fmt::format("{}_{}", name, k));
  return names;
}

/// Columns of an element of that many atoms; none if it does not belong to atoms.
std::vector<std::string> columns_of(const Element& element, std::uint64_t rows) {
  const hdf5::Shape shape = element.shape();
  if (shape.empty() || shape.size() > 2 || shape[0] != rows) return {};
  const std::uint64_t components = shape.size() == 2 ? shape[1] : 1;
  const auto kind = element.value().kind();
  if (components > most_components || kind == hdf5::Kind::other) return {};
  if (const auto stated = words(element.columns_attribute()); stated.size() == components)
    return stated;
  if (const KnownElement* k = known(element.name())) {
    if (k->columns.size() == components) return k->columns;
    throw InputError(fmt::format("{}: {} components expected, not {}", element.place(),
                                 k->columns.size(), components));
  }
  if (kind == hdf5::Kind::text && kind_of_column(element.name()) != ColumnKind::text) return {};
  return shape.size() == 1 ? std::vector{element.name()} : numbered(element.name(), components);
}

}  // namespace

Particles::Particles(const hdf5::Group& file)
    : group_(choose(file)), box_(group_), units_(units_of(group_)) {
  const auto position = Element::find(group_, "position");
  if (!position || position->shape().size() != 2 || position->shape()[1] != 3)
    throw InputError(fmt::format("{}: no element 'position' of three coordinates an atom", place()));
  rows_ = position->shape()[0];
  for (const KnownElement& k : known_elements()) {
    if (k.name == "position") position_ = elements_.size();
    add(std::string(k.name));
  }
  for (const std::string& name : group_.names())
    if (!known(name) && name != "box") add(name);
  std::size_t columns = 0;
  for (const AtomElement& e : elements_) columns += e.columns.size();
  if (columns > most_columns)
    throw InputError(fmt::format("{}: {} columns (at most {} are read)", place(), columns, most_columns));
}

void Particles::add(const std::string& name) {
  auto element = Element::find(group_, name);
  if (!element) return;
  auto columns = columns_of(*element, rows_);
  if (known(name) && columns.empty())
    throw InputError(fmt::format("{}: the values are not those of {} atoms", element->place(), rows_));
  for (const std::string& column : columns)
    for (const AtomElement& other : elements_)
      if (std::ranges::find(other.columns, column) != other.columns.end())
        throw InputError(fmt::format("{}: a second column '{}' besides that of {}",
                                     element->place(), column, other.element.place()));
  if (!columns.empty()) elements_.push_back({std::move(*element), std::move(columns)});
}

FrameHeader Particles::header(std::uint64_t frame) const {
  FrameHeader header;
  const Element& element = position().element;
  header.index = frame;
  if (element.time_dependent()) {
    header.step = element.clock().step(frame);
    header.time = element.clock().time(frame);
  }
  header.units = units_;
  header.atoms = rows_;
  for (const Element* e : box_.elements()) check_step(*e, frame, header.step);
  header.box = box_.box(frame);
  for (const AtomElement& e : elements_)
    header.columns.insert(header.columns.end(), e.columns.begin(), e.columns.end());
  header.place = fmt::format("{} (frame {}, step {})", place(), frame, header.step);
  return header;
}

const Element& Particles::id() const { return elements_.front().element; }

std::optional<std::int64_t> Particles::absent() const {
  if (id().name() != "id") return std::nullopt;
  return id().value().fill_integer();
}

Particles::Frames Particles::frames(const std::vector<const Element*>& needed) const {
  Frames frames{1, 1};
  bool first = true;
  const auto count = [&](std::optional<std::uint64_t> n) {
    if (!n) return;
    frames = first ? Frames{*n, *n} : Frames{std::min(frames.whole, *n), std::max(frames.begun, *n)};
    first = false;
  };
  const auto count_all = [&](const Element& element) {
    count(element.frames());
    if (element.time_dependent()) count(element.clock().frames());
  };
  if (!position().element.time_dependent()) return frames;
  count_all(position().element);
  for (const Element* element : box_.elements()) count_all(*element);
  for (const Element* element : needed) count_all(*element);
  return frames;
}

void Particles::check_step(const Element& element, std::uint64_t frame, std::int64_t step) const {
  if (!element.time_dependent()) return;
  if (!position().element.time_dependent())
    throw InputError(fmt::format("{}: there are frames of it, but the positions are fixed",
                                 element.place()));
  const std::int64_t own = element.clock().step(frame);
  if (own != step)
    throw InputError(fmt::format("{}: step {} in frame {}, where the positions have step {}; every "
                                 "element that is read must have the steps of the positions",
                                 element.place(), own, frame, step));
}

}  // namespace mdana::h5md
