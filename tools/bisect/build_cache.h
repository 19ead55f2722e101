#pragma once

#include <cstdint>
#include <string>

#include "tools/bisect/settings.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// Programs of revisions, kept between bisections: DIR/KEY-COMMIT/program, with its hash beside it. The key is that of
/// the build's commands, the program's path and the machine's class. Programs that were not used for longest are
/// removed once all together are larger than the bound. Several bisections may use one folder at once.
class BuildCache {
 public:
  /// Makes the folder. Errors: make_private()'s.
  static Result<BuildCache> open(const Settings& settings);

  /// Copies the kept program of a commit to the file `to`. False if none is kept, or a damaged one, which is removed.
  [[nodiscard]] bool take(const std::string& commit, const std::string& to) const;

  /// Keeps a program, unless it alone is larger than the bound. Errors (kCannotFinish): no such file, the disk.
  [[nodiscard]] Status keep(const std::string& commit, const std::string& program) const;

 private:
  [[nodiscard]] std::string place(const std::string& commit) const { return folder_ + '/' + key_ + '-' + commit; }
  void make_room() const;

  std::string folder_;
  std::string key_;
  std::uint64_t bytes_max_ = 0;
};

}  // namespace tumble::tools::bisect
