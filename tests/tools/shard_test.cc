// --shard and the variables that --shard auto reads.
#include "tools/arguments/shard.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

using Variables = std::vector<std::pair<const char*, std::string>>;

// "2/5", or "error: " and the message.
std::string shard(const std::string& text, const Variables& variables = {}) {
  for (const char* name : {"TUMBLE_SHARD", "CI_NODE_INDEX", "CI_NODE_TOTAL", "TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS",
                           "TEST_SHARD_STATUS_FILE"}) {
    ::unsetenv(name);
  }
  for (const auto& [name, value] : variables) ::setenv(name, value.c_str(), 1);
  const Result<tools::Shard> found = tools::read_shard(text);
  return found.ok() ? std::to_string(found->k) + "/" + std::to_string(found->n) : "error: " + found.error().message;
}

TEST(Shard, IsReadFromTheCommandLine) {
  EXPECT_EQ(shard(""), "1/1");
  EXPECT_EQ(shard("2/5"), "2/5");
  for (const char* wrong : {"0/5", "6/5", "2", "/5", "2/", "a/b", "2/0", "1/10001"}) {
    EXPECT_TRUE(shard(wrong).starts_with("error: --shard: found \"" + std::string(wrong))) << wrong;
  }
}

TEST(Shard, IsReadFromTheEnvironment) {
  EXPECT_EQ(shard("auto", {{"TUMBLE_SHARD", "3/7"}, {"CI_NODE_INDEX", "1"}, {"CI_NODE_TOTAL", "2"}}), "3/7");
  EXPECT_EQ(shard("auto", {{"CI_NODE_INDEX", "2"}, {"CI_NODE_TOTAL", "2"}}), "2/2");
  EXPECT_EQ(shard("auto", {{"TEST_SHARD_INDEX", "0"}, {"TEST_TOTAL_SHARDS", "4"}}), "1/4");
  EXPECT_EQ(shard("auto", {{"TEST_SHARD_INDEX", "3"}, {"TEST_TOTAL_SHARDS", "4"}}), "4/4");
  EXPECT_EQ(shard("1/1", {{"TUMBLE_SHARD", "3/7"}}), "1/1") << "what is given counts";
}

TEST(Shard, NamesTheVariableThatIsWrong) {
  EXPECT_TRUE(holds(shard("auto"), "found none of TUMBLE_SHARD"));
  EXPECT_TRUE(holds(shard("auto", {{"TUMBLE_SHARD", "8/7"}}), "TUMBLE_SHARD=\"8/7\""));
  EXPECT_TRUE(holds(shard("auto", {{"CI_NODE_TOTAL", "2"}}), "CI_NODE_INDEX=\"\""));
  EXPECT_TRUE(holds(shard("auto", {{"CI_NODE_INDEX", "0"}, {"CI_NODE_TOTAL", "2"}}), "CI_NODE_INDEX=\"0\""));
  EXPECT_TRUE(holds(shard("auto", {{"TEST_SHARD_INDEX", "4"}, {"TEST_TOTAL_SHARDS", "4"}}), "TEST_SHARD_INDEX=\"4\""));
}

TEST(Shard, TouchesTheFileThatBazelAsksFor) {
  const Workshop shop;
  const Variables variables = {{"TEST_SHARD_INDEX", "1"}, {"TEST_TOTAL_SHARDS", "2"}};
  Variables more = variables;
  more.emplace_back("TEST_SHARD_STATUS_FILE", shop.path("status"));
  EXPECT_EQ(shard("auto", more), "2/2");
  EXPECT_TRUE(std::filesystem::exists(shop.path("status")));
  more.back().second = shop.path("none/status");
  EXPECT_TRUE(holds(shard("auto", more), "cannot be written"));
}

}  // namespace
}  // namespace tumble::test
