#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "golden/canaries/known_answers.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/process/child.h"
#include "src/process/child_pipe.h"
#include "src/process/interrupt.h"
#include "src/process/run_child.h"
#include "tumble/process/job_pool.h"
#include "tumble/render/backend.h"
#include "tumble/render/renderer.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

// Scripts use what the shell itself can do, so that no PATH, variable or right of the user decides.
constexpr const char* kShell = "/bin/sh";

// A place of the scratch folder as "/…", whatever the folder is called.
std::string without(std::string text, const fs::path& folder) {
  const std::string name = folder.string();
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;) text.erase(at, name.size());
  return text;
}

// How a program of the shell ends, and what it wrote.
std::string run_script(const fs::path& folder, const std::string& script, double timeout_s = 0,
                       const process::Cancel& cancel = {}) {
  process::Program program;
  program.words = {kShell, "-c", script};
  program.folder = folder.string();
  program.out = program.err = (folder / "said").string();
  program.more = {{"TUMBLE_MORE", "more"}};
  program.set = {{"TUMBLE_SET", "set"}, {"TZ", "UTC"}};
  const Result<process::ChildEnd> end = process::run_child(program, timeout_s, cancel);
  if (!end.ok()) return end.error().message;
  const process::ChildEnd known = process::behind_shell(*end);
  const Result<std::string> said = read_text(folder / "said");
  return known.text() + (known.stopped ? ", stopped" : "") + (known.well() ? ", well" : "") +
         (said.ok() && !said->empty() ? ": " + *said : "") + "; ";
}

std::string script_ends(const fs::path& folder) {
  std::string found = run_script(folder, "printf \"$TUMBLE_MORE $TUMBLE_SET $TZ\"");
  found += run_script(folder, "printf err >&2; exit 3");
  found += run_script(folder, "kill -TERM $$");
  found += run_script(folder, "exit 139");
  found += run_script(folder, "exit 255");
  found += run_script(folder, "while :; do :; done", 0.05);
  found += run_script(folder, "while :; do :; done", 0, [] { return true; });
  process::Program nobody;
  nobody.words = {(folder / "none").string()};
  const Result<process::ChildEnd> none = process::run_child(nobody);
  return found + (none.ok() ? "started" : without(none.error().message, folder));
}

std::string text_piped(const fs::path& folder) {
  process::ChildPipe pipe;
  const std::string place = (folder / "piped").string(), errors = (folder / "errors").string();
  // $0 is the place.
  const std::string script = "IFS= read -r x; printf %s \"$x\" > \"$0\"; echo why >&2";
  if (const Status ok = pipe.start({kShell, "-c", script, place}, "a movie", "sh", errors); !ok.ok())
    return ok.error().message;
  const std::string text = "abc";
  std::string found = pipe.running() && pipe.write(std::as_bytes(std::span(text))) ? "written, " : "not written, ";
  found += pipe.finish() ? "well: " : "not well: ";
  for (const std::string& file : {place, errors}) {
    const Result<std::string> text_there = read_text(file);
    found += text_there.ok() ? *text_there : "nothing";
  }
  if (pipe.start({kShell, "-c", "exit 1"}, "a movie", "sh", errors).ok()) found += pipe.finish() ? "well" : "failed";
  const Status none = pipe.start({(folder / "none").string()}, "a movie", "its-package", errors);
  return found + (none.ok() ? ", started" : ", " + without(none.error().message, folder)) +
         process::last_words("one\ntwo\n\n") + process::last_words("");
}

std::string jobs_pooled() {
  using namespace std::chrono_literals;
  std::string found;
  const auto done = [&found](std::size_t, const process::JobResult& job) { found += job.output + job.failure + "; "; };
  process::PoolOptions options;
  process::run_jobs(
      3, [](std::size_t k) { return "job " + std::to_string(k); }, done, options);
  process::run_jobs(
      1, [](std::size_t) -> std::string { throw std::runtime_error("why"); }, done, options);
  options.timeout_s = 0.05;
  const auto sleep = [](std::size_t) {
    std::this_thread::sleep_for(60s);
    return std::string("late");
  };
  process::run_jobs(1, sleep, done, options);
  options.timeout_s = 600;
  options.cancel = [] { return true; };
  found += process::run_jobs(2, sleep, done, options) ? "ended" : "cancelled";
  return found;
}

