#include "tools/run_program.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/base/text.h"
#include "src/files/part_file.h"
#include "src/files/short_lived_folder.h"
#include "src/process/interrupt.h"
#include "src/process/own_limits.h"
#include "src/world/float_environment.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/manual/completion.h"
#include "tools/manual/man_page.h"
#include "tools/output/clean_streams.h"
#include "tools/output/exit.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

constexpr std::array kCommands = {
    Command{"record", "run a scene and write every input and step to a log", declare_record},
    Command{"live", "play a scene by hand in a window, and log every input", declare_live},
    Command{"replay", "run a log through the physics and compare every step", declare_replay},
    Command{"recover", "make a whole log of the intact parts of a damaged one", declare_recover},
    Command{"diff", "find the first difference between two logs", declare_diff},
    Command{"blame", "find what last changed a value of a body", declare_blame},
    Command{"info", "show what a log holds, and check every byte of it", declare_info},
    Command{"measure", "measure symmetry, energy and stacking of a session", declare_measure},
    Command{"dump", "print bodies at one step or over many, to the last bit", declare_dump},
    Command{"render", "draw pictures and movies of a recorded session", declare_render},
    Command{"view", "look at a session in the browser, step by step", declare_view},
    Command{"check", "run the golden suite and report changes", declare_check},
    Command{"hunt", "judge random scenes by relations and laws, shrink what fails", declare_hunt},
    Command{"bisect", "find the commit that changed a session", declare_bisect},
    Command{"bless", "accept the present results of cases as goldens", declare_bless},
    Command{"import", "make a log of another engine's session", declare_import},
    Command{"export", "write a session in the formats of other programs", declare_export},
    Command{"bench", "measure speed and growth, compare with other engines", declare_bench},
    Command{"scenes", "list the scenes that can be recorded by name", declare_scenes},
};

ManualEntry manual_entry(const Command& command) {
  Arguments arguments(std::string("tumble ") + command.name, command.summary);
  command.declare(arguments);
  return {command.name, command.summary, arguments.listed(), arguments.footer()};
}

std::vector<ManualEntry> manual() {
  std::vector<ManualEntry> entries;
  entries.reserve(kCommands.size());
  for (const Command& command : kCommands) entries.push_back(manual_entry(command));
  return entries;
}

const Command* find_command(std::string_view name) {
  for (const Command& command : kCommands) {
    if (name == command.name) return &command;
  }
  return nullptr;
}

std::string overview() {
  std::string text =
      "tumble: rigid bodies, recorded and replayed bit for bit\n\n"
      "Usage: tumble COMMAND [OPTIONS]\n\nCommands:\n";
  for (const Command& command : kCommands) text += "  " + padded(command.name, 10) + command.summary + '\n';
  return text +
         "\ntumble help COMMAND explains a command, with examples; tumble --version prints the version.\n\n"
         "Exit status: 0 same or done, 1 difference found, 2 bad usage or input, 3 file damaged or torn,\n"
         "             4 could not finish\n\n"
         "Example: tumble record brick_wall && tumble replay brick_wall.tumble\n";
}

// "tumble record: message" on stderr.
Exit fail(const std::string& who, const std::string& message, Exit exit) {
  std::cerr << who << ": " << message << '\n';
  return exit;
}

Exit unknown_command(const std::string& name) {
  std::vector<std::string_view> names;
  names.reserve(kCommands.size());
  for (const Command& command : kCommands) names.emplace_back(command.name);
  const std::string_view nearest = nearest_word(name, names);
  const std::string hint = nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?";
  return fail("tumble", "unknown command " + in_quotes(name) + hint + "\n'tumble help' lists the commands.",
              Exit::kBadInput);
}

// The surroundings in which every command can do its work, and its arithmetic has the bits that it promises.
Status check_surroundings() {
  if (Status ok = process::check_own_limits(); !ok.ok()) return ok;
  return sim::check_float_environment();
}

