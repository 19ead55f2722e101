#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

/// Child processes: started, waited for, ended and named here alone.
namespace tumble::process {

/// "SIGSEGV"; "signal 77" for one without a name.
std::string signal_name(int number);

/// How a child ended.
struct ChildEnd {
  int exit = -1;         ///< exit status; -1 if a signal ended it
  int signal = 0;        ///< that ended it; 0: none
  bool stopped = false;  ///< by us: the caller asked for it
  bool late = false;     ///< by us: it took too long
  [[nodiscard]] bool well() const { return exit == 0; }
  [[nodiscard]] std::string text() const;  ///< "ended with status 1", "was ended by SIGSEGV", "took too long"
};

/// A shell reports a command that SIGSEGV ended as status 128 + 11. Returns the end of that command.
ChildEnd behind_shell(ChildEnd end);

/// Another program, its arguments and surroundings.
struct Program {
  std::vector<std::string> words;           ///< the program, looked for in PATH, and its arguments; no shell sees them
  std::string folder;                       ///< to run in; empty: the current one
  int in = -1;                              ///< file descriptor of its standard input; −1: nothing to read
  std::string out;                          ///< file that its standard output is added to; empty: ours
  std::string err;                          ///< the same of its standard error; may be the same file
  std::map<std::string, std::string> more;  ///< environment, unless it has them
  std::map<std::string, std::string> set;   ///< environment, whatever it has
  bool own_group = true;  ///< a process group of its own, so that Ctrl-C is for us alone and end_group() ends all of it
};

/// Starts a program. Variables by which git finds its repository are not passed on. Returns 0, or errno of the failure.
/// Precondition: words is not empty.
int start(const Program& program, pid_t& child);

/// Waits until a child ends and frees its number.
ChildEnd wait_for(pid_t child);

/// True, and its end, if a child has ended; does not wait.
bool has_ended(pid_t child, ChildEnd& end);

/// Waits until a child that leads a process group ends, kills what it left behind in the group, and frees its number.
ChildEnd wait_for_group(pid_t child);

/// Sends a signal to every process of the group that `child` leads.
void signal_group(pid_t child, int number);

/// Asks (SIGTERM) every other process of the group that this process leads to end: what a program started that is gone.
/// No effect where it leads none.
void end_own_group();

/// Writes everything; false where the reader is gone.
bool write_all(int file, const char* bytes, std::size_t size);

}  // namespace tumble::process
