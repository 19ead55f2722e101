#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "golden/engine/project.h"
#include "src/base/text.h"
#include "src/process/run_child.h"
#include "tumble/sim/result.h"

/// The engine of a project, built and run as a child process.
namespace tumble::golden {

/// The files of one run, put in the place of {scene}, {inputs} and {log}. Paths are absolute; empty: there is none.
struct RunFiles {
  std::string scene;
  std::string inputs;
  std::string log;
  std::string no_scene;  ///< why there is no scene, for the error where the command wants one
};

/// A command line of the project with the files filled in, as words for the system. Where the project wants a shell,
/// these are sh, -c and the line with the files quoted. Errors (kBadInput): {scene} where there is no scene.
Result<std::vector<std::string>> engine_words(const EngineProject& project, const std::string& command,
                                              const RunFiles& files);

/// The same as one line for a person to type, from the folder of the project.
std::string engine_words_text(const std::vector<std::string>& words);

/// Runs the build commands of a project. output: a file for what they print. Errors (kCannotFinish): one fails, with
/// the end of its output; an interruption.
Status build_engine(const EngineProject& project, const std::filesystem::path& output,
                    const process::Cancel& cancel = {});

/// The surroundings of a run.
struct RunPlace {
  std::filesystem::path output;                    ///< file for what the engine prints
  std::map<std::string, std::string> environment;  ///< variables that the engine gets besides ours
  bool own_group = true;                           ///< as process::Program has it
  process::Cancel cancel = {};
};

/// Runs the engine once, and rewrites a table that it wrote as the project says (rewrite_table()). Errors:
/// engine_words()'; rewrite_table()'s; kCannotFinish: it does not start, a status other than 0, a signal,
/// the timeout, an interruption; the message has the end of its output.
Status run_project(const EngineProject& project, const std::string& command, const RunFiles& files,
                   const RunPlace& place);

/// "; it printed: …", the end of a file; empty where nothing was printed.
std::string end_of_output(const std::filesystem::path& file);

}  // namespace tumble::golden
