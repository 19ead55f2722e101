#pragma once

#include <filesystem>

#include "golden/run/external_engine.h"
#include "tumble/golden/case_result.h"
#include "tumble/golden/case_rules.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/scene.h"

namespace tumble::golden {

/// A session whose laws are judged.
struct LawSession {
  const CaseFolder& folder;
  const std::filesystem::path& suite;
  replay::LogReader& log;
  const sim::SceneDef& scene;     ///< of the case; not looked at where another engine is handed a scene
  bool may_run = false;           ///< another engine, once more
  std::filesystem::path scratch;  ///< of its runs
};

/// Judges the laws of the rules (hunt::judge_trace()), adds a result of each to the metrics of a case, and makes a
/// failure of its behaviour where one is broken or cannot be judged. A session of this program is computed again, and
/// judged only where it ends with the log's bits. Of an engine the log is judged; relations run the engine again.
void judge_laws(const LawSession& session, const CaseRules& rules, CaseResult& result);

}  // namespace tumble::golden
