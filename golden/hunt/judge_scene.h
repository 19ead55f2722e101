#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/engine/project.h"
#include "golden/hunt/apart/apart_bounds.h"
#include "golden/hunt/judge/relation.h"
#include "golden/hunt/scene/scene_text.h"
#include "golden/hunt/shrink/shrink.h"

namespace tumble::hunt {

/// What scenes are judged by.
struct Question {
  std::vector<std::string> only;                ///< names of relations; empty: all
  std::string against;                          ///< another build of tumble, whose sessions are compared; empty: none
  std::vector<ApartBound> within;               ///< how far measures of these may be apart; empty: every bit must agree
  std::optional<golden::EngineProject> engine;  ///< whose sessions are judged; none: those of this program
  std::filesystem::path scratch;  ///< where other programs get folders of their own; empty: the system's place
  std::filesystem::path told;     ///< a file that gets the name of each relation before it is judged, for the case that
                                  ///< the process ends; empty: none
  std::filesystem::path runs;  ///< where runs of an engine that broke something are set aside, by the scene's number;
                               ///< empty: nowhere
};

/// Errors (kBadInput): a name that no relation has, or one that says nothing about an engine; an engine that is handed
/// no scene.
Status check_question(const Question& question);

/// The session of a scene, of the question's engine. Errors: the scene is none, or the engine refuses it.
Result<Trace> trace_of(const Question& question, const sim::SceneDef& scene);

/// Whether a scene that breaks a relation is a failure: always for this program, and for an engine where it claims it.
bool is_claimed(const Question& question, const std::string& relation);

/// The relations of a question, in order; names only.
std::vector<std::string> names_of(const Question& question);

/// The judgement of one relation of a question on a session. Precondition: the name is one of names_of().
Judgement judge(const Question& question, const std::string& relation, const Trace& trace, const TextScene& scene);

/// All judgements on a scene.
struct Judged {
  std::string problem;   ///< why the scene is none, or the engine refuses it; empty: it was judged
  bool refused = false;  ///< by the engine
  std::string unable;    ///< why the engine could not be run; empty: it was. No judgement counts then
  std::vector<std::pair<std::string, Judgement>> judgements;
  std::vector<std::string> features;       ///< features_of(), where they are asked for
  std::shared_ptr<const EngineFiles> ran;  ///< as Trace has it
};
Judged judge_scene(const Question& question, const TextScene& scene, bool with_features = false);

}  // namespace tumble::hunt
