#pragma once

#include <string>
#include <vector>

/// Runs the real program `tumble` in a folder of the test's own.
namespace tumble::test {

struct Outcome {
  int exit = -1;  ///< exit status; -1 if a signal ended it
  std::string out;
  std::string err;
};

/// A new folder for one test, removed at its end. Scenes and logs are given by their name in it.
class Workshop {
 public:
  Workshop();
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void write(const std::string& name, const std::string& content) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  /// The names in this folder and below that hold `part`, in order.
  [[nodiscard]] std::vector<std::string> names_with(const std::string& part) const;

  /// Runs `tumble` with this folder as the current one. Arguments are passed as they are, unseen by any shell.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const;
  /// As run(), through a shell that runs `before` first: "ulimit -f 8; ".
  [[nodiscard]] Outcome run_after(const std::string& before, const std::vector<std::string>& arguments) const;

  /// Records kSmallScene as NAME.tumble; fails the test if that does not work.
  void record_small(const std::string& name, const std::vector<std::string>& more = {}) const;

 private:
  std::string folder_;
};

/// Three boxes, one of them thrown in before step 5; 40 steps.
extern const char* const kSmallScene;

}  // namespace tumble::test
