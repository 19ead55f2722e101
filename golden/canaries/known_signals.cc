#include <array>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "golden/canaries/known_answers.h"
#include "src/process/interrupt.h"
#include "tumble/process/job_pool.h"
#include "tumble/render/backend.h"
#include "tumble/render/renderer.h"

namespace tumble::golden {
namespace {

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

}  // namespace

std::vector<CanaryResult> run_known_signals() {
  std::vector<CanaryResult> results;
  const auto known = [&results](const char* name, const std::string& wanted, auto ask) {
    process::run_jobs(
        1, [&](std::size_t) { return ask(); },
        [&](std::size_t, const process::JobResult& child) {
          const bool right = child.failure.empty() && child.output == wanted;
          results.push_back({name, right, right ? "as known" : child.failure + child.output});
        },
        {});
  };
  known("signals are taken over and given back",
        "SIGINT handler guard handler nobody; SIGTERM handler guard handler nobody; SIGHUP handler guard handler "
        "nobody; ",
        signals_guarded);
  known("a choice of who draws is the user's", "kept kept",
        [] { return variable_kept(std::string("0")) + " " + variable_kept(std::nullopt); });
  return results;
}

}  // namespace tumble::golden
