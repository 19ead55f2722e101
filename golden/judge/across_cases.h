#pragma once

#include <string>
#include <vector>

#include "tumble/golden/case_result.h"

namespace tumble::golden {

/// What several cases whose bits moved have in common, the most common first, three sentences and how many more: "5 of
/// 6 first differ in step 1, phase integrate"; "3 of 6 first differ in phase find_contacts, in steps 4 to 30". Empty
/// where fewer than two cases moved or no two of them have a phase in common.
std::vector<std::string> across_cases(const std::vector<CaseResult>& cases);

/// Of `check --heavy`: how many cases were gone on with from each step, and which were not. Empty: none was asked.
std::string gone_on_across(const std::vector<CaseResult>& cases);

}  // namespace tumble::golden
