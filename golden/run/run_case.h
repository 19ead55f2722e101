#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/judge/judge.h"
#include "golden/judge/judge_pictures.h"
#include "golden/suite/suite.h"
#include "replay/log/byte_memory.h"
#include "src/model/scene.h"

namespace tumble::golden {

/// A recorded session in memory.
struct Session {
  replay::MemoryFile log;
  Hash128 continuation;  ///< of the last state; zero where it is not known (another engine's)
  std::string failure;   ///< why it ended early; empty: it did not
};

/// Runs a scene with this build. Errors: a world that cannot be made.
Result<Session> run_session(const sim::SceneDef& scene, const std::string& scene_text);

/// Opens it as the log it is. name: for messages.
Result<replay::LogReader> open_session(const Session& session, const std::string& name);

struct RunOptions {
  std::filesystem::path suite;                      ///< its root
  std::optional<std::vector<VerdictKind>> require;  ///< instead of what the case says
  std::filesystem::path report;                     ///< where a failed case leaves its files; empty: nowhere
};

/// A case, run and judged.
struct CaseRun {
  CaseResult result;
  CaseRules rules;
  Expected actual;
  std::vector<std::optional<double>> values;
  std::vector<DrawnPicture> pictures;
  bool complete = false;  ///< the session ran to its end and was measured: it could be blessed
};

/// Reads a case's files, runs its scene (or the engine that it names) and judges the session. Everything that goes
/// wrong becomes a problem of the result.
CaseRun run_case(const CaseFolder& folder, const RunOptions& options);

}  // namespace tumble::golden
