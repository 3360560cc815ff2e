// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana {

// The processes of one command that mpirun started together. Each of them runs the whole command; loops over much data
// share the work and tell each other what they found, so that all know the same and go the same way. The first rank alone
// writes. Without mpirun there is one rank, and no MPI is loaded.

/// Joins the other ranks if mpirun started this process; once, before the functions below. Throws std::runtime_error if
/// this build cannot.
void join_ranks();

int rank();        ///< of this process: 0, 1, ...
int rank_count();  ///< of all
int ranks_here();  ///< of those on this machine

inline bool is_first_rank() { return rank() == 0; }

/// Another rank has left with a failure. No std::exception, since nobody but the program's end may catch it.
struct RankLeft {
  int rank;
  int code;         ///< that the program ends with
  std::string why;
};

/// The bytes of every rank, by rank. All of them must call it, at the same `place` of their work. Throws RankLeft.
std::vector<std::string> gather_from_ranks(std::string_view place, std::string mine);

/// From a rank to the first one, one by one in order.
void send_to_first_rank(std::string_view bytes);
std::string receive_from_rank(int rank);

/// Something failed where another rank waits for this one: the end of this process has to end the others.
void break_ranks();

/// How a process ends: its exit code, and what it says on the standard error.
struct Ending {
  int code = 0;
  std::string told;
};

/// The end of the work: the ending of all ranks, which is this one's without others. Called once by each.
Ending end_of_ranks(const Ending& mine);

/// After `end_of_ranks`: no rank is left without the others.
void leave_ranks(int code);

}  // namespace mdana
