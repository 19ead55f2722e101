// Each canary of a check in shards is asked once; a shard whose canaries are others is named.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "golden/bundle/manifest.h"
#include "tests/support/golden_shards.h"
#include "tumble/golden/suite.h"

namespace tumble::golden {
namespace {

class MergeCanaries : public MadeShards {};

TEST_F(MergeCanaries, CountsACanaryThatItsShardDidNotCatch) {
  const std::size_t owner = shard_of_name("three", kShards);
  edit_report(owner, [](Json& report) {
    for (Json& one : report["canaries"]) one["caught"] = one["name"] != "three";
  });
  const Result<SuiteResult> merged = merge();
  ASSERT_TRUE(merged.ok()) << merged.error().message;
  EXPECT_FALSE(merged->canaries_caught());
  EXPECT_FALSE(merged->passed());
  EXPECT_EQ(merged->canaries.size(), 5U);
  EXPECT_EQ(merged->canaries[2].name, "three");
}

TEST_F(MergeCanaries, NamesTheShardWhoseCanariesWereNotAskedOnceEach) {
  const std::size_t of_one = shard_of_name("one", kShards), of_two = shard_of_name("two", kShards),
                    of_three = shard_of_name("three", kShards), of_four = shard_of_name("four", kShards);
  ASSERT_EQ((std::set<std::size_t>{of_one, of_two, of_three, of_four}.size()), 4U);
  edit(of_one, [](Manifest& m) { m.canaries.clear(); });
  edit(of_two, [](Manifest& m) { m.canaries.emplace_back("one"); });
  edit(of_three, [](Manifest& m) { m.facts.canaries.pop_back(); });
  const auto shard_text = [](std::size_t k) { return "shard " + std::to_string(k) + " of 20: "; };
  expect_error(ErrorKind::kDamaged, {shard_text(of_one) + "1 canary fell to it and 0 were asked",
                                     shard_text(of_two) + "1 canary fell to it and 2 were asked",
                                     shard_text(of_three) + "of another list of canaries: found 4 canaries"});
}

TEST_F(MergeCanaries, NamesTheReportWithOtherCanariesThanItsBundle) {
  const std::size_t owner = shard_of_name("four", kShards);
  edit_report(owner, [](Json& report) { report["canaries"] = Json::array(); });
  expect_error(ErrorKind::kDamaged,
               {(shard(owner) / kReportFile).string(), "its canaries are not those that bundle.json names"});
}

}  // namespace
}  // namespace tumble::golden
