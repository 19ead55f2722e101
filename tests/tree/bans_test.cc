// Code that the simulation must not hold, since its bits would depend on the machine or on chance
// (docs/determinism.md).
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "tests/support/source_tree.h"

namespace tumble::test {
namespace {

// One rule about code in src: a pattern that must not occur, and why.
struct Ban {
  std::string pattern;
  std::string reason;
};

// Whether a file's code decides bits: threads, files and child processes do not, and a failed check ends the process.
bool decides_bits(const SourceFile& file) {
  return file.is_code() && file.is_under("src/") && !file.is_under("src/threads/") && !file.is_under("src/process/") &&
         !file.is_under("src/files/") && file.path != "src/base/check.cc";
}

// Looks through the code of src that decides bits, without one folder: by default the one that draws.
void expect_none(const std::vector<Ban>& bans, const std::string& except = "src/render/") {
  std::size_t seen = 0;
  for (const SourceFile& file : source_tree()) {
    if (!decides_bits(file) || file.is_under(except)) continue;
    const std::vector<std::string> code = without_comments_and_strings(file.lines);
    seen += code.size();
    for (const Ban& ban : bans) {
      const std::regex pattern(ban.pattern);
      for (std::size_t i = 0; i < code.size(); ++i) {
        EXPECT_FALSE(std::regex_search(code[i], pattern))
            << file.path << ':' << i + 1 << ": " << file.lines[i] << "\n  " << ban.reason;
      }
    }
  }
  EXPECT_GT(seen, 500U) << "the test saw hardly any code, so it proves nothing";
}

TEST(Bans, SimulationTouchesNoFileClockThreadOrEnvironment) {
  expect_none(
      {{"#include <(chrono|ctime|time\\.h|sys/time\\.h)>", "the simulation knows no clock"},
       {"#include <(thread|mutex|future|condition_variable|pthread\\.h|omp\\.h)>", "nor threads"},
       {"#include <(fstream|iostream|filesystem|fcntl\\.h|unistd\\.h)>|\\b(fopen|f?printf|fputs|puts|fwrite)\\s*\\(",
        "nor files"},
       {"#include <(locale|clocale|locale\\.h)>|\\b(getenv|setlocale)\\b", "nor the environment"},
       {"#include <random>|\\b(rand|srand|random_device)\\s*\\(", "random numbers come from the project's generator"},
       {"\\bthread_local\\b|^\\s*#\\s*pragma omp", "nor threads"}});
  expect_none({{"#include <atomic>", "workers share numbers through src/base/workers.h alone"}}, "src/base/workers.h");
}

TEST(Bans, SimulationIteratesOverNoHashMapOrAddress) {
  expect_none({{"unordered_(map|set|multimap|multiset)", "its order differs between libraries; use sorted columns"},
               {"std::(set|map)<[^,>]*\\*", "addresses differ from run to run"},
               {"\\bstd::(reduce|transform_reduce)\\b|std::execution", "sums in no fixed order"}});
}

TEST(Bans, SimulationUsesOnlyArithmeticWithOneAnswer) {
  expect_none(
      {{"(^|[^\\w.:>]|std::|Eigen::numext::)(a?(sin|cos|tan)h?|atan2|exp(2|m1)?|log(2|10|1p)?|pow|cbrt|hypot|fma|erfc?|"
        "[tl]gamma|lerp)[fl]?\\s*\\(",
        "libm's answer depends on machine and library; only sqrt, fabs and floor are the same everywhere"},
       {"\\bf(min|max)[fl]?\\s*\\(", "fmin and fmax of +0 and -0 vary; use std::min and std::max"},
       {"[.>](norm|normalize|normalized|stableNorm|squaredNorm|dot|cross|sum|prod|mean|trace|determinant|inverse)\\(\\)"
        "?",
        "Eigen's reductions change with the vector width; use the parenthesised products of src/math"},
       {"Eigen::(Quaternion|AngleAxis|Rotation2D|Transform|Array)", "their products change with the vector width"},
       {"\\blong double\\b|\\bfloat\\b", "the simulation computes in double"},
       {"-ffast-math|#\\s*pragma\\s+(GCC(?!\\s+diagnostic)|clang|STDC)|__attribute__\\s*\\(\\(\\s*optimize",
        "flags are set for the whole build"}});
}

TEST(Bans, OnlySceneFilesKnowToml) {
  expect_none({{"toml\\+\\+|\\btoml::", "scenes are read in src/scenes"}}, "src/scenes/");
}

}  // namespace
}  // namespace tumble::test
