#include "tools/bisect/asked_sessions.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "replay/diff/difference_report.h"
#include "src/base/check.h"
#include "tools/files/log_files.h"
#include "tumble/replay/compare.h"

namespace tumble::tools::bisect {
namespace {

std::string place_of(const replay::Divergence& first) {
  std::string text = "step " + std::to_string(first.step) + ", phase " + first.phase;
  if (first.body) text += ", body " + std::to_string(*first.body);
  text += ", " + (is_body_missing(first) ? only_in(first, "one", "the other") : first.field);
  return text + replay::apart_words(first);
}

/// Empty where they are the same, or one cannot be read.
std::string difference_of(const std::string& one, const std::string& other) {
  Result<replay::LogReader> a = open_log(one), b = open_log(other);
  if (!a.ok() || !b.ok()) return "";
  Result<replay::DiffReport> report = replay::diff_logs(*a, *b);
  if (!report.ok()) return "";
  replay::name_by_own_axes(a->header(), b->header(), *report, nullptr);
  return report->first ? place_of(*report->first) : report->unequal("one", "the other");
}

}  // namespace

AskedSessions::AskedSessions(std::string path, std::string mark) : path_(std::move(path)), mark_(std::move(mark)) {}

void AskedSessions::add() {
  const std::size_t k = same_as_.size();
  same_as_.push_back(k);
  std::error_code error;
  std::filesystem::rename(path_, aside(k), error);
  if (error || k == 0) return;
  const std::string found = difference_of(aside(0), aside(k));
  if (difference_.empty()) difference_ = found;
  if (!found.empty() || !std::filesystem::exists(aside(0), error)) return;
  same_as_[k] = 0;
  std::filesystem::remove(aside(k), error);
}

void AskedSessions::keep(std::size_t k) {
  SIM_CHECK(k < same_as_.size(), k, same_as_.size());
  std::error_code error;
  std::filesystem::rename(aside(same_as_[k]), path_, error);
  for (std::size_t one = 0; one < same_as_.size(); ++one) std::filesystem::remove(aside(one), error);
}

}  // namespace tumble::tools::bisect
