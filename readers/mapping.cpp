// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/mapping.hpp"

#include <atomic>
#include <csignal>
#include <cstring>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace mdana {
namespace {

/// A range that is mapped now, where a signal handler can find it: entries are used again, but never freed.
struct Known {
  std::atomic<const char*> begin{nullptr};  ///< null: free
  std::atomic<bool> taken{false};
  std::size_t size = 0;
  std::string message;
  Known* next = nullptr;
};
std::atomic<Known*> known_ranges{nullptr};

Known* free_entry() {
  for (Known* k = known_ranges; k; k = k->next)
    if (!k->taken.exchange(true)) return k;
  Known* fresh = new Known;
  fresh->taken = true;
  fresh->next = known_ranges;
  while (!known_ranges.compare_exchange_weak(fresh->next, fresh)) continue;
  return fresh;
}

/// Only calls that are allowed in a handler. An address of no known range is another fault: as without a handler.
void on_bus_error(int number, siginfo_t* info, void*) {
  const char* address = static_cast<const char*>(info->si_addr);
  for (const Known* k = known_ranges; k; k = k->next) {
    const char* begin = k->begin;
    if (!begin || address < begin || address >= begin + k->size) continue;
    [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, k->message.data(), k->message.size());
    ::_exit(1);
  }
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void handle_bus_errors() {
  [[maybe_unused]] static const bool once = [] {
    struct sigaction action {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO;
    return ::sigaction(SIGBUS, &action, nullptr) == 0;
  }();
}

void make_known(std::string_view bytes, const std::filesystem::path& path) {
  handle_bus_errors();
  Known* entry = free_entry();
  entry->size = bytes.size();
  entry->message = "mdana: " + path.string() +
                   ": another program cut it while it was read, or the disk failed; run again when it is whole\n";
  entry->begin = bytes.data();
}

void forget(std::string_view bytes) {
  for (Known* k = known_ranges; k; k = k->next)
    if (k->begin == bytes.data()) {
      k->begin = nullptr;
      k->taken = false;
      return;
    }
}

}  // namespace

std::unique_ptr<Mapping> Mapping::of(int descriptor, std::size_t size, const std::filesystem::path& path) {
  void* start = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  if (start == MAP_FAILED) return nullptr;
  ::madvise(start, size, MADV_SEQUENTIAL);
  std::unique_ptr<Mapping> mapping(new Mapping({static_cast<const char*>(start), size}));
  make_known(mapping->bytes(), path);
  return mapping;
}

Mapping::~Mapping() {
  forget(bytes_);
  ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

}  // namespace mdana
