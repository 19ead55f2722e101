#include "tools/compare/session_time.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "tumble/replay/compare.h"

namespace tumble::tools {
namespace {

constexpr double kRounding = 1e-9;  // of a sum of step lengths, as a part of it

/// Calls visit(step, time at its end) for every step that the log holds, until it returns false. start: the time at
/// which the log begins, s.
template <class Visit>
Status each_step(replay::LogReader& log, const Visit& visit, double start = 0) {
  double time = start, dt = log.header().scene.world.dt;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    if (log.lost_at(k) == nullptr) {
      const Result<const replay::StepRecord*> record = log.read_hashes(k);
      if (!record.ok()) return record.error();
      dt = (*record)->dt;
    }
    time += dt;  // a lost step counts as long as the one before
    if (!visit(k, time)) break;
  }
  return {};
}

/// The last step of a log that ends by `seconds`, at least one; kNoLimit where the log has none behind it.
Result<std::uint64_t> limit_of(replay::LogReader& log, double seconds, double start) {
  std::uint64_t last = log.first_state();
  bool goes_on = false;
  const Status read = each_step(
      log,
      [&](std::uint64_t k, double time) {
        goes_on = time > seconds * (1 + kRounding);
        if (!goes_on) last = k;
        return !goes_on;
      },
      start);
  if (!read.ok()) return read.error();
  if (!goes_on) return replay::kNoLimit;
  if (last == log.first_state()) return bad_input(log.name() + ": no step ends within " + rounded(seconds, "s"));
  return last;
}

}  // namespace

// A session that ends before sets no limit: where the other goes on, the two differ in length.
Result<std::uint64_t> step_until(replay::LogReader& a, replay::LogReader& b, double seconds) {
  replay::LogReader& earlier = a.first_state() <= b.first_state() ? a : b;
  std::uint64_t until = replay::kNoLimit;
  for (replay::LogReader* log : {&a, &b}) {
    const Result<double> start = time_of(earlier, log->first_state());
    if (!start.ok()) return start.error();
    const Result<std::uint64_t> limit = limit_of(*log, seconds, *start);
    if (!limit.ok()) return limit.error();
    until = std::min(until, *limit);
  }
  return until;
}

Result<double> time_of(replay::LogReader& log, std::uint64_t k) {
  double found = 0;
  const Status read = each_step(log, [&](std::uint64_t step, double time) {
    if (step <= k) found = time;
    return step < k;
  });
  if (!read.ok()) return read.error();
  return found;
}

Result<std::optional<Parting>> find_parting(replay::LogReader& log, const replay::Separation& separation, double beyond,
                                            std::uint64_t last) {
  for (const replay::SeparationRow& row : separation.rows) {
    if (row.step > last) break;
    if (row.separation <= beyond) continue;
    const Result<double> time = time_of(log, row.step);
    if (!time.ok()) return time.error();
    return std::optional<Parting>({beyond, row.step, *time, row.body});
  }
  return std::optional<Parting>();
}

void print_parting(const std::optional<Parting>& parting, double beyond, std::uint64_t last, bool all_measured) {
  const std::string bound = rounded(beyond, "m");
  if (!parting) {
    std::cout << "apart by at most " << bound << " up to step " << last
              << (all_measured ? "" : ", of the bodies that both have; others exist in one only") << '\n';
    return;
  }
  std::cout << "apart by more than " << bound << " from " << rounded(parting->time, "s") << " on: step "
            << parting->step;
  if (parting->body) std::cout << ", body " << *parting->body;
  std::cout << '\n';
}

Json parting_json(const std::optional<Parting>& parting, double beyond) {
  Json json = {{"beyond", beyond}, {"time", nullptr}, {"step", nullptr}, {"body", nullptr}};
  if (!parting) return json;
  json["time"] = parting->time;
  json["step"] = parting->step;
  if (parting->body) json["body"] = *parting->body;
  return json;
}

}  // namespace tumble::tools
