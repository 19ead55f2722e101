#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>

namespace tumble::files {

/// wait() lasts until every other process that has the gate opens it or ends.
class Gate {
 public:
  Gate() { EXPECT_EQ(::pipe(ends_.data()), 0); }
  ~Gate() { open(); }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;
  void wait() {
    ::close(ends_[1]);
    char none = 0;
    EXPECT_EQ(::read(ends_[0], &none, 1), 0);
  }
  void open() {
    for (int& end : ends_) {
      if (end >= 0) ::close(end);
      end = -1;
    }
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

}  // namespace tumble::files
