// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/free_memory.hpp"

#include <fstream>
#include <string>

namespace mdana {

std::size_t free_memory() {
  std::ifstream told("/proc/meminfo");
  std::string name, unit;
  for (std::size_t kilobytes = 0; told >> name >> kilobytes; std::getline(told, unit))
    if (name == "MemAvailable:") return kilobytes << 10;
  return std::size_t{1} << 30;
}

}  // namespace mdana
