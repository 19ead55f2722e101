#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "golden/hunt/finding.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

/// How often a relation was judged. A scene that it says nothing about counts as not judged.
struct Tally {
  std::uint64_t held = 0, broken = 0, not_applicable = 0;
  std::optional<double> nearest;     ///< of the scenes that held: the largest value over bound; none: none has a bound
  std::uint64_t nearest_number = 0;  ///< that scene
  void add(const Tally& other);
  void count(const Judgement& one, std::uint64_t number);  ///< number: of the scene
};
Json to_json(const Tally& tally);

/// The scenes of shard K of N: those whose number mod N is K − 1. 1 of 1: all.
struct Share {
  std::uint64_t shard = 1, shards = 1;
  [[nodiscard]] std::uint64_t number(std::uint64_t k) const { return shard - 1 + k * shards; }  ///< of its k-th scene
  /// How many of the scenes 0 … count − 1 are its own.
  [[nodiscard]] std::uint64_t of(std::uint64_t count) const { return (count + shards - shard) / shards; }
};

/// Scenes that were judged behind one that was not, as a hunt leaves them whose time ended. They do not count, and a
/// hunt that goes on judges them again.
struct Beyond {
  std::uint64_t scenes = 0;
  std::vector<Finding> findings;  ///< unshrunk
};

/// A hunt so far: the first `next` scenes of the share are judged, all by the same relations.
struct HuntState {
  std::uint64_t seed = 0;
  Share share;
  std::uint32_t grammar = 0;
  std::string program;  ///< version and commit
  std::string against;
  std::vector<std::string> within;     ///< to_text() of its bounds; empty: bits are compared
  std::string engine;                  ///< the command of the engine; empty: this program is judged
  std::string engine_hash;             ///< of the engine's files, or of those of `against`; empty: neither is asked
  std::vector<std::string> claimed;    ///< relations that the engine claims
  bool ended = false;                  ///< it came to its --count or --time
  std::optional<std::uint64_t> count;  ///< of scenes of all shards, by which it is to end; none: by time alone
  std::uint64_t merged = 0;            ///< number of shards that it was merged of; 0: it was run, and can go on
  std::uint64_t next = 0;
  std::uint64_t no_scenes = 0;                           ///< drawn scenes that no world can be made of
  std::uint64_t refused = 0;                             ///< scenes that the engine refused
  std::string refusal;                                   ///< the first of them, and the engine's words
  std::vector<std::pair<std::string, Tally>> relations;  ///< in the order in which they are judged
  std::vector<Finding> findings;                         ///< by number, then by relation's order
  Beyond beyond;                                         ///< of this run; no kept hunt has it
};

Json to_json(const HuntState& state);

using Tallies = std::vector<std::pair<std::string, Tally>>;

/// Whether a scene that breaks a relation is a failure: of this program (engine empty) always; of an engine where it
/// claims the relation, or where the scene ended the program.
bool is_failure(const std::string& relation, const std::string& engine, const std::vector<std::string>& claimed);

/// nothing_judged() of tallies by relation.
bool nothing_judged(const Tallies& relations, const std::string& engine, const std::vector<std::string>& claimed);

/// Whether there are bounds of --within, and no scene could be judged by any.
bool no_measure_judged(const Tallies& relations);

/// Whether no session was judged by anything that is asked: no scene was there, the engine refused or failed all, or no
/// relation could be asked. Of an engine with claims only these count.
bool nothing_judged(const HuntState& state);

/// The first finding in which the judge ended, and not what it judged; empty: none.
std::string judges_error(const HuntState& state);

/// Whether none of the findings breaks a relation that was claimed: all are, of this program. That a scene ends this
/// program is no engine's to claim or to leave out.
bool claims_hold(const HuntState& state);

/// The first way in which a kept hunt is not the one that is wanted, as an error (kBadInput). where: for its message.
Status same_hunt(const HuntState& kept, const HuntState& wanted, const std::string& where);

/// The file of a folder that holds the state, and the one that is locked while a hunt works there.
inline constexpr const char* kStateFile = "hunt.json";
inline constexpr const char* kLockFile = "hunt.lock";

/// A folder that keeps a hunt:
///
///     hunt.json              the state, replaced at once after each round
///     findings/NAME.toml     the scene as it was drawn; beside it what an engine wrote and printed (keep_run())
///     cases/NAME/scene.toml  the shrunk scene, and metrics.toml: a case ready for `tumble bless --suite FOLDER`
///
/// hunt.json ends with a hash of its text. Errors (kBadInput): a folder that holds another hunt, or a file that cannot
/// be read; kDamaged: a hunt.json that save() did not write; kCannotFinish: the disk.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

  /// The kept hunt, or `fresh` where there is none. A hunt of another seed, grammar, program or question is an error
  /// that names what differs.
  [[nodiscard]] Result<HuntState> open(HuntState fresh) const;

  /// The kept hunt. Errors: kBadInput: none, or of another format; kDamaged: text that save() did not write.
  [[nodiscard]] Result<HuntState> load() const;

  /// Writes the files of a finding, then nothing else refers to it until save().
  [[nodiscard]] Status write(const Finding& finding, const std::string& drawn, const HuntState& state) const;
  [[nodiscard]] Status save(const HuntState& state) const;

  /// Keeps the run of an engine that set_aside() put into `place` beside the scene of a finding, and names its files
  /// there.
  [[nodiscard]] Status keep(const std::filesystem::path& place, Finding& finding) const;

 private:
  std::filesystem::path path_;
};

}  // namespace tumble::hunt
