#pragma once

#include <functional>
#include <string>

#include "tools/bisect/answer.h"
#include "tools/bisect/build_cache.h"
#include "tools/bisect/build_progress.h"
#include "tools/bisect/git.h"
#include "tools/bisect/recording.h"
#include "tools/bisect/settings.h"
#include "tools/bisect/workplace.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// Builds programs of revisions and asks them.
class Asker {
 public:
  using Cancel = std::function<bool()>;

  /// All must outlive the asker.
  /// cache: may be null. quiet: does not show how far a build is.
  Asker(const Settings& settings, const Workplace& place, const Git& git, const BuildCache* cache, bool quiet,
        Cancel cancel)
      : settings_(settings),
        place_(place),
        git_(git),
        cache_(cache),
        quiet_(quiet),
        cancel_(std::move(cancel)),
        recording_(settings, place) {}

  /// Makes the clone and the scene. Errors: git's; the log's; kBadInput where the session cannot be recorded anew and
  /// the question needs that.
  Status prepare();

  /// Puts a commit's files in place, builds it and asks. Errors (kCannotFinish): an interruption, a full disk; a
  /// fault of the revision itself is an answer.
  Result<Answer> ask(const std::string& commit);

 private:
  [[nodiscard]] Result<bool> run(const Recording::Command& command, const std::string& name, std::string& why);
  [[nodiscard]] Result<bool> build_once(const std::string& log, BuildProgress& progress, std::string& why);
  [[nodiscard]] Result<bool> build(const std::string& commit, std::string& why);
  [[nodiscard]] Status note_left_over();
  /// Records the session; false: the revision cannot.
  [[nodiscard]] Result<bool> record(const std::string& commit, std::string& why);
  [[nodiscard]] Result<Answer> ask_replay();
  [[nodiscard]] Result<Answer> ask_session(const std::string& commit);
  [[nodiscard]] Result<Answer> ask_case();
  [[nodiscard]] Result<Answer> ask_once(const std::string& commit);

  const Settings& settings_;
  const Workplace& place_;
  const Git& git_;
  const BuildCache* cache_;
  bool quiet_;
  Cancel cancel_;
  Recording recording_;
  bool built_before_ = false;
  bool told_left_over_ = false;
  int last_exit_ = 0;  // of run()
};

}  // namespace tumble::tools::bisect
