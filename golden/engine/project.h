#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "golden/engine/table_reading.h"
#include "tumble/sim/result.h"

/// tumble.toml in the root of a project: how its engine is built and run. `replay`, `check`, `bisect` and `diff --zoom`
/// use it; docs/other_engines.md describes the keys.
namespace tumble::golden {

inline constexpr const char* kProjectFile = "tumble.toml";

/// How an engine moves a free body in a step, or in each of its substeps.
enum class Integrator : std::uint8_t {
  kExact,              ///< along its parabola
  kSemiImplicitEuler,  ///< by its velocity after the step
  kExplicitEuler,      ///< by its velocity before the step
};
inline constexpr std::array kIntegratorNames = {"exact", "semi_implicit_euler", "explicit_euler"};

/// [engine] of a tumble.toml.
struct EngineProject {
  std::filesystem::path file;      ///< absolute, for messages; empty: the command comes from elsewhere
  std::filesystem::path folder;    ///< in which every command runs
  std::vector<std::string> build;  ///< command lines, one after the other; may be empty
  std::string run;                 ///< with {log}; may have {scene} and {inputs}
  std::string scene;     ///< {scene} where neither a case nor a command line names one; a path from the folder
  bool shell = false;    ///< commands are given to sh instead of being split into words
  double timeout_s = 0;  ///< of a run; 0: none
  Integrator integrator = Integrator::kExact;  ///< what a hunt's laws of free flight expect
  std::uint64_t substeps = 1;                  ///< equal parts of a step that the integrator takes one by one
  TableReading table;                          ///< of what the engine writes, where that is a table
  std::map<std::string, bool>
      claims;  ///< [engine.claims]: relations and laws of a hunt, and whether the engine keeps them
  std::map<std::string, std::string> claim_places;  ///< "7:1": line and column of each in the file
};

/// Errors (kBadInput): "<file>:<line>:<column>: [engine] key "run": found …, wanted …".
Result<EngineProject> parse_project(std::string_view text, const std::filesystem::path& file);
Result<EngineProject> read_project(const std::filesystem::path& file);

/// The tumble.toml of `from` or of the nearest folder above it; none where no folder has one. Errors: read_project's.
Result<std::optional<EngineProject>> find_project(const std::filesystem::path& from);

/// How far a body at rest falls in a step of this engine, in ½ g dt²: 1 on a parabola.
double fall_in_a_step(const EngineProject& project);

/// A project without a tumble.toml, made of one command line.
EngineProject project_of_command(const std::string& run, const std::filesystem::path& folder, bool shell);

}  // namespace tumble::golden
