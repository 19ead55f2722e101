#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tumble::tools::bisect {

/// The sessions that one revision records when it is asked several times: are they the same in every bit?
class AskedSessions {
 public:
  /// path: of the session that each ask writes. mark: of the files beside it that keep the earlier ones.
  explicit AskedSessions(std::string path, std::string mark = "ask");

  /// After each ask, which may have written none.
  void add();

  /// Leaves the session of the k-th ask, from 0, at the path and removes the others. Precondition (SIM_CHECK): there
  /// was such an ask.
  void keep(std::size_t k);

  /// The first difference of two of them: "step 12, phase fall, body 3, velocity.x, 6e-05 m/s apart". Empty: there was
  /// none, or fewer than two sessions can be read.
  [[nodiscard]] const std::string& difference() const { return difference_; }

 private:
  [[nodiscard]] std::string aside(std::size_t k) const { return path_ + '.' + mark_ + std::to_string(k); }

  std::string path_;
  std::string mark_;
  std::vector<std::size_t> same_as_;  // of each ask: the earlier one with the same bits, or itself
  std::string difference_;
};

}  // namespace tumble::tools::bisect
