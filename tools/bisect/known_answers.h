#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tools/bisect/ask_all.h"
#include "tools/output/text.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// The answers so far, in a file that is never half written.
class KnownAnswers {
 public:
  /// fingerprint: of the settings; a file of others is not read.
  KnownAnswers(std::string path, const std::string& fingerprint);

  /// Reads the file, or makes it. Errors: kBadInput: it holds the answers to another question; kDamaged: no answers;
  /// the disk.
  Status load();

  /// Null if the commit was not asked.
  [[nodiscard]] const Asked* find(const std::string& commit) const;

  /// Errors (kCannotFinish): the disk.
  Status add(const std::string& commit, const Asked& asked);

 private:
  Status save();

  std::string path_;
  Json json_;
  std::map<std::string, Asked> known_;
};

}  // namespace tumble::tools::bisect
