#include "src/process/own_limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <string>

namespace tumble::process {
namespace {

constexpr rlim_t kStackMin = rlim_t{256} << 10;  // bytes; `check` of the suite needs half of that
constexpr rlim_t kStackUsual = rlim_t{8} << 20;

}  // namespace

Status check_own_limits() {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit stack = {};
  if (::getrlimit(RLIMIT_STACK, &stack) == 0 && stack.rlim_cur != RLIM_INFINITY && stack.rlim_cur < kStackMin) {
    return cannot_finish("found a stack of " + std::to_string(stack.rlim_cur >> 10U) + " KiB, wanted " +
                         std::to_string(kStackMin >> 10U) + " KiB or more; run 'ulimit -s " +
                         std::to_string(kStackUsual >> 10U) + "' first");
  }
  std::array<char, PATH_MAX> folder = {};
  if (::getcwd(folder.data(), folder.size()) == nullptr && errno == ENOENT) {
    return cannot_finish("the current folder was removed; change to a folder that exists");
  }
  return {};
}

}  // namespace tumble::process
