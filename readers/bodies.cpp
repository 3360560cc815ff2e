// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/bodies.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/clusters.hpp"
#include "readers/input_error.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

constexpr std::size_t most_bodies = 255;

/// A frame, the first unless another is asked for, and which of its atoms count.
struct FirstFrame {
  const std::filesystem::path& dump;
  const FrameHeader& header;
  const std::optional<Selection>& selection;
  std::uint64_t index = 0;

  template <class Use>
  FrameHeader for_blocks(const ColumnSet& wanted, Use&& use) const {
    return for_frame(dump, index, wanted, std::forward<Use>(use), selection);
  }
};

/// The distinct values of an integer column in the first frame; stops counting beyond 255.
std::vector<std::int64_t> distinct(const FirstFrame& frame, const std::string& column) {
  std::set<std::int64_t> values;
  frame.for_blocks({column}, [&](const AtomBlock& block) {
    for (const std::int64_t v : block.integer(column))
      if (values.size() <= most_bodies) values.insert(v);
  });
  return {values.begin(), values.end()};
}

Bodies one_a_value(const std::string& column, const std::vector<std::int64_t>& values) {
  std::vector<Bodies::Run> runs;
  for (const std::int64_t v : values)
    runs.push_back({v, v, static_cast<BodyIndex>(runs.size() + 1)});
  return {column, runs, fmt::format("{} {}", column, fmt::join(values, ", "))};
}

Bodies by_values(const FirstFrame& frame, const std::string& column) {
  const FrameHeader& first = frame.header;
  if (!first.has_column(column))
    throw InputError(fmt::format("{}: no column '{}' for --bodies {}", first.place, column, column));
  const auto values = distinct(frame, column);
  if (values.size() > most_bodies)
    throw InputError(fmt::format("{}: more than {} different values of '{}'; use another --bodies",
                                 first.place, most_bodies, column));
  return one_a_value(column, values);
}

std::int64_t whole_number(std::string_view text, const std::string& rule) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError(fmt::format("bodies '{}': id:FIRST-LAST expected", rule));
  return value;
}

struct IdRange {
  std::int64_t first, last;
};

/// The range of a rule "id:FIRST-LAST".
IdRange parse_id_range(const std::string& rule) {
  const std::string_view range = std::string_view(rule).substr(3);
  const std::size_t dash = range.find('-', 1);
  if (dash == std::string_view::npos)
    throw InputError(fmt::format("bodies '{}': id:FIRST-LAST expected", rule));
  const IdRange ids{whole_number(range.substr(0, dash), rule),
                    whole_number(range.substr(dash + 1), rule)};
  if (ids.last < ids.first) throw InputError(fmt::format("bodies '{}': the range is empty", rule));
  return ids;
}

Bodies by_id_range(const FrameHeader& first, const std::string& rule) {
  if (!first.has_column("id"))
    throw InputError(fmt::format("{}: no column 'id' for --bodies {}", first.place, rule));
  const auto [a, b] = parse_id_range(rule);
  using Limits = std::numeric_limits<std::int64_t>;
  std::vector<Bodies::Run> runs;
  if (a > Limits::min()) runs.push_back({Limits::min(), a - 1, 2});
  runs.push_back({a, b, 1});
  if (b < Limits::max()) runs.push_back({b + 1, Limits::max(), 2});
  return {"id", runs, fmt::format("ids {} to {}, and all others", a, b)};
}

/// The box, periodic where bodies may lie across its faces.
Box wrapping_box(const FrameHeader& first) {
  Box box = first.box;
  const auto positions = position_source(first.columns);
  if (!positions || !positions->may_jump(box)) box.periodic = {false, false, false};
  return box;
}

Bodies by_clusters(const FirstFrame& frame) {
  const FrameHeader& first = frame.header;
  if (!first.has_column("id"))
    throw InputError(fmt::format("{}: no column 'id' to follow clusters by", first.place));
  std::vector<std::int64_t> ids;
  std::vector<double> coordinates;  // grows with what is read: the stated number may be wrong
  const FrameHeader read = frame.for_blocks({"id", "x", "y", "z"}, [&](const AtomBlock& block) {
    const auto id = block.integer("id");
    const auto x = block.real("x"), y = block.real("y"), z = block.real("z");
    ids.insert(ids.end(), id.begin(), id.end());
    for (std::size_t i = 0; i < x.size(); ++i)
      coordinates.insert(coordinates.end(), {x[i], y[i], z[i]});
  });
  const Eigen::Map<const Eigen::Matrix3Xd> positions(coordinates.data(), 3,
                                                     static_cast<Eigen::Index>(ids.size()));
  try {
    const Clusters clusters = find_clusters(positions, wrapping_box(read));
    return {"id", cluster_runs(clusters, ids, ids.size() / 100 + 1),
            fmt::format("clusters of atoms within {:.4g} of each other in {}", clusters.link_distance,
                        frame.index == 0 ? "the first frame" : fmt::format("frame {}", frame.index))};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", first.place, error.what()));
  }
}

Bodies by_default(const FirstFrame& frame) {
  for (const char* column : {"type", "mol"}) {
    if (!frame.header.has_column(column)) continue;
    const auto values = distinct(frame, column);
    if (values.size() == 2) return one_a_value(column, values);
  }
  return by_clusters(frame);
}

}  // namespace

Bodies::Bodies(std::string column, std::vector<Run> runs, std::string rule)
    : column_(std::move(column)), runs_(std::move(runs)), rule_(std::move(rule)) {
  for (const Run& run : runs_) count_ = std::max<std::size_t>(count_, run.body);
}

Bodies Bodies::renumbered(std::span<const BodyIndex> number) const {
  std::vector<Run> runs;
  for (Run run : runs_) {
    run.body = number[run.body - 1];
    if (run.body > 0) runs.push_back(run);
  }
  return {column_, std::move(runs), rule_};
}

void Bodies::label(const AtomBlock& block, std::vector<BodyIndex>& body) const {
  const auto values = block.integer(column_);
  body.resize(values.size());
  Run last{1, 0, 0};  // neighbours in a file mostly belong to the same run
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int64_t v = values[i];
    if (v < last.first || v > last.last) {
      const auto it = std::lower_bound(runs_.begin(), runs_.end(), v,
                                       [](const Run& run, std::int64_t x) { return run.last < x; });
      last = it != runs_.end() && it->first <= v ? *it : Run{v, v, 0};
    }
    body[i] = last.body;
  }
}

void check_bodies_rule(const std::string& rule) {
  if (rule.starts_with("id:"))
    parse_id_range(rule);
  else if (rule != "type" && rule != "mol" && rule != "clusters")
    throw InputError(fmt::format("bodies '{}': type, mol, clusters or id:FIRST-LAST expected", rule));
}

Bodies find_bodies(const std::filesystem::path& dump, const FrameHeader& first,
                   const std::string& rule, const std::optional<Selection>& selection) {
  const FirstFrame frame{dump, first, selection};
  if (rule.empty()) return by_default(frame);
  check_bodies_rule(rule);
  if (rule == "type" || rule == "mol") return by_values(frame, rule);
  if (rule.starts_with("id:")) return by_id_range(first, rule);
  return by_clusters(frame);
}

Bodies clusters_of_frame(const std::filesystem::path& dump, const FrameHeader& header,
                         std::uint64_t frame, const std::optional<Selection>& selection) {
  return by_clusters({dump, header, selection, frame});
}

}  // namespace mdana
