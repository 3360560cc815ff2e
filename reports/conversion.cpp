// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/conversion.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyses/block_pipeline.hpp"
#include "analyses/sweep.hpp"
#include "readers/file_set.hpp"
#include "readers/input_error.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"
#include "reports/output_file.hpp"
#include "reports/sorted_frame.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

/// A block under way.
struct Place {
  Chunk chunk;
  AtomBlock block;
};

/// The work on the output; its InputError is no damage of the dump.
template <class Work>
void written(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    throw std::runtime_error(error.what());
  }
}

/// What is written, and what that is made of; none is named if all columns are written.
ColumnSet wanted(const Conversion& conversion) {
  ColumnSet columns = ColumnSet::all_as_they_stand();
  for (const std::string& name : conversion.columns) columns.add(name);
  if (!columns.empty()) {
    for (const AddedColumns& added : conversion.added) columns.add(added.needs);
    if (!conversion.sort.empty()) columns.add(conversion.sort);
  }
  if (conversion.selection) columns.select(*conversion.selection);
  return columns;
}

/// One pass over the dump.
class Pass {
 public:
  /// `most`: frames to be written at most.
  Pass(const Conversion& conversion, const fs::path& output, std::optional<std::uint64_t> most)
      : conversion_(conversion),
        most_(most),
        source_(open_trajectory(conversion.dump, wanted(conversion))),
        writer_(conversion.format->create(output)),
        places_(conversion.threads <= 1 ? 1 : 2 * conversion.threads) {}

  Converted run() {
    try {
      while (!enough() && next()) {
        stop_if_asked();
        frame();
      }
    } catch (const InputError& error) {
      if (conversion_.strict) throw;
      result_.damage = error.what();
    }
    if (!within_frame_) written([&] { writer_->finish(); });
    if (!most_) result_.inputs = source_->records();
    return std::move(result_);
  }

  /// A frame was begun that could not be ended: the output is not whole.
  bool within_frame() const { return within_frame_; }

 private:
  bool enough() const { return most_ && result_.frames >= *most_; }

  /// The next chosen frame.
  bool next() {
    const auto index = conversion_.choice.at_or_after(seen_);
    if (!index) return false;
    source_->seek(*index);
    do {
      stop_if_asked();
      if (!source_->next(header_)) return false;
    } while (header_.index < *index);
    seen_ = header_.index + 1;
    return true;
  }

  void stop_if_asked() const {
    if (conversion_.stop && *conversion_.stop) throw Interrupted(*conversion_.stop);
  }

  void frame() {
    FrameHeader out = header_of_output();
    const auto write = [&](const AtomBlock& block) { written([&] { writer_->add(block); }); };
    if (conversion_.sort.empty() && !conversion_.selection) {
      begin(out);
      blocks(write);
    } else {
      SortedFrame held(conversion_.sort, out.columns);
      out.atoms = 0;
      blocks([&](AtomBlock& block) {
        out.atoms += block.atoms();
        held.add(std::exchange(block, {}));
      });
      begin(out);
      held.give(write);
    }
    within_frame_ = false;
    note(out);
  }

  void begin(const FrameHeader& out) {
    within_frame_ = true;
    written([&] { writer_->begin(out); });
  }

  FrameHeader header_of_output() const {
    FrameHeader out = header_;
    if (header_.units && header_.units != conversion_.units)
      throw InputError(fmt::format("{}: the units are not those of the frames before",
                                   header_.place));
    out.units = conversion_.omit_units ? std::nullopt : conversion_.units;
    if (conversion_.timestep)
      out.time = static_cast<double>(header_.step) * *conversion_.timestep;
    if (conversion_.omit_time) out.time.reset();
    if (!conversion_.columns.empty()) out.columns = conversion_.columns;
    if (!conversion_.sort.empty()) need(conversion_.sort);
    for (const AddedColumns& added : conversion_.added) {
      check_added(added, header_);
      out.columns.insert(out.columns.end(), added.names.begin(), added.names.end());
    }
    return out;
  }

  void need(const std::string& column) const {
    if (!header_.has_column(column))
      throw InputError(fmt::format("{}: this frame has no column '{}'; it has {}", header_.place,
                                   column, fmt::join(header_.columns, " ")));
  }

  void blocks(const std::function<void(AtomBlock&)>& use) {
    BlockPipeline pipeline;
    pipeline.threads = conversion_.threads;
    pipeline.slots = places_.size();
    pipeline.produce = [&](std::size_t slot) { return source_->cut(places_[slot].chunk); };
    pipeline.work = [&](std::size_t slot) {
      mdana::convert(places_[slot].chunk, places_[slot].block);
      add_columns(places_[slot].block);
    };
    pipeline.collect = [&](std::size_t slot) {
      stop_if_asked();
      use(places_[slot].block);
    };
    mdana::run(pipeline);
  }

  void add_columns(AtomBlock& block) const try {
    for (const AddedColumns& added : conversion_.added) added.make(header_, block);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", header_.place, error.what()));
  }

  void note(const FrameHeader& out) {
    if (result_.frames == 0) {
      result_.first_step = out.step;
      result_.least_atoms = out.atoms;
      result_.columns = out.columns;
    }
    ++result_.frames;
    result_.last_step = out.step;
    result_.least_atoms = std::min(result_.least_atoms, out.atoms);
    result_.most_atoms = std::max(result_.most_atoms, out.atoms);
    result_.columns_change = result_.columns_change || out.columns != result_.columns;
    const auto positions = position_source(header_.columns);
    if (positions && positions->may_jump(header_.box)) result_.positions_may_jump = true;
    if (conversion_.progress) conversion_.progress({result_.frames, source_->share()});
  }

  const Conversion& conversion_;
  std::optional<std::uint64_t> most_;
  std::unique_ptr<FrameSource> source_;
  std::unique_ptr<FrameWriter> writer_;
  std::vector<Place> places_;
  FrameHeader header_;
  std::uint64_t seen_ = 0;  ///< frames passed
  bool within_frame_ = false;
  Converted result_;
};

/// What has been begun of a damaged frame cannot be taken back: then all is written again up to it.
Converted run_passes(const Conversion& conversion, const fs::path& output) {
  Converted result;
  bool whole;
  {
    Pass pass(conversion, output, {});
    result = pass.run();
    whole = !pass.within_frame();
  }
  if (result.frames == 0)
    throw InputError(result.damage.empty() ? conversion.dump.string() + ": no frame in the file"
                                           : result.damage);
  if (!whole) {
    fs::remove(output);
    Pass(conversion, output, result.frames).run();
  }
  return result;
}

}  // namespace

void check_new_file(const fs::path& dump, const fs::path& output) {
  if (!fs::exists(output)) return;
  if (!fs::is_regular_file(output))
    throw InputError(fmt::format("{}: exists and is not a file; it is not replaced",
                                 output.string()));
  const auto set = find_file_set(dump);
  const FileSet inputs = set ? *set : FileSet{std::vector<fs::path>{dump}};
  for (const auto& pieces : inputs)
    for (const fs::path& input : pieces)
      if (std::error_code none; fs::equivalent(input, output, none))
        throw InputError(fmt::format("{}: the output is the input {}; choose another name",
                                     output.string(), input.string()));
}

Converted convert_dump(const Conversion& conversion) {
  const auto start = std::chrono::steady_clock::now();
  check_new_file(conversion.dump, conversion.output);
  OutputFile file(conversion.output);
  Converted result;
  file.writing([&] { result = run_passes(conversion, file.path()); });
  result.size = fs::file_size(file.path());
  file.commit();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace mdana
