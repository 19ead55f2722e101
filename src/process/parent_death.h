#pragma once

#include <sys/types.h>

/// What is to end where the process that started it was ended by a signal that nothing can catch (kill -9, a lack of
/// memory). On Linux; elsewhere these do nothing.
namespace tumble::process {

/// From now on, the end of our parent kills (SIGKILL) every process of our group, us included. parent: the parent's
/// number, asked before the fork. Precondition: this process leads its group.
void end_group_with_parent(pid_t parent);

/// While this exists, the end of this process kills (SIGKILL) every process of a group: also programs that the group's
/// first one started. A process beside us waits for that. Precondition: the thread that makes this outlives it.
class GroupGuard {
 public:
  explicit GroupGuard(pid_t group);
  ~GroupGuard();
  GroupGuard(const GroupGuard&) = delete;
  GroupGuard& operator=(const GroupGuard&) = delete;

 private:
  pid_t guard_ = -1;
};

}  // namespace tumble::process
