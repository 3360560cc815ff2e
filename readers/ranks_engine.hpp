// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// What readers/ranks.cpp asks of MPI. It is in a library of its own (readers/ranks_mpi.cpp), which is loaded only if mpirun
/// started the process: the loader takes 11 ms for MPI and what it brings, and 1 ms for a program without it.
class RankEngine {
 public:
  virtual ~RankEngine() = default;
  virtual int rank() const = 0;
  virtual int count() const = 0;
  virtual int here() const = 0;  ///< ranks on this machine
  virtual std::vector<std::string> gather(const std::string& mine) = 0;
  virtual void send(int to, std::string_view bytes) = 0;
  virtual std::string receive(int from) = 0;
  virtual void leave() = 0;           ///< waits for the others
  virtual void abort(int code) = 0;  ///< ends them
};

/// The one that the library has, joined.
using MakeRankEngine = RankEngine*();
inline constexpr const char* rank_engine_symbol = "mdana_rank_engine";
inline constexpr const char* rank_engine_library = "libmdana_mpi.so";  ///< beside the program

}  // namespace mdana
