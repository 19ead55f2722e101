#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tumble/golden/case_result.h"
#include "tumble/sim/result.h"

/// HISTORY.md: every blessing, the size of its changes, and its reason.
namespace tumble::golden {

/// The changes of one case by one blessing.
struct Blessing {
  std::string name;
  bool is_new = false;  ///< there was no golden before
  std::string bits;     ///< "first difference: step 12, phase find_contacts", "same bits", "new: 300 states"
  std::vector<std::string> details;   ///< further sentences about the bits
  std::vector<MetricResult> metrics;  ///< value: after; rule.value: before
};

/// An entry: heading with the date of today (UTC) and the reason, a list of cases.
std::string history_entry(const std::string& reason, const std::vector<Blessing>& blessings);

/// Adds an entry at the top, under the file's heading, which is made where there is no file. Errors (kCannotFinish,
/// kBadInput): reading, writing.
Status add_to_history(const std::filesystem::path& suite, const std::string& entry);

}  // namespace tumble::golden
