// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/plan_costs.hpp"

#include <algorithm>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "analyses/contact_network.hpp"
#include "analyses/defects.hpp"
#include "analyses/far_side.hpp"
#include "analyses/frame_probe.hpp"
#include "analyses/free_memory.hpp"
#include "readers/column_choice.hpp"
#include "readers/file_set.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/contact_numbers.hpp"
#include "reports/network.hpp"
#include "reports/stability.hpp"

namespace mdana {
namespace {

using Analyses = std::vector<std::unique_ptr<Analysis>>;

constexpr double counting_seconds = 0.25;         ///< for the look at how many frames there are
constexpr std::uint64_t probed_atoms = 200'000;   ///< of all probed frames together
constexpr std::uint64_t most_probed_frames = 8;
constexpr double alike = 1.6;                     ///< factor of error where frames of the whole run were timed,
constexpr double only_first = 3;                  ///< where only first ones were, which are far from contact
constexpr double parts_of_frames = 2;             ///< and where only parts of frames were, besides

double cost_of(const auto& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

/// Bytes that the program itself takes now.
double resident_bytes() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("VmRSS:")) return 1024 * std::stod(line.substr(6));
  return 0;
}

std::uint64_t bytes_on_disk(const std::filesystem::path& dump) {
  const auto set = find_file_set(dump);
  if (!set) return std::filesystem::file_size(dump);
  std::uint64_t bytes = 0;
  for (const auto& pieces : *set)
    for (const auto& piece : pieces) bytes += std::filesystem::file_size(piece);
  return bytes;
}

/// The chosen ones among so many.
std::uint64_t used_frames(const FrameChoice& choice, std::uint64_t frames) {
  const std::uint64_t end = std::min(choice.end.value_or(frames), frames);
  return end > choice.first ? (end - choice.first + choice.stride - 1) / choice.stride : 0;
}

/// In the middles of as many equal parts of the chosen frames before `end`.
std::vector<std::uint64_t> spread(const FrameChoice& choice, std::uint64_t end, std::uint64_t atoms) {
  const std::uint64_t used = used_frames(choice, end);
  const std::uint64_t most = std::clamp<std::uint64_t>(probed_atoms / std::max<std::uint64_t>(atoms, 1), 1, most_probed_frames);
  const std::uint64_t count = std::min(most, used);
  std::set<std::uint64_t> numbers;
  for (std::uint64_t k = 0; k < count; ++k)
    numbers.insert(choice.first + (2 * k + 1) * used / (2 * count) * choice.stride);
  return {numbers.begin(), numbers.end()};
}

Analyses member_made(std::string_view name, const Run& run) {
  Analyses all;
  for (const AnalysisMember* member : analysis_members())
    if (member->name == name) all.push_back(member->make({run.scene, run.first}));
  return all;
}

/// What times the parts of a plan.
class CostEstimate {
 public:
  CostEstimate(const Run& run, const Plan& plan, const PlanWishes& wishes, const SweepOptions& sweeping)
      : run_(run), plan_(plan), wishes_(wishes), sweeping_(sweeping), count_(count_quickly(run.dump, counting_seconds)) {
    sweeping_.selection = run.selection;
    cost_.input_bytes = bytes_on_disk(run.dump);
    cost_.atoms = run.first.atoms;
    cost_.frames = used_frames(sweeping.choice, count_.frames);
    cost_.frames_source = count_.source;
    cost_.bytes = resident_bytes();
  }

  PlanCost make() {
    if (plan_.computed.empty()) return cost_;
    const bool reachable = count_.counted;
    const auto numbers = spread(sweeping_.choice, reachable ? count_.frames : count_.met, run_.first.atoms);
    if (numbers.empty()) throw InputError(fmt::format("{}: no frame in the file, or none chosen", run_.dump.string()));
    const double seconds = cost_of([&] { probe(numbers); });
    add_repeated();
    finish(numbers.size(), seconds);
    return cost_;
  }

 private:
  ColumnSet columns() const {
    ColumnSet all{"x", "y", "z"};
    for (const PlannedPart& part : plan_.computed)
      for (const std::string& name : part.columns)
        if (!ColumnSet{"x", "y", "z"}.has(name) && !is_position(name)) all.add(name);
    return all;
  }

  /// Of a dump that spells positions in another way, they come with x y z.
  static bool is_position(const std::string& name) {
    static const ColumnSet spelt{"xs", "ys", "zs", "xu", "yu", "zu", "xsu", "ysu", "zsu", "ix", "iy", "iz"};
    return spelt.has(name);
  }

