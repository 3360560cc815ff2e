// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/faults.hpp"

#include <algorithm>
#include <charconv>

namespace mdana {
namespace {

constexpr auto error = Severity::error, note = Severity::note;

constexpr FaultKindWords all_kinds[] = {
    {FaultKind::word, "word", error, "a word that is no number where one must be"},
    {FaultKind::not_whole, "not_whole", error, "a number that must be whole and is not, or is too great"},
    {FaultKind::line, "line", error, "a line with another number of columns than the header names"},
    {FaultKind::block, "block", error, "atoms of a binary file that cannot be read"},
    {FaultKind::header, "header", error, "a frame's header that cannot be understood"},
    {FaultKind::atom_count, "atom_count", error, "more or fewer atoms than the header says"},
    {FaultKind::truncated, "truncated", error, "the file ends early, or its compressed data are damaged"},
    {FaultKind::duplicate_id, "duplicate_id", error, "an id that stands twice in a frame"},
    {FaultKind::not_finite, "not_finite", error, "nan or inf"},
    {FaultKind::type, "type", error, "an atom type below 1"},
    {FaultKind::mass, "mass", error, "a mass that is not above zero"},
    {FaultKind::step_order, "step_order", error, "a step that does not come after the one before"},
    {FaultKind::time_order, "time_order", error, "a time that does not come after the one before"},
    {FaultKind::time_missing, "time_missing", error, "some frames state their time and some do not"},
    {FaultKind::units_change, "units_change", error, "units unlike those of an earlier frame"},
    {FaultKind::outside_box, "outside_box", note,
     "wrapped positions more than half a box outside a periodic box"},
    {FaultKind::atoms_change, "atoms_change", note, "another number of atoms than the frame before"},
    {FaultKind::columns_change, "columns_change", note, "other columns than the frame before"},
    {FaultKind::file_step, "file_step", note,
     "a file whose first step is not the number in its name, in a set of files by '*'"},
    {FaultKind::ids_lost, "ids_lost", note, "ids of the first whole frame that a later one lacks"},
    {FaultKind::ids_gained, "ids_gained", note, "ids that the first whole frame does not have"},
    {FaultKind::ids_unchecked, "ids_unchecked", note, "ids not compared, --memory is too small"},
    {FaultKind::no_atoms, "no_atoms", note, "a frame without atoms"},
};

bool digit(char c) { return c >= '0' && c <= '9'; }

/// What begins behind a colon: " what", "12: what" or "12 (frame 0, step 100)".
bool takes_place(std::string_view rest, Fault& fault) {
  if (rest.starts_with(' ')) {
    fault.what = rest.substr(1);
    return true;
  }
  std::uint64_t line = 0;
  const auto [end, failed] = std::from_chars(rest.data(), rest.data() + rest.size(), line);
  if (failed != std::errc{}) return false;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (!rest.empty() && rest.front() != ' ' && !rest.starts_with(": ")) return false;
  fault.line = line;
  fault.what = rest.substr(std::min(rest.size(), std::size_t{rest.starts_with(':') ? 2u : 1u}));
  return true;
}

}  // namespace

std::span<const FaultKindWords> fault_kinds() { return all_kinds; }

const FaultKindWords& words_of(FaultKind kind) { return all_kinds[static_cast<std::size_t>(kind)]; }

void Faults::add(Fault fault) {
  const auto k = static_cast<std::size_t>(fault.kind);
  counts_[k] += fault.times;
  if (kept_of_[k] == limit_) return;
  ++kept_of_[k];
  kept_.push_back(std::move(fault));
}

void Faults::add(const Faults& later) {
  auto counts = counts_;
  for (std::size_t k = 0; k < kinds; ++k) counts[k] += later.counts_[k];
  for (const Fault& fault : later.kept_) add(fault);
  counts_ = counts;
}

std::uint64_t Faults::count(Severity severity) const {
  std::uint64_t sum = 0;
  for (const FaultKindWords& words : all_kinds)
    if (words.severity == severity) sum += count(words.kind);
  return sum;
}

void Faults::settle(std::uint64_t frame, std::int64_t step, std::string_view dump) {
  for (Fault& fault : kept_) {
    if (fault.file.empty()) {
      const Fault found = located(fault.kind, fault.what, dump);
      fault.file = found.file;
      fault.what = found.what;
      if (found.line) fault.line = found.line;
    }
    if (!fault.frame) fault.frame = frame;
    if (!fault.step) fault.step = step;
  }
}

void BlockFaults::reset() { *this = BlockFaults(faults.limit()); }

void BlockFaults::spoil(std::size_t atom, std::size_t atoms) {
  unusable.resize(std::max(atoms, unusable.size()));
  unusable[atom] = true;
}

Fault located(FaultKind kind, std::string_view message, std::string_view dump) {
  Fault fault;
  fault.kind = kind;
  fault.what = message;
  fault.file = dump;
  const std::string_view start = dump.substr(0, dump.find_first_of("*%"));
  if (!message.starts_with(start)) return fault;
  const std::size_t frame = message.find(" (frame ", start.size());
  for (std::size_t colon = message.find(':', start.size()); colon != std::string_view::npos;
       colon = message.find(':', colon + 1)) {
    const std::string_view rest = message.substr(colon + 1);
    if (rest.empty() || !(rest.front() == ' ' || digit(rest.front()))) continue;
    if (!takes_place(rest, fault)) continue;
    fault.file = message.substr(0, std::min(colon, frame));
    return fault;
  }
  if (frame != std::string_view::npos) fault.file = message.substr(0, frame);
  return fault;
}

}  // namespace mdana
