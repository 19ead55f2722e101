#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "replay/stream/stream_step.h"
#include "tumble/replay/extras.h"

/// Steps that a rollback took back, compared with those recorded in their place: a sync test.
namespace tumble::replay {

/// Sees every step in the order in which it was recorded, superseded ones included.
class SupersededSteps {
 public:
  /// A step was recorded. taken_back: a rewind will take it back; replaces: it was recorded in place of one.
  void see(const StreamStep& step, bool taken_back, bool replaces);

  /// What the log says of step k; empty: it was recorded once.
  [[nodiscard]] const std::vector<Superseded>& of(std::uint64_t k) const;

  /// The first step that was computed in two ways from equal inputs and an equal state; "" if none was.
  [[nodiscard]] const std::string& first_difference() const { return first_difference_; }

 private:
  /// A step with every state written out.
  struct Whole {
    StreamStep step;
    std::map<std::uint64_t, StreamState> states;
    bool same_before = true;  ///< the step before was recorded alike both times, or once
  };

  [[nodiscard]] Superseded compare(const Whole& before, const Whole& after) const;

  std::map<std::uint64_t, StreamState> last_;
  std::uint64_t last_step_ = 0;
  std::map<std::uint64_t, Whole> taken_back_;
  std::map<std::uint64_t, std::vector<Superseded>> found_;
  std::string first_difference_;
};

}  // namespace tumble::replay