  void probe(const std::vector<std::uint64_t>& numbers) {
    const FrameProbe probe(run_.dump, run_.bodies, run_.masses, sweeping_, columns(), numbers,
                           std::max<std::uint64_t>(1, probed_atoms / numbers.size()));
    share_ = probe.share();
    Analyses motion;
    motion.push_back(make_motion(motion_parts()));
    if (!two_bodies()) motion.clear();
    base_ = probe.seconds(motion);
    if (plan_.has(Part::stability)) moved_ = probe.seconds(motion, true);
    pass_ = count_.seconds * static_cast<double>(count_.frames);
    cost_.tokens = cost_.frames * cost_.atoms * ColumnChoice(run_.first, with_bodies()).columns().size();
    serial_ += pass_;
    add("reading, centres of mass", start_seconds + prepare_seconds() + pass_ + base_ * frames(), reading_bytes(), 1,
        "once, for all that follows");
    for (const PlannedPart& part : plan_.computed) time(part.part, probe);
  }

  ColumnSet with_bodies() const {
    ColumnSet all = columns();
    all.add(run_.bodies.columns());
    all.add(run_.masses.columns());
    return all;
  }

  bool two_bodies() const { return run_.bodies.count() == 2; }
  double frames() const { return static_cast<double>(cost_.frames); }
  double atoms() const { return static_cast<double>(cost_.atoms); }

  MotionParts motion_parts() const {
    const ColumnSet all = columns();
    return {all.has("vx"), all.has("fx")};
  }

  void add(std::string_view what, double seconds, double bytes = 0, double passes = 1, const char* shared = "") {
    cost_.parts.push_back({std::string(what), passes, seconds, bytes, shared});
  }

  /// A part that has analyses of its own.
  void time(Part part, const FrameProbe& probe) {
    switch (part) {
      case Part::contact_radius: return time_contact(probe);
      case Part::plasticity: return add_timed(part, far_side(), probe);
      case Part::energies:
        add_timed(part, member_made("energy", run_), probe, kept_bytes());
        return time_exchange();
      case Part::rotation:
        if (!plan_.has(Part::energies)) add_timed(part, member_made("energy", run_), probe, kept_bytes());
        return;
      case Part::structure: return add_timed(part, lattice(false), probe, lattice_bytes());
      case Part::dislocations: return add_timed(part, lattice(true), probe, atoms() * bytes_an_atom_lines);
      case Part::compression: return add_timed(part, member_made("halves", run_), probe);
      case Part::coordination: return time_network(part, probe, 1);
      case Part::network: return time_network(part, probe, frames());
      case Part::pictures: return time_pictures(probe);
      case Part::surface_energy: return add_timed(part, member_made("surface_energy", run_), probe, 0, 1);
      case Part::hertz_fit: return time_fits();
      default: return;
    }
  }

  /// Above what the motion takes.
  double above_base(Analyses analyses, const FrameProbe& probe) const {
    if (two_bodies()) analyses.insert(analyses.begin(), make_motion(motion_parts()));
    return std::max(0.0, probe.seconds(analyses) - base_);
  }

  void add_timed(Part part, Analyses analyses, const FrameProbe& probe, double bytes = 0, double frames_used = 0) {
    add(name(part), above_base(std::move(analyses), probe) * (frames_used > 0 ? frames_used : frames()), bytes);
  }

  /// Of the two definitions by area only what they take above the other one.
  void time_contact(const FrameProbe& probe) {
    ContactOptions options;
    options.layer = wishes_.layer;
    ContactSetup setup;
    Radii radii;
    first_ = cost_of([&] {
      radii = find_radii(run_, {});
      setup = contact_setup(run_, options);
    });
    Analyses both = contact_analyses(radii, setup);
    const bool areas = both.size() > 1;
    Analyses one;
    one.push_back(std::move(both.front()));
    const double gyration = above_base(std::move(one), probe);
    contact_ = areas ? above_base(contact_analyses(radii, setup), probe) : gyration;
    serial_ += first_;
    add(name(Part::contact_radius), first_ + gyration * frames());
    if (areas) add(name(Part::contact_areas), std::max(0.0, contact_ - gyration) * frames());
  }

  /// The first frame is read once more, and remembered.
  void time_network(Part part, const FrameProbe& probe, double frames_used) {
    Analyses network;
    const double setup = cost_of([&] { network.push_back(make_contact_network(network_setup(run_, find_radii(run_, {}), {}).settings)); });
    serial_ += setup;
    add(name(part), setup + above_base(std::move(network), probe) * frames_used, lattice_bytes());
  }

  /// Three frames are looked for and read once more; where there may be defects, three with their lines besides.
  void time_pictures(const FrameProbe& probe) {
    const double frame = plan_.has(Part::structure) ? 2 * base_ + above_base(lattice(true), probe) : base_;
    serial_ += 3 * pass_;
    add(name(Part::pictures), 3 * (pass_ + frame));
  }

