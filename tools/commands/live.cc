// tumble live: a session that is played by hand in a window. The window is a program of its own, tumble-live.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/arguments/command.h"
#include "tools/arguments/live_options.h"
#include "tools/files/helper_program.h"

namespace tumble::tools {
namespace {

// Replaces this process: Ctrl-C, the exit status and the outputs are then the window's own.
Result<Exit> run_window(const LiveArguments& arguments) {
  const std::string helper = helper_program("tumble-live");
  if (helper.empty()) {
    return cannot_finish(
        "no window, because tumble-live is not beside tumble; install the package tumble-live, or libglfw3-dev and "
        "libimgui-dev "
        "and build again; 'tumble view LOG -o FILE.html' shows a recorded session in a browser");
  }
  std::vector<std::string> words = words_of(arguments);
  words.insert(words.begin(), helper);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(helper.c_str(), pointers.data());
  return cannot_finish(helper + ": " + std::strerror(errno));
}

}  // namespace

Action declare_live(Arguments& arguments) {
  auto given = std::make_shared<LiveArguments>();
  declare_arguments(arguments, *given);
  return [given] { return run_window(*given); };
}

}  // namespace tumble::tools
