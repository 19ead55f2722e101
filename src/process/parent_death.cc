#include "src/process/parent_death.h"

#include "src/base/check.h"

#ifdef __linux__
#include <sys/prctl.h>
#include <unistd.h>

#include <climits>
#include <csignal>

#include "src/process/child.h"
#endif

namespace tumble::process {

#ifdef __linux__
namespace {

constexpr int kParentEnded = SIGUSR1;  // the system sends it to us; Tumble has no other use for it

void kill_own_group(int /*number*/) { ::kill(0, SIGKILL); }

/// Runs in the guard, a copy of a process that may have had other threads: calls nothing but the system.
[[noreturn]] void wait_for_parents_end(pid_t parent, pid_t group, const sigset_t& awaited) {
  ::setpgid(0, 0);               // the end of our group, where we are a job of a pool, is not the guard's
  ::close_range(0, INT_MAX, 0);  // a pipe that we hold open would never end for its reader
  ::prctl(PR_SET_PDEATHSIG, kParentEnded);
  int number = 0;
  while (::getppid() == parent) ::sigwait(&awaited, &number);
  ::kill(-group, SIGKILL);
  ::_exit(0);
}

}  // namespace

void end_group_with_parent(pid_t parent) {
  SIM_CHECK(::getpgrp() == ::getpid());
  std::signal(kParentEnded, kill_own_group);
  ::prctl(PR_SET_PDEATHSIG, kParentEnded);
  if (::getppid() != parent) kill_own_group(kParentEnded);  // it ended before we asked
}

GroupGuard::GroupGuard(pid_t group) {
  SIM_CHECK(group > 1, group);
  sigset_t all, awaited, before;
  sigfillset(&all);
  sigemptyset(&awaited);
  sigaddset(&awaited, kParentEnded);
  const pid_t parent = ::getpid();
  ::pthread_sigmask(SIG_SETMASK, &all, &before);  // Ctrl-C ends us first, and then the guard's group
  guard_ = ::fork();
  if (guard_ == 0) wait_for_parents_end(parent, group, awaited);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

GroupGuard::~GroupGuard() {
  if (guard_ < 0) return;
  ::kill(guard_, SIGKILL);
  wait_for(guard_);
}
#else
void end_group_with_parent(pid_t /*parent*/) {}

GroupGuard::GroupGuard(pid_t /*group*/) {}

GroupGuard::~GroupGuard() { static_cast<void>(guard_); }
#endif

}  // namespace tumble::process
