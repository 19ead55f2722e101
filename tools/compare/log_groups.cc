#include "tools/compare/log_groups.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "replay/log/checked_log.h"
#include "src/process/interrupt.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

/// Sorts logs into groups, those first that tell most: the longest, and of these the ones with the most channels.
class Grouping {
 public:
  Grouping(std::vector<replay::LogReader>& logs, const replay::Progress& progress) : logs_(logs), progress_(progress) {}

  Result<LogGroups> run() {
    for (const replay::LogReader& log : logs_) {
      std::string note = replay::not_whole(log);
      if (!note.empty() && std::ranges::find(result_.notes, note) == result_.notes.end())
        result_.notes.push_back(std::move(note));
    }
    std::vector<std::size_t> order(logs_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) {
      return std::pair(logs_[i].last_step(), logs_[i].header().declared.channels.size());
    });
    result_.same_length = logs_[order.front()].last_step() == logs_[order.back()].last_step();
    for (const std::size_t log : order) {
      if (Status ok = place(log); !ok.ok()) return ok.error();
    }
    if (Status ok = find_undecided(); !ok.ok()) return ok.error();
    for (LogGroup& group : result_.groups) std::ranges::sort(group.logs);
    std::ranges::stable_sort(result_.groups, [](const LogGroup& a, const LogGroup& b) {
      return a.decided != b.decided ? a.decided > b.decided : a.logs.front() < b.logs.front();
    });
    if (Status ok = explain(); !ok.ok()) return ok.error();
    result_.scope = scope_.scope();
    return std::move(result_);
  }

 private:
  // Whether a log agrees with all logs of a group. Where a comparison passed something over, to agree with the log that
  // stands for the group says nothing of the others.
  Result<bool> agrees(std::size_t g, std::size_t log) {
    LogGroup& group = result_.groups[g];
    std::vector<std::size_t> members = {group.longest};
    std::ranges::copy_if(group.logs, std::back_inserter(members), [&](std::size_t i) { return i != group.longest; });
    for (const std::size_t member : members) {
      if (member == log || (member != group.longest && !partial_)) continue;
      const Result<replay::DiffReport> report = replay::diff_logs(checked_, logs_[member], logs_[log], progress_);
      if (!report.ok()) return report.error();
      if (report->first) return false;
      if (result_.not_in_all.empty() && !report->only_in.empty()) {
        const std::string &one = logs_[member].name(), &other = logs_[log].name();
        result_.not_in_all = "of " + one;
        result_.not_in_all.append(" and ").append(other).append(", ").append(report->only_in.text(one, other));
      }
      partial_ |= !report->scope.passed_over().empty() || report->last_a != report->last_b;
      scope_.add(report->scope, logs_[member].name() + " and " + logs_[log].name());
    }
    return true;
  }

  Status place(std::size_t log) {
    for (std::size_t g = 0; g < result_.groups.size(); ++g) {
      const Result<bool> same = agrees(g, log);
      if (!same.ok()) return same.error();
      if (!*same) continue;
      result_.groups[g].logs.push_back(log);
      return {};
    }
    LogGroup group;
    group.logs = {log};
    group.longest = log;
    result_.groups.push_back(std::move(group));
    return {};
  }

  // Logs that agree with another group than their own too.
  Status find_undecided() {
    for (std::size_t g = 0; g < result_.groups.size(); ++g) {
      for (const std::size_t log : result_.groups[g].logs) {
        bool decided = true;
        for (std::size_t other = 0; decided && other < result_.groups.size(); ++other) {
          if (other == g || !partial_) continue;
          const Result<bool> same = agrees(other, log);
          if (!same.ok()) return same.error();
          decided = !*same;
        }
        if (decided) ++result_.groups[g].decided;
        if (!decided) result_.undecided.push_back(log);
      }
    }
    std::ranges::sort(result_.undecided);
    return {};
  }

  Status explain() {
    for (std::size_t g = 1; g < result_.groups.size(); ++g) {
      LogGroup& group = result_.groups[g];
      replay::LogReader &major = logs_[result_.groups[0].longest], &odd = logs_[group.longest];
      Result<replay::DiffReport> report = replay::diff_logs(checked_, major, odd, progress_);
      if (!report.ok()) return report.error();
      group.against = *std::move(report);
      if (!group.against.first) continue;
      Result<replay::DifferenceReport> difference = replay::report_difference(major, odd, group.against, progress_);
      if (!difference.ok()) return difference.error();
      group.against.first = difference->first;
      replay::name_by_own_axes(major.header(), odd.header(), group.against, &*difference);
      group.difference = *std::move(difference);
    }
    return {};
  }

  std::vector<replay::LogReader>& logs_;
  const replay::Progress& progress_;
  replay::CheckedLogs checked_;
  LogGroups result_;
  replay::CommonScope scope_;  // of the logs that agree
  bool partial_ = false;       // two logs that agree do not share everything
};

