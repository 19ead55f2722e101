#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "golden/hunt/folder.h"
#include "golden/hunt/judge_scene.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

/// The scene of a number as it is judged. Errors (kBadInput): the draw is no scene.
Result<TextScene> drawn_scene(std::uint64_t seed, std::uint64_t number);

/// Scenes of one shard in turn, judged in one child process.
struct Batch {
  std::string unable;        ///< why the engine could not be run: nothing else of the batch counts
  std::uint64_t scenes = 0;  ///< judged, those of no_scenes and refused included
  std::uint64_t no_scenes = 0;
  std::uint64_t refused = 0;   ///< by the engine
  std::string refusal;         ///< the first
  std::vector<Tally> tallies;  ///< by relation, in the question's order
  std::vector<Finding> findings;
  std::vector<std::pair<std::uint64_t, std::vector<std::string>>>
      features;  ///< by number, of scenes that broke nothing
};

/// first: of the share's scenes, from 0. with_features: fills Batch::features. enough: asked before each scene; once it
/// is true the batch ends.
Batch judge_batch(const Question& question, std::uint64_t seed, const Share& share, std::uint64_t first,
                  std::uint64_t scenes, bool with_features, const std::function<bool()>& enough);

/// As one process hands it to another.
std::string to_text(const Batch& batch);
/// Errors (kCannotFinish): text that to_text() did not make, or the engine could not be run.
Result<Batch> batch_from(const std::string& text);

/// The judgements on one scene, likewise.
std::string judgements_text(const Judged& judged);
Result<Judged> judgements_from(const std::string& text);

/// Shrinks the scene of a finding; not one that ends the program. enough: asked before each candidate; true keeps what
/// the search has reached.
Finding shrink_finding(const Question& question, Finding finding, std::uint64_t tries_most,
                       const std::function<bool()>& enough);

}  // namespace tumble::hunt
