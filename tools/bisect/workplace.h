#pragma once

#include <string>

#include "src/base/result.h"

namespace tumble::tools::bisect {

/// The folder in which a bisection works: a clone, builds, sessions, what is known so far. Nothing is written
/// elsewhere.
class Workplace {
 public:
  Workplace() = default;
  Workplace(Workplace&& other) noexcept;
  Workplace& operator=(Workplace&& other) noexcept;
  ~Workplace();

  /// Opens `folder`, or one for this question under the system's folder for temporary files, and locks it; processes
  /// that an earlier bisection left behind hold the lock too. Without `resume` what lies in it is removed first.
  /// Errors: kBadInput for a folder of somebody else's or one that holds other things, and with `resume` where nothing
  /// is to be resumed; kCannotFinish where it cannot be made or is in use.
  static Result<Workplace> open(const std::string& folder, const std::string& fingerprint, bool resume);

  [[nodiscard]] const std::string& root() const { return root_; }
  [[nodiscard]] std::string source() const { return root_ + "/source"; }
  [[nodiscard]] std::string state() const { return root_ + "/state.json"; }
  [[nodiscard]] std::string file(const std::string& name) const { return root_ + '/' + name; }
  [[nodiscard]] std::string session(const std::string& commit) const {
    return root_ + "/sessions/" + commit + ".tumble";
  }

  /// Takes everything away.
  void remove();

 private:
  std::string root_;
  int lock_ = -1;
};

}  // namespace tumble::tools::bisect
