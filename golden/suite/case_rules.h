#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

/// The rules of a case, as metrics.toml gives them.
namespace tumble::golden {

enum class VerdictKind : std::uint8_t { kExact = 0, kBehaviour = 1, kImage = 2 };
inline constexpr std::array<const char*, 3> kVerdictNames = {"exact", "behaviour", "image"};

/// Errors (kBadInput): a word that is no verdict.
Result<VerdictKind> parse_verdict(std::string_view word);

/// One [[metric]].
struct MetricRule {
  std::string name;           ///< of replay's metrics: docs/metrics.md
  std::optional<double> min;  ///< at least one of the two
  std::optional<double> max;
  std::optional<double> value;  ///< when it was blessed; none: not yet, or null
  std::string why;              ///< the reason for the bound
  bool may_be_null = false;     ///< otherwise a metric that reads null in the end fails
  std::string bodies = "all";   ///< measured bodies, in the words of docs/metrics.md
  std::string axis = "x";       ///< along which nothing should move: a horizontal axis, of an engine one of its own
  bool has_axis = false;        ///< `axis` is given; else our x, whatever the engine calls it
  std::uint64_t from_step = 0;  ///< the state after this step takes the place of the start
  std::string against;          ///< log of another session, for parting_time; a path from the case's folder
  std::string against_path;     ///< the same as a path from here
  std::size_t line = 0;         ///< of `name`, 1-based: where bless finds its place
  std::size_t value_line = 0;   ///< of `value`; 0 if there is none
  bool is_law = false;          ///< a name of CaseRules::laws, of which results alone know a value and a bound
};

/// One [[picture]]: the state after a step, as `tumble render` draws it.
struct PictureRule {
  std::uint64_t step = 0;
  int width = 320;
  int height = 240;
  bool freezing = false;          ///< frozen bodies in their material, active ones white
  std::uint64_t far_off_max = 0;  ///< pixels that another driver may have off by more than render::kFarOffLevels
  std::string why;                ///< the reason for the bound
  [[nodiscard]] std::string file() const;  ///< "frame_0120.png", in the case's folder
};

/// Whether a file of a case's folder is one that a PictureRule could name.
bool is_picture_name(std::string_view name);

/// [engine]: a case of the engine that the project's tumble.toml runs. Its files take the place of scene.toml. Paths
/// are relative to the case's folder.
struct EngineCase {
  std::string title;
  std::string category;            ///< any text
  std::string scene;               ///< {scene}; empty: the case has none
  std::string inputs;              ///< {inputs}; empty: the case has none
  std::vector<std::string> files;  ///< further files that the engine reads
  std::uint64_t repeat = 1;        ///< runs of the engine; from 2 on its own spread is measured
  [[nodiscard]] std::vector<std::string> all_files() const;  ///< scene, inputs and files, each once
};

struct CaseRules {
  std::vector<VerdictKind> require = {VerdictKind::kExact, VerdictKind::kBehaviour};
  std::string command;               ///< of another engine, with {scene} and {log}; empty: none
  std::optional<EngineCase> engine;  ///< none: a case of `command`, or of this program
  [[nodiscard]] bool is_external() const { return engine.has_value() || !command.empty(); }
  std::vector<MetricRule> metrics;
  std::vector<std::string> laws;  ///< of hunt::relations(): laws and relations that the case's session must hold
  std::vector<PictureRule> pictures;
};

}  // namespace tumble::golden
