// SPDX-License-Identifier: GPL-3.0-or-later
// The only source with MPI; the library libmdana_mpi.so is made of it alone. Errors of MPI end the job, as is its default.
#include <algorithm>
#include <cstdint>

#include <mpi.h>

#include "readers/ranks_engine.hpp"

namespace mdana {
namespace {

constexpr std::uint64_t most_at_once = std::uint64_t{1} << 30;  ///< bytes: counts of MPI are int

int as_int(std::uint64_t bytes) { return static_cast<int>(bytes); }

class MpiRanks final : public RankEngine {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm machine;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &here_);
    MPI_Comm_free(&machine);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  int here() const override { return here_; }

  std::vector<std::string> gather(const std::string& mine) override {
    std::vector<std::uint64_t> size(static_cast<std::size_t>(count_));
    std::uint64_t own = mine.size();
    MPI_Allgather(&own, 1, MPI_UINT64_T, size.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
    std::vector<std::string> all(size.size());
    const std::uint64_t piece = most_at_once / size.size(), longest = *std::ranges::max_element(size);
    for (std::uint64_t first = 0; first < longest; first += piece) gather_piece(mine, size, first, piece, all);
    return all;
  }

  void send(int to, std::string_view bytes) override {
    std::uint64_t size = bytes.size();
    MPI_Send(&size, 1, MPI_UINT64_T, to, 0, MPI_COMM_WORLD);
    for (std::uint64_t first = 0; first < size; first += most_at_once)
      MPI_Send(bytes.data() + first, as_int(std::min(most_at_once, size - first)), MPI_BYTE, to, 0, MPI_COMM_WORLD);
  }

  std::string receive(int from) override {
    std::uint64_t size = 0;
    MPI_Recv(&size, 1, MPI_UINT64_T, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    std::string bytes(size, '\0');
    for (std::uint64_t first = 0; first < size; first += most_at_once)
      MPI_Recv(bytes.data() + first, as_int(std::min(most_at_once, size - first)), MPI_BYTE, from, 0, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
    return bytes;
  }

  void leave() override { MPI_Finalize(); }
  void abort(int code) override { MPI_Abort(MPI_COMM_WORLD, code); }

 private:
  /// Up to `piece` bytes from `first` on of every rank.
  static void gather_piece(const std::string& mine, const std::vector<std::uint64_t>& size, std::uint64_t first,
                           std::uint64_t piece, std::vector<std::string>& all) {
    std::vector<int> counts, places;
    int total = 0;
    for (const std::uint64_t bytes : size) {
      counts.push_back(as_int(std::min(piece, bytes - std::min(bytes, first))));
      places.push_back(total);
      total += counts.back();
    }
    std::string together(static_cast<std::size_t>(total), '\0');
    const char* from = mine.data() + std::min<std::uint64_t>(first, mine.size());
    const auto own = std::min<std::uint64_t>(piece, mine.size() - std::min<std::uint64_t>(first, mine.size()));
    MPI_Allgatherv(from, as_int(own), MPI_BYTE, together.data(), counts.data(), places.data(), MPI_BYTE, MPI_COMM_WORLD);
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k].append(together, static_cast<std::size_t>(places[k]), static_cast<std::size_t>(counts[k]));
  }

  int rank_ = 0, count_ = 1, here_ = 1;
};

}  // namespace
}  // namespace mdana

extern "C" mdana::RankEngine* mdana_rank_engine() {
  static mdana::MpiRanks ranks;
  return &ranks;
}