volatile std::sig_atomic_t told_signal = 0;

void tell_signal(int number) { told_signal = number; }

constexpr std::array kGuarded = {std::pair{SIGINT, "SIGINT"}, std::pair{SIGTERM, "SIGTERM"},
                                 std::pair{SIGHUP, "SIGHUP"}};

// Sends a signal to this process: who was told of it.
std::string sent(int number) {
  told_signal = 0;
  static_cast<void>(std::raise(number));
  return told_signal == number ? "handler" : process::InterruptGuard::interrupted() ? "guard" : "nobody";
}

// Each signal before a guard exists, while it exists and after, with a handler of the caller's; and where the caller
// ignores it. In a process of its own, whose handlers are nobody's.
std::string signals_guarded() {
  std::string found;
  for (const auto& [number, name] : kGuarded) std::signal(number, tell_signal);
  for (const auto& [number, name] : kGuarded) {
    found += name + (" " + sent(number));
    {
      const process::InterruptGuard guard;
      found += " " + sent(number);
    }
    {
      const process::InterruptGuard next;
      found += process::InterruptGuard::interrupted() ? " still" : "";
    }
    found += " " + sent(number);
    std::signal(number, SIG_IGN);
    {
      const process::InterruptGuard guard;
      found += " " + sent(number);
    }
    std::signal(number, tell_signal);
    found += "; ";
  }
  return found;
}

// What drawing off-screen leaves of the variable by which a user chooses who draws.
std::string variable_kept(const std::optional<std::string>& value) {
  constexpr const char* kVariable = "LIBGL_ALWAYS_SOFTWARE";
  if (value) {
    ::setenv(kVariable, value->c_str(), 1);
  } else {
    ::unsetenv(kVariable);
  }
  const auto renderer = render::Renderer::create({64, 48, 1, {}}, render::Backend::kEgl);
  const char* const after = std::getenv(kVariable);
  if (after == nullptr) return value ? "taken away" : "kept";
  if (!value) return after == std::string_view("1") ? "kept" : after;
  return after == *value ? "kept" : after;
}

// Asked of the shell, in a folder of its own.
template <class Find>
auto of_shell(Find find, std::string_view wanted) {
  return [find, wanted]() -> CanaryResult {
    if (::access(kShell, X_OK) != 0) return not_asked("this machine has no /bin/sh");
    const TemporaryFolder scratch("tumble-canary");
    const std::string found = scratch.path().empty() ? "no temporary folder could be made" : find(scratch.path());
    return {"", found == wanted, found == wanted ? "as known" : found};
  };
}

// In a process of its own, whose signals and variables are nobody's.
template <class Find>
auto apart(Find find) {
  return [find] {
    std::string found;
    process::run_jobs(
        1, [find](std::size_t) -> std::string { return find(); },
        [&found](std::size_t, const process::JobResult& child) { found = child.failure + child.output; }, {});
    return found;
  };
}

}  // namespace

void run_known_processes(CanaryRoll& roll) {
  roll.ask(
      "a program that ends is told by its end",
      of_shell(script_ends,
               "ended with status 0, well: more set UTC; ended with status 3: err; was ended by SIGTERM; was ended "
               "by SIGSEGV; ended with status 255; took too long; was ended by SIGTERM, stopped; /none cannot be "
               "started: No such file or directory"));
  roll.ask("a program reads what is written to it",
           of_shell(text_piped,
                    "written, well: abcwhy\nfailed, a movie need /none, which is not installed (Debian: apt-get "
                    "install its-package): two, and it said nothing; is the disk full?"));
  roll.known("a job that fails harms no other", jobs_pooled,
             "job 0; job 1; job 2; ended with status 97 before it was done; took longer than 0 s; cancelled");
  roll.known("signals are taken over and given back", apart(signals_guarded),
             "SIGINT handler guard handler nobody; SIGTERM handler guard handler nobody; SIGHUP handler guard handler "
             "nobody; ");
  roll.known("a choice of who draws is the user's",
             apart([] { return variable_kept("0") + " " + variable_kept(std::nullopt); }), "kept kept");
}

}  // namespace tumble::golden
