// same_trial memory PAIRS SEED                    pairs of logs through the functions behind diff, replay and bisect
// same_trial program PAIRS SEED PROGRAM FOLDER    and through the program, which is started for each
// Random logs, random damage, random changes: "same" means equal bits of all that the answer speaks of, "different"
// names a field that differs with both values, and damage goes before both. Exit status: 0 no answer was wrong, 1 one
// was, 2 bad usage.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "replay/format/not_finite.h"
#include "replay/log/byte_memory.h"
#include "src/process/run_child.h"
#include "tests/trial/random_sessions.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/replayer.h"

namespace tumble::trial {
namespace {

using replay::LogReader;

constexpr std::size_t kSessions = 200;  // made once; every pair begins with one of them
constexpr std::size_t kFailuresShown = 10;

/// A session, and its whole logs by the length of a chunk, written when they are first asked for.
struct Recorded {
  RandomSession session;
  std::map<std::uint64_t, std::vector<std::byte>> logs;

  const std::vector<std::byte>& log(std::uint64_t chunk) {
    std::vector<std::byte>& bytes = logs[chunk];
    if (bytes.empty()) bytes = log_of(session, chunk, {});
    return bytes;
  }
};

struct Pair {
  const RandomSession* a = nullptr;
  RandomSession b;
  std::vector<std::byte> log_a, log_b;
  std::uint64_t chunk_a = 1, chunk_b = 1;
  bool damaged = false;
  bool all_states = true;
  std::string what;
};

Pair pair_of_logs(std::vector<Recorded>& sessions, Dice& dice) {
  Pair pair;
  Recorded& recorded = sessions[dice.below(sessions.size())];
  pair.a = &recorded.session;
  pair.b = *pair.a;
  pair.what = "nothing";
  if (dice.below(3) != 0) pair.what = change(pair.b, dice);
  pair.chunk_a = 1 + dice.below(pair.a->steps.size());
  pair.chunk_b = 1 + dice.below(pair.a->steps.size());
  const std::array<std::uint32_t, 4> every = {1, 1, 1, static_cast<std::uint32_t>(2 + dice.below(4))};
  const std::uint32_t states = every[dice.below(every.size())];
  pair.all_states = states == 1;
  pair.log_a = recorded.log(pair.chunk_a);
  const bool is_known = pair.what == "nothing" && pair.all_states;
  pair.log_b = is_known ? recorded.log(pair.chunk_b) : log_of(pair.b, pair.chunk_b, {states});
  pair.damaged = dice.below(4) == 0;
  if (!pair.damaged) return pair;
  std::vector<std::byte>& bytes = dice.below(2) == 0 ? pair.log_a : pair.log_b;
  const std::uint64_t at = dice.below(bytes.size());
  bytes[at] ^= static_cast<std::byte>(1U << dice.below(8));
  pair.what += ", and byte " + std::to_string(at) + " flipped";
  return pair;
}

/// Whether all that the two logs hold is equal to the bit.
bool is_equal(const Pair& pair) {
  return equal_bits(*pair.a, pair.b) && equal_hidden(*pair.a, pair.chunk_a, pair.b, pair.chunk_b);
}

constexpr double kLoose = 1e-6;

/// Whether every visible component of both sessions is within `limit`, orientations as turns.
bool is_close(const Pair& pair, double limit) {
  if (pair.a->steps.size() != pair.b.steps.size()) return false;
  for (std::size_t k = 0; k < pair.b.steps.size(); ++k) {
    replay::BodyStates in_a, in_b;
    replay::copy_visible(pair.a->steps[k].after.bodies, in_a);
    replay::copy_visible(pair.b.steps[k].after.bodies, in_b);
    const replay::Columns one = replay::columns_of(in_a), other = replay::columns_of(in_b);
    for (std::size_t i = 0; i < in_a.size(); ++i) {
      double turn = 0, opposite = 0;  // of q to its other self, and to that one's negative
      for (std::size_t c = 0; c < replay::kColumnCount; ++c) {
        const double x = (*one[c])[i], y = (*other[c])[i];
        if (c < replay::kOrientation && !(std::fabs(x - y) <= limit)) return false;
        if (c < replay::kOrientation) continue;
        turn = replay::largest(turn, std::fabs(x - y));
        opposite = replay::largest(opposite, std::fabs(x + y));
      }
      if (!(std::min(turn, opposite) <= limit)) return false;
    }
  }
  return true;
}

Result<LogReader> open(const std::vector<std::byte>& bytes) {
  return LogReader::open(
      std::make_unique<replay::MemoryByteSource>(std::make_shared<std::vector<std::byte>>(bytes), "log"));
}

/// A difference names a field, and its two values are not one.
bool names_a_field(const replay::Divergence& first) {
  return !first.field.empty() && !replay::same_bits(first.expected, first.actual);
}

std::string judge_diff(const Pair& pair, LogReader& a, LogReader& b, replay::Reading reading) {
  const Result<replay::DiffReport> report = replay::diff_logs(a, b, {}, {}, reading);
  const bool sound = a.condition().sound() && b.condition().sound();  // else the command ends with status 3
  if (pair.damaged) {
    if (!report.ok()) return report.error().kind == ErrorKind::kDamaged ? "" : "damage is called something else";
    if (!sound) return "";
    const auto& left_out = report->scope.not_compared;
    const bool said = std::ranges::any_of(
        left_out, [](const std::string& line) { return line.find("not read") != std::string::npos; });
    return reading == replay::Reading::kHashes && said ? "" : "damage is not seen";
  }
  if (!report.ok()) return "refused: " + report.error().message;
  if (report->first) return names_a_field(*report->first) && !is_equal(pair) ? "" : "different, and nothing is";
  if (!report->identical()) return pair.a->steps.size() != pair.b.steps.size() ? "" : "another length, and it is not";
  if (reading == replay::Reading::kHashes) return equal_bits(*pair.a, pair.b) ? "" : "same by hashes, and it is not";
  return is_equal(pair) ? "" : "same, and it is not";
}

std::string judge_tolerances(const Pair& pair, LogReader& a, LogReader& b) {
  replay::Tolerances loose;
  loose.position = loose.orientation = loose.velocity = loose.spin = kLoose;
  const Result<replay::DiffReport> report = replay::diff_logs(a, b, loose);
  if (pair.damaged) {
    const bool sound = a.condition().sound() && b.condition().sound();
    return !sound || (!report.ok() && report.error().kind == ErrorKind::kDamaged) ? ""
                                                                                  : "tolerated: damage is not seen";
  }
  if (!report.ok()) {  // states that a log does not hold
    return !pair.all_states && report.error().kind == ErrorKind::kBadInput ? ""
                                                                           : "tolerated: " + report.error().message;
  }
  if (report->identical()) return is_close(pair, kLoose) ? "" : "same within tolerances, and it is not";
  const bool in_number =
      report->first && replay::is_in_state(*report->first) && std::holds_alternative<double>(report->first->expected);
  // A turn may be some times as large as the largest difference of a component.
  if (in_number && is_close(pair, kLoose / 10))
    return "tolerated: different, and every state is within tolerances: " + describe(*report->first);
  return !report->first || names_a_field(*report->first) ? "" : "tolerated: a difference without a field";
}

std::string judge_replay(const Pair& pair, LogReader& b) {
  const Result<replay::ReplayReport> report = replay::replay_log(b);
  if (!report.ok())
    return pair.damaged && report.error().kind == ErrorKind::kDamaged ? "" : "replay: " + report.error().message;
  if (pair.damaged) return "";  // of the other log, or behind a difference, which the command reads to its end
  for (std::size_t k = 0; k < std::min(pair.a->steps.size(), pair.b.steps.size()); ++k) {
    if (pair.b.steps[k].inputs != pair.a->steps[k].inputs) return "";  // its replay is not known here
  }
  // The session of A is the replay of B, as far as B goes.
  RandomSession wanted = *pair.a;
  wanted.steps.resize(std::min(wanted.steps.size(), pair.b.steps.size()));
  const bool same = equal_bits(wanted, pair.b) && equal_hidden(wanted, pair.chunk_b, pair.b, pair.chunk_b);
  if (!report->first) return same ? "" : "replay: identical, and it is not";
  return same || report->first->field.empty() ? "replay: different, and nothing is" : "";
}

/// One of the answers about the pair, chosen at random.
std::string judge_pair(const Pair& pair, Dice& dice) {
  Result<LogReader> a = open(pair.log_a), b = open(pair.log_b);
  for (const Result<LogReader>* log : {&a, &b}) {
    if (log->ok()) continue;
    const bool in_header = pair.damaged && log->error().kind != ErrorKind::kCannotFinish;
    return in_header ? "" : "not opened: " + log->error().message;
  }
  switch (dice.below(6)) {
    case 0:
      return judge_tolerances(pair, *a, *b);
    case 1:
      return judge_replay(pair, *b);
    case 2:
      return judge_diff(pair, *a, *b, replay::Reading::kHashes);
    default:  // behind diff and bisect
      return judge_diff(pair, *a, *b, replay::Reading::kAll);
  }
}

/// The program's answer about two files: exit status and JSON.
class Program {
 public:
  Program(std::string program, std::string folder) : program_(std::move(program)), folder_(std::move(folder)) {}

