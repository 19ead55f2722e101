// Keeps the promises that no compiler checks: who may include whom, how long files get, what the simulation must not
// touch, and that names, lists and documents agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>

#include "tests/support/source_tree.h"

namespace tumble::test {
namespace {

using Strings = std::set<std::string>;

// Which folders the code of a folder may include; the longest matching prefix counts. A folder includes itself.
const std::map<std::string, Strings>& allowed_includes() {
  static const Strings kSim = {"src/base/",    "src/math/",  "src/model/", "src/world/",
                               "src/collide/", "src/solve/", "src/step/"};
  static const Strings kLook = {"src/base/", "src/math/", "src/model/", "src/world/"};
  static const std::map<std::string, Strings> kAllowed = {
      {"src/base/", {}},
      {"src/math/", {"src/base/"}},
      {"src/model/", {"src/base/", "src/math/"}},
      {"src/world/", {"src/base/", "src/math/", "src/model/"}},
      {"src/collide/", kLook},
      {"src/solve/", {"src/base/", "src/math/", "src/model/", "src/world/", "src/collide/"}},
      {"src/step/", kSim},
      {"src/scenes/", {"src/base/", "src/math/", "src/model/"}},
      {"src/process/", {"src/base/"}},
      {"src/threads/", {"src/base/"}},
      {"src/render/", kLook},
      {"replay/", {"src/", "schema/"}},
      {"golden/", {"src/", "replay/", "schema/"}},
      {"tools/", {"src/", "replay/", "golden/"}},
      {"tests/", {"src/", "replay/", "golden/", "tools/", "schema/"}},
      {"bench/", {"src/", "replay/", "golden/", "tools/"}},
  };
  return kAllowed;
}

std::optional<std::string> layer_of(const std::string& path) {
  for (const auto& [layer, allowed] : allowed_includes()) {
    if (path.starts_with(layer)) return layer;
  }
  return std::nullopt;
}

bool may_include(const std::string& layer, const std::string& included) {
  const Strings& allowed = allowed_includes().at(layer);
  return included.starts_with(layer) ||
         std::ranges::any_of(allowed, [&](const std::string& prefix) { return included.starts_with(prefix); });
}

TEST(Tree, IncludesPointDownTheLayers) {
  const std::regex include("^#include \"([^\"]+)\"");
  std::size_t seen = 0;
  for (const SourceFile& file : source_tree()) {
    if (!file.is_code()) continue;
    const std::optional<std::string> layer = layer_of(file.path);
    ASSERT_TRUE(layer) << file.path << ": code outside the known folders; give its folder a row in allowed_includes()";
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      ++seen;
      const std::string included = match[1];
      EXPECT_TRUE(may_include(*layer, included)) << file.path << " must not include " << included;
      const bool is_there = std::filesystem::exists(std::filesystem::path(TUMBLE_SOURCE_DIR) / included);
      EXPECT_TRUE(is_there || included.ends_with(".capnp.h"))
          << file.path << ": " << included << " is not in the tree; includes are written from the repository root";
    }
  }
  EXPECT_GT(seen, 50U) << "the test saw hardly any includes, so it proves nothing";
}

// One rule about code in src: a pattern that must not occur, and why.
struct Ban {
  std::string pattern;
  std::string reason;
};

// Looks through src, but for one folder: unless said, that which draws. The one that owns threads decides no bit.
void expect_none(const std::vector<Ban>& bans, const std::string& except = "src/render/") {
  std::size_t seen = 0;
  for (const SourceFile& file : source_tree()) {
    if (!file.is_code() || !file.is_under("src/")) continue;
    if (file.is_under(except) || file.is_under("src/threads/")) continue;
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

TEST(Tree, SimulationTouchesNoFileClockThreadOrEnvironment) {
  expect_none(
      {{"#include <(chrono|ctime|time\\.h|sys/time\\.h)>", "the simulation knows no clock"},
       {"#include <(thread|mutex|future|atomic|condition_variable|pthread\\.h|omp\\.h)>", "nor threads"},
       {"#include <(fstream|iostream|filesystem|fcntl\\.h|unistd\\.h)>|\\b(fopen|f?printf|fputs|puts|fwrite)\\s*\\(",
        "nor files"},
       {"#include <(locale|clocale|locale\\.h)>|\\b(getenv|setlocale)\\b", "nor the environment"},
       {"#include <random>|\\b(rand|srand|random_device)\\s*\\(", "random numbers come from the project's generator"},
       {"\\bthread_local\\b|^\\s*#\\s*pragma omp", "nor threads"}});
}

TEST(Tree, SimulationIteratesOverNoHashMapOrAddress) {
  expect_none({{"unordered_(map|set|multimap|multiset)", "its order differs between libraries; use sorted columns"},
               {"std::(set|map)<[^,>]*\\*", "addresses differ from run to run"},
               {"\\bstd::(reduce|transform_reduce)\\b|std::execution", "sums in no fixed order"}});
}

TEST(Tree, SimulationUsesOnlyArithmeticWithOneAnswer) {
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

TEST(Tree, OnlySceneFilesKnowToml) {
  expect_none({{"toml\\+\\+|\\btoml::", "scenes are read in src/scenes"}}, "src/scenes/");
}

TEST(Tree, FilesStayShort) {
  constexpr std::size_t kLinesMax = 500;
  constexpr std::size_t kLinesLong = 250;
  constexpr double kLongShareMax = 0.1;  // a ratchet: lower it when the tree allows, never raise it
  std::size_t count = 0;
  std::string long_files;
  std::size_t long_count = 0;
  for (const SourceFile& file : source_tree()) {
    const bool counts = file.is_code() || file.ends_with(".sh") || file.ends_with("CMakeLists.txt") ||
                        file.ends_with(".cmake") || file.ends_with(".capnp");
    if (!counts) continue;
    ++count;
    EXPECT_LE(file.lines.size(), kLinesMax) << file.path << ": split it";
    if (file.lines.size() <= kLinesLong) continue;
    ++long_count;
    long_files += "\n  " + file.path + ": " + std::to_string(file.lines.size());
  }
  EXPECT_GT(count, 20U);
  EXPECT_LE(static_cast<double>(long_count), kLongShareMax * static_cast<double>(count))
      << "too many files over " << kLinesLong << " lines:" << long_files;
}

TEST(Tree, EverySourceFileIsInItsFoldersBuildList) {
  std::map<std::string, std::string> lists;
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with("CMakeLists.txt")) continue;
    std::string text = " ";
    for (const std::string& line : file.lines) text += line.substr(0, line.find('#')) + ' ';
    lists[file.path.substr(0, file.path.size() - std::string("CMakeLists.txt").size())] = text;
  }
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with(".cc")) continue;
    std::string folder = file.path;
    do {
      folder.resize(folder.find_last_of('/', folder.size() - 2) + 1);
    } while (!folder.empty() && !lists.contains(folder));
    const std::regex listed("[ (]" + std::regex_replace(file.path.substr(folder.size()), std::regex("\\."), "\\.") +
                            "[ )]");
    EXPECT_TRUE(std::regex_search(lists[folder], listed)) << file.path << " is not in " << folder << "CMakeLists.txt";
  }
}

TEST(Tree, HeadersAreGuardedOnce) {
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with(".h")) continue;
    EXPECT_EQ(std::ranges::count(file.lines, "#pragma once"), 1) << file.path;
  }
}

}  // namespace
}  // namespace tumble::test
