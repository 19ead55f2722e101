#pragma once

#include <string>

#include "src/files/output_guard.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// Makes a folder that this user owns and nobody else can write to: programs are built and run in it. option: for
/// messages, "--work". Errors: kBadInput: it is there and is not so; kCannotFinish: it cannot be made.
Status make_private(const std::string& folder, const std::string& option);

/// The folder of a bisection: a clone, builds, sessions, answers so far. Nothing is written elsewhere.
class Workplace {
 public:
  Workplace() = default;
  Workplace(Workplace&& other) noexcept;
  Workplace& operator=(Workplace&& other) noexcept;
  ~Workplace();

  /// Opens `folder`, or one for this question under the system's folder for temporary files, and locks it; processes
  /// that an earlier bisection left behind hold the lock too. Without `resume` its contents are removed
  /// first; guard: knows the files that must not be in it. Errors: kBadInput for a folder of another user or one that
  /// holds other things, and with `resume` if there is nothing to resume; kCannotFinish if it cannot be made or is in
  /// use.
  static Result<Workplace> open(const std::string& folder, const std::string& fingerprint, bool resume,
                                files::OutputGuard& guard);

  /// The same folder with a clone and files of its own, for one that asks beside others: the k-th, from 0, which is
  /// this one. Sessions are those of all. Must not outlive this one.
  [[nodiscard]] Workplace part(std::uint64_t k) const;

  [[nodiscard]] const std::string& root() const { return root_; }
  [[nodiscard]] std::string source() const { return file("source"); }
  [[nodiscard]] std::string state() const { return root_ + "/state.json"; }
  [[nodiscard]] std::string file(const std::string& name) const { return root_ + '/' + part_ + name; }
  [[nodiscard]] std::string session(const std::string& commit) const {
    return root_ + "/sessions/" + commit + ".tumble";
  }

  /// Removes the folder with all its contents.
  void remove();

 private:
  std::string root_;
  std::string part_;  // "2/"
  int lock_ = -1;
};

}  // namespace tumble::tools::bisect