Exit run_words(const Command& command, const std::vector<std::string>& words) {
  const std::string who = std::string("tumble ") + command.name;
  Arguments arguments(who, command.summary);
  const Action action = command.declare(arguments);
  const Reading reading = arguments.read(words);
  if (reading.kind == Reading::Kind::kHelp) {
    std::cout << reading.text;
    return Exit::kSame;
  }
  if (reading.kind == Reading::Kind::kWrong) {
    return fail(who, reading.text + "\n'" + who + " --help' explains the arguments.", Exit::kBadInput);
  }
  if (const Status ok = check_surroundings(); !ok.ok()) return fail(who, ok.error().message, exit_for(ok.error()));
  const process::InterruptExit interrupts(who + ": interrupted", static_cast<int>(Exit::kCannotFinish), [] {
    files::remove_parts();
    files::remove_short_lived_folders();
  });
  const Result<Exit> result = action();
  if (!result.ok()) return fail(who, result.error().message, exit_for(result.error()));
  return *result;
}

// `tumble help --man [COMMAND]` and `tumble help --completion SHELL`: what an installation needs, made of the arguments
// that the commands declare.
Exit print_manual(const std::vector<std::string>& words) {
  const std::string who = "tumble help " + words.front();
  if (words.front() == "--completion") {
    const Result<std::string> script = completion(manual(), words.size() == 2 ? words[1] : "");
    if (!script.ok()) return fail(who, script.error().message, Exit::kBadInput);
    std::cout << *script;
    return Exit::kSame;
  }
  if (words.size() > 2) return fail(who, found_wanted(in_quotes(words[2]), "one command"), Exit::kBadInput);
  if (words.size() == 1) {
    std::cout << man_page_of_program(manual(), TUMBLE_VERSION);
    return Exit::kSame;
  }
  const Command* command = find_command(words[1]);
  if (command == nullptr) return unknown_command(words[1]);
  std::cout << man_page(manual_entry(*command), TUMBLE_VERSION);
  return Exit::kSame;
}

Exit run(std::vector<std::string> arguments) {
  if (arguments.empty()) {
    std::cerr << overview();
    return Exit::kBadInput;
  }
  const std::string first = arguments.front();
  arguments.erase(arguments.begin());
  if (first == "--version") {
    std::cout << "tumble " TUMBLE_VERSION "\n";
    return Exit::kSame;
  }
  const bool is_help = first == "help" || first == "--help" || first == "-h";
  if (is_help && arguments.empty()) {
    std::cout << overview();
    return Exit::kSame;
  }
  if (is_help && (arguments.front() == "--man" || arguments.front() == "--completion")) return print_manual(arguments);
  const std::string name = is_help ? arguments.front() : first;
  if (is_help) arguments = {"--help"};
  const Command* command = find_command(name);
  return command == nullptr ? unknown_command(name) : run_words(*command, arguments);
}

// True where standard output is a pipe that its reader has closed, as `head` does.
bool reader_is_gone() {
  pollfd out = {STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

// As every program ends whose reader has gone, also one that ignored the signal for the sake of its own children.
void end_by_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  static_cast<void>(std::raise(SIGPIPE));
}

// Exceptions of libraries end here, and outputs are flushed.
Exit run_safely(const std::function<Exit()>& run) {
  const CleanStream out(std::cout);
  const CleanStream err(std::cerr);
  try {
    const Exit exit = run();
    std::cout.flush();
    if (!std::cout && reader_is_gone()) end_by_pipe();
    if (!std::cout)
      return fail("tumble", "standard output could not be written (closed, or its disk is full)", Exit::kCannotFinish);
    return exit;
  } catch (const std::bad_alloc&) {
    return fail("tumble", "out of memory", Exit::kCannotFinish);
  } catch (const std::exception& error) {
    return fail("tumble", std::string("internal error: ") + error.what(), Exit::kCannotFinish);
  }
}

}  // namespace

Exit run_program(std::vector<std::string> arguments) {
  return run_safely([&] { return run(std::move(arguments)); });
}

Exit run_command(const Command& command, const std::vector<std::string>& words) {
  return run_safely([&] { return run_words(command, words); });
}

}  // namespace tumble::tools
