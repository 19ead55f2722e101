#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "golden/hunt/judge/relation.h"
#include "golden/hunt/shrink/shrink.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

using Json = nlohmann::ordered_json;

/// The relation that a scene breaks which ends the program or hangs it. It has findings and no tally: the scene counts
/// as not judged by every relation.
inline constexpr const char* kSurvives = "survives";

/// A scene that breaks a relation. Seed, number and the program's commit name the scene.
struct Finding {
  std::uint64_t seed = 0, number = 0;
  std::string relation;
  std::string kind;  ///< the arrangement, the first word of the scene's title
  Judgement judgement;
  std::string judging;                    ///< of kSurvives: the relation at which the judge ended; empty: the session
  std::vector<std::string> engine_files;  ///< in the folder's findings/: what the engine wrote and printed
  std::string shrunk_text;                ///< TOML; empty: not shrunk
  Judgement shrunk_judgement;
  std::size_t bodies = 0;   ///< of the shrunk scene
  std::uint64_t steps = 0;  ///< likewise
  std::uint64_t tried = 0;  ///< scenes judged while shrinking
  bool least = false;       ///< nothing more could go
  [[nodiscard]] bool shrunk() const { return !shrunk_text.empty(); }
};

/// "momentum_7_1234": the name of its case.
std::string name_of(const Finding& finding);

/// Of kSurvives: whether Tumble's judge ended, and not the program that is judged. Of an engine, which has a process of
/// its own, always; of this program where a relation was judged.
bool is_judges_error(const std::string& relation, const std::string& judging, const std::string& engine);

/// The judgement of a scene whose process ended: `failure` says how.
Judgement ended(const std::string& failure, const std::string& judging, bool of_engine);

/// The relation that Question::told holds; empty: none was judged.
std::string told_in(const std::filesystem::path& file);

/// How far a value is beyond its bound, as a power of ten; 0 where nothing is allowed.
int decade_of(const Judgement& judgement);

/// Findings of one relation, phase and size.
struct FindingGroup {
  std::string relation, phase;
  int decade = 0;
  std::vector<const Finding*> findings;  ///< by number; shrunk ones first
};
/// The largest first. `findings` must outlive the groups.
std::vector<FindingGroup> grouped(const std::vector<Finding>& findings);

Json to_json(const Judgement& judgement);
/// Of a broken relation. Throws Json::exception where a key is missing.
Judgement judgement_from(const Json& json);
Json to_json(const Finding& finding);
/// The JSON of what an engine may have said: bytes that are no text become U+FFFD.
std::string whole_text(const Json& json);
/// Throws Json::exception where a key is missing.
Finding finding_from(const Json& json);

/// metrics.toml of the case that the finding becomes: of the engine of a tumble.toml, or of this program. program: the
/// version and commit that found it, which names the scene together with its seed and number.
std::string case_rules(const Finding& finding, std::string_view program, bool of_engine);

}  // namespace tumble::hunt
