// The program `tumble-live`: `tumble live` runs it. It is a program of its own, so that `tumble` starts on machines
// without GLFW and without a display, and loads no graphics driver into the process of any other command.
#include <memory>

#include "tools/arguments/command.h"
#include "tools/arguments/live_options.h"
#include "tools/live/play.h"
#include "tools/run_program.h"

namespace {

tumble::tools::Action declare_play(tumble::tools::Arguments& arguments) {
  auto given = std::make_shared<tumble::tools::LiveArguments>();
  declare_arguments(arguments, *given);
  return [given] { return tumble::tools::play(*given); };
}

}  // namespace

int main(int argc, char** argv) {
  const tumble::tools::Command live = {"live", "the window of 'tumble live'", declare_play};
  return static_cast<int>(tumble::tools::run_command(live, {argv + 1, argv + argc}));
}
