// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ranks.hpp"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include <dlfcn.h>
#include <fmt/format.h>

#include "readers/ranks_engine.hpp"

namespace mdana {
namespace {

RankEngine* engine = nullptr;  ///< none without other ranks
bool others_left = false;      ///< nobody waits for this rank any more
bool others_wait = false;      ///< where this rank does not come

/// A number that a starter of processes sets: Open MPI, then what speaks PMI and PMIx.
std::optional<int> told_by_starter(const char* what) {
  for (const char* starter : {"OMPI_COMM_WORLD_", "PMI_", "PMIX_"})
    if (const char* value = std::getenv((std::string(starter) + what).c_str())) return std::atoi(value);
  return std::nullopt;
}

/// Whether there may be others: a PMIx server tells the rank only.
bool may_have_others() {
  const auto size = told_by_starter("SIZE");
  return size ? *size > 1 : told_by_starter("RANK").has_value();
}

RankEngine* load_engine() {
  const auto library = std::filesystem::read_symlink("/proc/self/exe").parent_path() / rank_engine_library;
  void* loaded = ::dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);  // global: Open MPI loads parts that look for it
  void* make = loaded ? ::dlsym(loaded, rank_engine_symbol) : nullptr;
  if (!make)
    throw std::runtime_error(fmt::format("started as one of several processes, but this build cannot share its work among "
                                         "them; start it without mpirun, or build it with MDANA_MPI=ON ({})", ::dlerror()));
  return reinterpret_cast<MakeRankEngine*>(make)();
}

/// Bytes are preceded by this letter and the place in the work, or by this letter and an exit code.
constexpr char at_work = 'w', at_end = 'e';

[[noreturn]] void give_up(int of, int code, std::string why) {
  others_left = true;
  throw RankLeft{of, code, std::move(why)};
}

/// Throws if a rank has left, or is somewhere else.
void check_places(const std::vector<std::string>& all, const std::string& head) {
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k][0] == at_end) give_up(static_cast<int>(k), static_cast<unsigned char>(all[k][1]), all[k].substr(2));
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].starts_with(head))
      give_up(static_cast<int>(k), 1, fmt::format("is at another place of the work ({}) than others ({})",
                                                  all[k].substr(1, all[k].find('\n') - 1), head.substr(1, head.size() - 2)));
}

}  // namespace

void join_ranks() {
  if (!may_have_others()) return;
  const auto size = told_by_starter("SIZE");
  engine = load_engine();
  if (size && *size != engine->count())
    throw std::runtime_error(fmt::format("{} processes were started, but MPI knows of {}: mpirun is not of the MPI that "
                                         "mdana was built with", *size, engine->count()));
}

int rank() { return engine ? engine->rank() : may_have_others() ? told_by_starter("RANK").value_or(0) : 0; }
int rank_count() { return engine ? engine->count() : 1; }
int ranks_here() { return engine ? engine->here() : 1; }

std::vector<std::string> gather_from_ranks(std::string_view place, std::string mine) {
  if (!engine) return {std::move(mine)};
  const std::string head = fmt::format("{}{}\n", at_work, place);
  std::vector<std::string> all = engine->gather(head + mine);
  check_places(all, head);
  for (std::string& bytes : all) bytes.erase(0, head.size());
  return all;
}

void send_to_first_rank(std::string_view bytes) { engine->send(0, bytes); }
std::string receive_from_rank(int rank) { return engine->receive(rank); }

void break_ranks() { others_wait = engine != nullptr; }

Ending end_of_ranks(const Ending& mine) {
  if (!engine || others_left || others_wait) return mine;
  const auto all = engine->gather(fmt::format("{}{}{}", at_end, static_cast<char>(mine.code), mine.told));
  if (mine.code != 0 || !mine.told.empty()) return mine;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k][0] == at_end && all[k][1] != 0)
      return {static_cast<unsigned char>(all[k][1]), fmt::format("rank {}: {}", k, all[k].substr(2))};
  return mine;
}

void leave_ranks(int code) {
  if (!engine) return;
  if (others_wait) engine->abort(code);
  engine->leave();
}

}  // namespace mdana
