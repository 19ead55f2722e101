#pragma once

#include <functional>

#include "tools/arguments/arguments.h"
#include "tools/output/exit.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Runs a command whose arguments are read. Results go to stdout; run_program() prints an Error.
using Action = std::function<Result<Exit>()>;

/// One command of the program: one file, commands/NAME.cc, and one row of run_program.cc's table.
struct Command {
  const char* name;
  const char* summary;  ///< a line for `tumble help`
  /// Declares the arguments and returns the action on them.
  Action (*declare)(Arguments& arguments);
};

Action declare_record(Arguments& arguments);
Action declare_replay(Arguments& arguments);
Action declare_recover(Arguments& arguments);
Action declare_diff(Arguments& arguments);
Action declare_blame(Arguments& arguments);
Action declare_info(Arguments& arguments);
Action declare_measure(Arguments& arguments);
Action declare_dump(Arguments& arguments);
Action declare_render(Arguments& arguments);
Action declare_live(Arguments& arguments);
Action declare_view(Arguments& arguments);
Action declare_export(Arguments& arguments);
Action declare_import(Arguments& arguments);
Action declare_bench(Arguments& arguments);
Action declare_scenes(Arguments& arguments);
Action declare_bisect(Arguments& arguments);
Action declare_check(Arguments& arguments);
Action declare_hunt(Arguments& arguments);
Action declare_bless(Arguments& arguments);

}  // namespace tumble::tools