  std::string judge_pair(const Pair& pair, Dice& dice) const {
    write("a.tumble", pair.log_a);
    write("b.tumble", pair.log_b);
    const std::array<std::vector<std::string>, 3> all = {{{"diff", "a.tumble", "b.tumble", "--json"},
                                                          {"bisect", "a.tumble", "b.tumble", "--json"},
                                                          {"diff", "a.tumble", "b.tumble", "--brief", "--json"}}};
    const std::size_t chosen = dice.below(all.size());
    const int exit = run(all[chosen]);
    if (pair.damaged && exit == 3) return "";
    const nlohmann::json json = nlohmann::json::parse(std::ifstream(folder_ + "/out"), nullptr, false);
    if (pair.damaged) {
      if (exit == 2) return "";  // a header that is no log's any more
      return chosen == 2 && json.value("read", "").ends_with("payloads not read")
                 ? ""
                 : "status " + std::to_string(exit) + " for damage";
    }
    if (!json.is_object() || json.value("identical", exit != 0) != (exit == 0)) return "JSON and status contradict";
    if (exit == 0) return (chosen == 2 ? equal_bits(*pair.a, pair.b) : is_equal(pair)) ? "" : "same, and it is not";
    if (exit != 1) return "status " + std::to_string(exit);
    const bool by_length = pair.a->steps.size() != pair.b.steps.size();
    const bool named = json["first"].is_object() && (json["first"]["expected"] != json["first"]["actual"] ||
                                                     json["first"]["expected_hex"] != json["first"]["actual_hex"]);
    return (named || by_length) && !is_equal(pair) ? "" : "different, and no field is named";
  }

