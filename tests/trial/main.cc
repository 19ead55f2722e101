// damage_trial flips TRIALS SEED LOG...                  trials, shared out so that each log takes about the same time
// damage_trial kills COUNT SEED PROGRAM SCENE FOLDER
// Exit status: 0 nothing undetected and nothing lost, 1 something was, 2 bad usage or a log that is not whole.
#include <charconv>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "tests/trial/trial.h"

namespace tumble::trial {
namespace {

std::optional<std::uint64_t> number(const std::string& text) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

int report(const Counts& counts) {
  for (const std::string& failure : counts.failures) std::cerr << "damage_trial: " << failure << '\n';
  std::cout << counts.trials << " trials, " << counts.recoveries << " of them recovered: " << counts.undetected
            << " undetected, " << counts.lost << " complete chunks lost\n";
  return counts.undetected == 0 && counts.lost == 0 ? 0 : 1;
}

int fail(const std::string& message) {
  std::cerr << "damage_trial: " << message << '\n';
  return 2;
}

int flips(std::uint64_t trials, std::uint64_t seed, const std::vector<std::string>& logs) {
  double weights = 0;
  const auto weight = [](const std::string& log) {
    std::error_code ignored;
    return 1.0 / (2000.0 + static_cast<double>(std::filesystem::file_size(log, ignored)));
  };
  for (const std::string& log : logs) weights += weight(log);
  Counts all;
  for (const std::string& log : logs) {
    const auto share = static_cast<std::uint64_t>(static_cast<double>(trials) * weight(log) / weights) + 1;
    const Result<Counts> counts = flip_and_cut(log, share, seed++);
    if (!counts.ok()) return fail(counts.error().message);
    all.trials += counts->trials;
    all.undetected += counts->undetected;
    all.lost += counts->lost;
    all.recoveries += counts->recoveries;
    for (const std::string& failure : counts->failures) {
      all.failures.push_back(log);
      all.failures.back() += ": " + failure;
    }
  }
  return report(all);
}

int run(const std::vector<std::string>& words) {
  const std::optional<std::uint64_t> trials = words.size() > 1 ? number(words[1]) : std::nullopt;
  const std::optional<std::uint64_t> seed = words.size() > 2 ? number(words[2]) : std::nullopt;
  if (trials && seed && words[0] == "flips" && words.size() > 3) {
    return flips(*trials, *seed, {words.begin() + 3, words.end()});
  }
  if (trials && seed && words[0] == "kills" && words.size() == 6) {
    const Result<Counts> counts = kill_recorders(words[3], words[4], *trials, *seed, words[5]);
    return counts.ok() ? report(*counts) : fail(counts.error().message);
  }
  return fail("usage: damage_trial flips TRIALS SEED LOG... | kills COUNT SEED PROGRAM SCENE FOLDER");
}

}  // namespace
}  // namespace tumble::trial

int main(int argc, char** argv) { return tumble::trial::run({argv + 1, argv + argc}); }
