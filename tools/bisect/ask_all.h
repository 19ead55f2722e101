#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/bisect/build_cache.h"
#include "tools/bisect/git.h"
#include "tools/bisect/revision.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// An answer and the wall time that it took, with its build.
struct Asked {
  Answer answer;
  double seconds = 0;
};

/// Builds and asks several revisions at once, each in a part of the workplace with a clone of its own.
class AskAll {
 public:
  /// All must outlive this object.
  AskAll(const Settings& settings, const Workplace& place, Asker::Cancel cancel);

  /// Opens the cache and makes the first part ready. Errors: Asker::prepare's, BuildCache::open's.
  Status prepare();

  /// The answers, in order. Precondition (SIM_CHECK): at most settings.jobs commits. Errors: the first of Asker::ask's;
  /// the others are then ended too.
  Result<std::vector<Asked>> ask(const std::vector<std::string>& commits);

  /// Asks a commit that was asked once a second time, and notes in its answer where it does not repeat. Errors:
  /// ask()'s.
  Status ask_again(const std::string& commit, Answer& answer);

 private:
  struct Part {
    Part(const Settings& settings, const Workplace& all, std::uint64_t k, const BuildCache* cache,
         const Asker::Cancel& cancel);
    Workplace place;
    Git git;
    Asker asker;
  };
  Status add_part();

  const Settings& settings_;
  const Workplace& place_;
  Asker::Cancel cancel_;
  std::atomic<bool> failed_ = false;
  std::optional<BuildCache> cache_;
  std::vector<std::unique_ptr<Part>> parts_;
};

}  // namespace tumble::tools::bisect
