#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tumble/golden/case_result.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// Keys stay in the order in which they are set.
using Json = nlohmann::ordered_json;

/// As report.json has it (docs/commands.md).
Json to_json(const CaseResult& result);
Json to_json(const Provenance& provenance);
/// Throws Json::exception where a key is missing.
Provenance provenance_from(const Json& json);

/// Throws Json::exception for JSON that to_json() did not make.
CaseResult case_from(const Json& json);
/// Errors (kCannotFinish): text that to_json() did not make.
Result<CaseResult> case_from_json(const std::string& text);

}  // namespace tumble::golden