  /// The last frame is looked for and its atoms are put into clusters, if the bodies separate: as those that only repel
  /// each other do.
  void time_exchange() {
    if (run_.scene.interaction != Interaction::hertz || !run_.first.has_column("id")) return;
    add("exchanged atoms", pass_ + cluster_seconds * atoms(), 0, 1, "once more, as the bodies separate");
  }

  /// What every command does before.
  double prepare_seconds() const {
    return cost_of([&] { find_bodies(run_.dump, run_.first, run_.scene.bodies, run_.selection); });
  }

  void time_fits() {
    serial_ += fits_seconds;
    add(name(Part::hertz_fit), fits_seconds);
  }

  static Analyses far_side() {
    Analyses all;
    all.push_back(make_far_side());
    return all;
  }

  Analyses lattice([[maybe_unused]] bool lines) const {
    Analyses all;
#ifdef MDANA_WITH_DEFECTS
    DefectSettings settings;
    settings.ids = run_.first.has_column("id");
    settings.surface = settings.lines = lines;
    all.push_back(make_defects(std::move(settings)));
#endif
    return all;
  }

  /// Passes that do everything that the published numbers need once more.
  void add_repeated() {
    const double pass = pass_ + first_ + (plan_.has(Part::hertz_fit) ? fits_seconds : 0);
    const double frame = (base_ + contact_) * frames();
    if (plan_.has(Part::accuracy)) {
      const auto [passes, all_frames] = accuracy_passes(plan_.has(Part::hertz_fit));
      serial_ += passes * pass;
      add(name(Part::accuracy), passes * pass + all_frames * frame, 0, passes);
    }
    if (!plan_.has(Part::stability)) return;
    serial_ += stability_repetitions * pass;
    add(name(Part::stability), stability_repetitions * (pass + frame + (moved_ - base_) * frames()), 0, stability_repetitions);
  }

  // ---- memory ----

  double threads() const { return static_cast<double>(sweeping_.threads); }

  /// Blocks under way and what is read ahead.
  double reading_bytes() const {
    const double columns = 8.0 * static_cast<double>(ColumnChoice(run_.first, with_bodies()).columns().size());
    const double block = std::min<double>(atoms(), AtomBlock::capacity) * (columns + text_bytes * columns / 8);
    return 4 * threads() * block + read_ahead;
  }

  /// Of atoms that are looked at twice.
  double kept_bytes() const {
    const double columns = 8.0 * static_cast<double>(ColumnChoice(run_.first, with_bodies()).columns().size());
    return std::min(atoms() * columns, static_cast<double>(sweeping_.memory));
  }

  double lattice_bytes() const {
    const double most = static_cast<double>(sweeping_.frame_memory.value_or(free_memory() / 2));
    return std::min(atoms() * bytes_an_atom_together, most);
  }

  void finish(std::size_t probed, double seconds) {
    for (const PartCost& part : cost_.parts) {
      cost_.processor_seconds += part.seconds;
      cost_.bytes += part.bytes;
    }
    cost_.seconds = serial_ + (cost_.processor_seconds - serial_) / threads();
    const bool whole = share_ > 0.99;
    cost_.factor = (count_.counted ? alike : only_first) * (whole ? 1 : parts_of_frames);
    cost_.source = fmt::format("{} of {} frames{}{} were analysed in {:.2f} s", probed, cost_.frames,
                               count_.counted ? ", spread over the run," : ", the first ones,",
                               whole ? "" : fmt::format(" and of them one atom of {:.0f},", 1 / share_), seconds);
  }

  // Measured on one machine; small beside what is timed.
  static constexpr double start_seconds = 0.02;
  static constexpr double cluster_seconds = 2e-5;  ///< an atom
  static constexpr double text_bytes = 12;      ///< of a number in a dump
  static constexpr double read_ahead = 12e6;
  static constexpr double bytes_an_atom_together = 64;
  static constexpr double bytes_an_atom_lines = 400;  ///< besides; of spheres of radius 29 in collision
  static constexpr double fits_seconds = 0.03;  ///< of the 48 fits of a Hertz run, which need no atoms

  const Run& run_;
  const Plan& plan_;
  const PlanWishes& wishes_;
  SweepOptions sweeping_;
  FrameCount count_;
  PlanCost cost_;
  double share_ = 1;                      ///< of the atoms of the probed frames
  double pass_ = 0;                       ///< seconds over all frames without looking at atoms
  double base_ = 0, moved_ = 0;           ///< seconds a frame of the motion, and with last digits moved
  double contact_ = 0;                    ///< seconds a frame of the contact radii
  double first_ = 0;                      ///< seconds that the first frame takes before
  double serial_ = 0;                     ///< seconds of what threads do not share
};

}  // namespace

PlanCost estimate_cost(const Run& run, const Plan& plan, const PlanWishes& wishes, const SweepOptions& sweeping) {
  return CostEstimate(run, plan, wishes, sweeping).make();
}

}  // namespace mdana
