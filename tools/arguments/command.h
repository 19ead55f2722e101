#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "src/base/result.h"

namespace tumble::tools {

/// The exit status of every command.
enum class Exit : int {
  kSame = 0,          ///< done; the same; passed
  kDifference = 1,    ///< a difference was found
  kBadInput = 2,      ///< bad usage or bad input
  kDamaged = 3,       ///< a file is damaged or torn, even where its whole part is fine
  kCannotFinish = 4,  ///< full disk, memory, a step that fails, an interruption
};

/// The status that goes with an error.
Exit exit_for(const Error& error);

/// What a command does once its arguments are read. Its results go to stdout; an Error is printed by run_program().
using Action = std::function<Result<Exit>()>;

/// One command of the program: one file, cmd_<name>.cc, and one row of run_program.cc's table.
struct Command {
  const char* name;
  const char* summary;  ///< a line for `tumble help`
  /// Declares the arguments and returns what to do with them.
  Action (*declare)(CLI::App& app);
};

Action declare_record(CLI::App& app);
Action declare_replay(CLI::App& app);
Action declare_recover(CLI::App& app);
Action declare_diff(CLI::App& app);
Action declare_info(CLI::App& app);
Action declare_measure(CLI::App& app);
Action declare_dump(CLI::App& app);
Action declare_render(CLI::App& app);
Action declare_import(CLI::App& app);
Action declare_bench(CLI::App& app);
Action declare_scenes(CLI::App& app);
Action declare_bisect(CLI::App& app);
Action declare_check(CLI::App& app);
Action declare_bless(CLI::App& app);

}  // namespace tumble::tools