std::string names_text(const std::vector<std::string>& paths, const std::vector<std::size_t>& logs) {
  std::string text;
  for (const std::size_t log : logs) text += (text.empty() ? "" : ", ") + printable(paths[log]);
  return text;
}

void print_groups(const std::vector<std::string>& paths, const std::vector<replay::LogReader>& logs,
                  const LogGroups& found) {
  const std::string all = count_text(paths.size(), "log");
  if (found.groups.size() == 1) {
    const char* verdict = found.identical()    ? "identical: "
                          : !found.same_length ? "different in length: "
                                               : "different in what was recorded: ";
    std::cout << verdict << all << ", the same in every compared bit of the steps that they share";
    std::cout << (found.not_in_all.empty() ? "" : "; " + printable(found.not_in_all)) << '\n';
  } else {
    std::cout << "different: " << all << " in " << found.groups.size() << " groups";
    std::cout << (found.has_majority() ? "\n" : "; no group is the largest, so none is the odd one\n");
  }
  for (std::size_t g = 0; g < found.groups.size(); ++g) {
    const LogGroup& group = found.groups[g];
    const char* what = g > 0 && found.has_majority() ? "  odd      "
                       : group.logs.size() == 1      ? "  alone    "
                                                     : "  agree    ";
    std::cout << what << names_text(paths, group.logs);
    if (group.against.first) std::cout << ": different from step " << group.against.first->step << " on";
    std::cout << '\n';
  }
  for (const std::string& note : found.notes) std::cout << "  note     " << printable(note) << '\n';
  const std::uint64_t longest = logs[found.groups[0].longest].last_step();
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (logs[i].last_step() == longest) continue;
    std::cout << "  note     " << printable(paths[i]) << " ends with step " << logs[i].last_step() << ", another with "
              << longest << '\n';
  }
  for (const std::size_t log : found.undecided) {
    std::cout << "  note     " << printable(paths[log])
              << " agrees with more than one group: it is too short, or lacks the channels in which they differ\n";
  }
  for (std::size_t g = 1; g < found.groups.size(); ++g) {
    const LogGroup& group = found.groups[g];
    if (!group.difference) continue;
    const std::string &a = paths[found.groups[0].longest], &b = paths[group.longest];
    std::cout << '\n' << printable(b) << " against " << printable(a) << '\n';
    print_difference(*group.difference, Compared::kTwoLogs, sides_of(a, b));
  }
  if (found.scope.compared.empty()) return;
  if (found.groups.size() > 1) std::cout << "\nbetween the logs that agree\n";
  print_scope(found.scope);
}

Json groups_json(const std::vector<std::string>& paths, const LogGroups& found) {
  Json json = {{"identical", found.identical()}, {"logs", paths},        {"has_majority", found.has_majority()},
               {"not_in_all", found.not_in_all}, {"notes", found.notes}, {"groups", Json::array()}};
  for (std::size_t g = 0; g < found.groups.size(); ++g) {
    const LogGroup& group = found.groups[g];
    Json one = {{"logs", Json::array()}, {"odd", g > 0 && found.has_majority()}};
    for (const std::size_t log : group.logs) one["logs"].push_back(paths[log]);
    one["first"] = group.against.first ? divergence_json(*group.against.first) : Json(nullptr);
    if (group.difference) add_difference(*group.difference, Compared::kTwoLogs, one);
    json["groups"].push_back(std::move(one));
  }
  json["undecided"] = Json::array();
  for (const std::size_t log : found.undecided) json["undecided"].push_back(paths[log]);
  add_scope(found.scope, json);
  return json;
}

}  // namespace

Result<LogGroups> group_logs(std::vector<replay::LogReader>& logs, const replay::Progress& progress) {
  return Grouping(logs, progress).run();
}

Result<Exit> diff_many(const std::vector<std::string>& paths, bool json) {
  std::vector<replay::LogReader> logs;
  for (const std::string& path : paths) {
    Result<replay::LogReader> log = open_log(path);
    if (!log.ok()) return log.error();
    logs.push_back(*std::move(log));
  }
  const process::InterruptGuard guard;
  ProgressBar bar("comparing");
  const Result<LogGroups> found = group_logs(logs, bar.progress());
  bar.finish();
  if (!found.ok()) return found.error();
  if (json) {
    print_json("diff", groups_json(paths, *found));
  } else {
    print_groups(paths, logs, *found);
  }
  Exit verdict = found->identical() ? Exit::kSame : Exit::kDifference;
  for (const replay::LogReader& log : logs) verdict = judge("diff", log, verdict);
  return verdict;
}

}  // namespace tumble::tools
