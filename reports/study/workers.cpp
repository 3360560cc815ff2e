// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/workers.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "analyses/frame_run.hpp"

namespace mdana {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_told = 4000;  ///< bytes of a reason: a pipe holds them without a reader
constexpr auto look_again = std::chrono::milliseconds(3);
constexpr int stopped_status = 75;  ///< of a process whose work a signal has stopped

struct Worker {
  std::size_t index;
  pid_t process;
  int reason;  ///< end of a pipe that is read
  Clock::time_point start;
};

/// Why the work failed; empty if it did not. In the process of the work.
std::string reason_of(const Work& work) {
  try {
    work();
    return {};
  } catch (const Interrupted&) {
    ::_exit(stopped_status);
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& error) {
    const std::string what = error.what();
    return what.empty() ? "failed" : what;
  }
}

[[noreturn]] void be_worker(const Work& work, int pipe, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(EXIT_FAILURE);  // it was killed before that
  ::close_range(STDERR_FILENO + 1, static_cast<unsigned>(pipe) - 1, 0);  // files of the parent, and its locks
  ::close_range(static_cast<unsigned>(pipe) + 1, ~0u, 0);
  const std::string reason = reason_of(work).substr(0, most_told);
  if (reason.empty()) ::_exit(EXIT_SUCCESS);
  const auto written = ::write(pipe, reason.data(), reason.size());
  ::_exit(written < 0 ? EXIT_FAILURE + 1 : EXIT_FAILURE);
}

Worker start(const Work& work, std::size_t index) {
  int pipe[2];
  if (::pipe(pipe) != 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  std::cout.flush();
  const pid_t parent = ::getpid(), process = ::fork();
  if (process < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (process == 0) {
    ::close(pipe[0]);
    be_worker(work, pipe[1], parent);
  }
  ::close(pipe[1]);
  return {index, process, pipe[0], Clock::now()};
}

std::string told(int pipe) {
  std::string text(most_told, '\0');
  const auto got = ::read(pipe, text.data(), text.size());
  ::close(pipe);
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return text;
}

WorkDone result_of(const Worker& worker, int status) {
  WorkDone done{worker.index, told(worker.reason), std::chrono::duration<double>(Clock::now() - worker.start).count()};
  if (WIFSIGNALED(status))
    done.failure = fmt::format("the analysis was ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  else if (WEXITSTATUS(status) != EXIT_SUCCESS && done.failure.empty())
    done.failure = "the analysis failed without a reason";
  return done;
}

void end_all(const std::vector<Worker>& workers) {
  for (const Worker& worker : workers) ::kill(worker.process, SIGTERM);
  for (const Worker& worker : workers) {
    while (::waitpid(worker.process, nullptr, 0) < 0 && errno == EINTR) continue;
    ::close(worker.reason);
  }
}

/// A signal to all processes of a group may come to the works first: they have not failed.
[[noreturn]] void end_as_stopped(const std::vector<Worker>& workers, const std::atomic<int>* stop) {
  end_all(workers);
  throw Interrupted(stop && *stop ? stop->load() : SIGTERM);
}

/// Those that ended are told of and taken out.
bool collect(std::vector<Worker>& workers, const std::atomic<int>* stop, const std::function<void(const WorkDone&)>& done) {
  for (auto worker = workers.begin(); worker != workers.end(); ++worker) {
    int status = 0;
    if (::waitpid(worker->process, &status, WNOHANG) <= 0) continue;
    const WorkDone result = result_of(*worker, status);
    workers.erase(worker);
    if (WIFEXITED(status) && WEXITSTATUS(status) == stopped_status) end_as_stopped(workers, stop);
    done(result);
    return true;
  }
  return false;
}

}  // namespace

void run_in_processes(const std::vector<Work>& works, std::size_t jobs, const std::atomic<int>* stop,
                      const std::function<void(const WorkDone&)>& done) {
  std::vector<Worker> workers;
  std::size_t next = 0;
  while (next < works.size() || !workers.empty()) {
    if (stop && *stop) end_as_stopped(workers, stop);
    if (next < works.size() && workers.size() < jobs) {
      workers.push_back(start(works[next], next));
      ++next;
    } else if (!collect(workers, stop, done)) {
      std::this_thread::sleep_for(look_again);
    }
  }
}

}  // namespace mdana
