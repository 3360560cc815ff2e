// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/free_memory.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace mdana {
namespace {

TEST(FreeMemory, IsLessThanTheMachineHas) {
  const auto pages = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)), page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  EXPECT_LT(free_memory(), pages * page);
  EXPECT_GT(free_memory(), 0u);
}

/// Bytes that a process has left which may use so many in all; in MB, as far as an exit code goes.
int left_within(rlim_t limit) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limited{limit, limit};
    _exit(setrlimit(RLIMIT_AS, &limited) != 0 ? 255 : static_cast<int>(std::min<std::size_t>(free_memory() >> 20, 254)));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WEXITSTATUS(status);
}

TEST(FreeMemory, HeedsTheLimitOfTheAddressSpace) {
  // The test itself is linked to libraries of less than 800 MB.
  EXPECT_LT(left_within(rlim_t{200} << 20), 200);
  EXPECT_GT(left_within(rlim_t{1000} << 20), left_within(rlim_t{200} << 20));
}

}  // namespace
}  // namespace mdana