 private:
  void write(const std::string& name, const std::vector<std::byte>& bytes) const {
    std::ofstream file(folder_ + '/' + name, std::ios::binary);
    for (const std::byte b : bytes) file.put(static_cast<char>(b));
  }

  [[nodiscard]] int run(const std::vector<std::string>& words) const {
    process::Program task;
    task.words = {program_};
    task.words.insert(task.words.end(), words.begin(), words.end());
    task.folder = folder_;
    task.out = folder_ + "/out";
    task.err = folder_ + "/err";
    const Result<process::ChildEnd> end = process::run_child(task, 0, {});
    return end.ok() && !end->late ? end->exit : -1;
  }

  std::string program_;
  std::string folder_;
};

std::optional<std::uint64_t> number(const std::string& text) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

int run(const std::vector<std::string>& words) {
  const std::optional<std::uint64_t> pairs = words.size() > 2 ? number(words[1]) : std::nullopt;
  const std::optional<std::uint64_t> seed = words.size() > 2 ? number(words[2]) : std::nullopt;
  const bool in_memory = pairs && seed && words[0] == "memory" && words.size() == 3;
  if (!in_memory && !(pairs && seed && words[0] == "program" && words.size() == 5)) {
    std::cerr << "same_trial: usage: same_trial memory PAIRS SEED | program PAIRS SEED PROGRAM FOLDER\n";
    return 2;
  }
  std::optional<Program> program;
  if (!in_memory) {
    std::filesystem::create_directories(words[4]);
    program.emplace(words[3], std::filesystem::absolute(words[4]).string());
  }
  Dice dice(*seed);
  std::vector<Recorded> sessions;
  for (std::size_t i = 0; i < std::min<std::size_t>(kSessions, *pairs + 1); ++i) {
    sessions.push_back({make_session(dice), {}});
  }
  std::uint64_t wrong = 0, damaged = 0, changed = 0;
  for (std::uint64_t i = 0; i < *pairs; ++i) {
    const Pair pair = pair_of_logs(sessions, dice);
    if (pair.damaged) ++damaged;
    if (!is_equal(pair)) ++changed;
    const std::string answer = program ? program->judge_pair(pair, dice) : judge_pair(pair, dice);
    if (answer.empty()) continue;
    if (++wrong <= kFailuresShown)
      std::cerr << "same_trial: pair " << i << ": " << answer << "; changed: " << pair.what << '\n';
  }
  std::cout << *pairs << " pairs, " << damaged << " damaged, " << changed << " changed: " << wrong
            << " wrong answers\n";
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tumble::trial

int main(int argc, char** argv) { return tumble::trial::run({argv + 1, argv + argc}); }
