#include "tools/compare/session_time.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace tumble::tools {
namespace {

constexpr double kRounding = 1e-9;  // of a sum of step lengths, as a part of it

/// Calls visit(step, time at its end) for every step that the log holds, until it returns false.
template <class Visit>
Status each_step(replay::LogReader& log, const Visit& visit) {
  double time = 0, dt = log.header().scene.world.dt;
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

}  // namespace

Result<std::uint64_t> step_at(replay::LogReader& log, double seconds) {
  std::uint64_t last = log.first_state();
  const Status read = each_step(log, [&](std::uint64_t k, double time) {
    if (time > seconds * (1 + kRounding)) return false;
    last = k;
    return true;
  });
  if (!read.ok()) return read.error();
  if (last == log.first_state()) return bad_input(log.name() + ": no step ends within " + rounded(seconds, "s"));
  return last;
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
