#pragma once

#include <string>
#include <vector>

#include "tests/support/program.h"

/// A table of another engine's states, and its import.
namespace tumble::test {

inline constexpr const char* kTableColumns =
    "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
    "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,frozen\n";

/// Two bodies, four steps, z up. In step 2 the spin of body 2 begins with `spin`.
inline std::string table(const std::string& spin = "0") {
  std::string text = std::string("# engine: toy\n# dt: 0.1\n") + kTableColumns;
  for (int k = 0; k < 5; ++k) {
    const std::string step = std::to_string(k);
    text += step + ",1,0,0,0.5,1,0,0,0,0,0,0,0,0,0,0\n";
    text += step + ",2,3,0,0." + std::to_string(5 + k) + ",1,0,0,0,0,0,1," + (k == 2 ? spin : "0") + ",0,0,0\n";
  }
  return text;
}

inline Outcome import(const Workshop& shop, const std::string& text, const std::vector<std::string>& more = {}) {
  shop.write("t.csv", text);
  std::vector<std::string> arguments = {"import", "t.csv", "-o", "t.tumble"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return shop.run(arguments);
}

inline bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace tumble::test
