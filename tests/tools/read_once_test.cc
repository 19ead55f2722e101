// diff of many logs reads each of them from end to end once.
#include <gtest/gtest.h>

#include <memory>

#include "tests/support/program.h"
#include "tools/compare/log_groups.h"
#include "tumble/replay/byte_io.h"

namespace tumble::test {
namespace {

/// Counts the bytes that are read of a file.
class CountingSource : public replay::ByteSource {
 public:
  CountingSource(std::unique_ptr<replay::ByteSource> source, std::uint64_t& read)
      : source_(std::move(source)), read_(read) {}
  [[nodiscard]] std::uint64_t size() const override { return source_->size(); }
  Status read(std::uint64_t offset, std::span<std::byte> bytes) const override {
    read_ += bytes.size();
    return source_->read(offset, bytes);
  }
  [[nodiscard]] std::string name() const override { return source_->name(); }

 private:
  std::unique_ptr<replay::ByteSource> source_;
  std::uint64_t& read_;
};

TEST(DiffOfMany, ReadsEachLogFromEndToEndOnce) {
  const Workshop shop;
  constexpr std::size_t kLogs = 12;
  shop.record_small("a", {"--steps", "2000"});
  shop.record_small("b", {"--steps", "2000", "--set", "input.1.velocity=[0.0, 6.5, 0.0]"});
  std::vector<std::uint64_t> read(kLogs, 0);
  std::vector<replay::LogReader> logs;
  for (std::size_t i = 0; i < kLogs; ++i) {
    Result<std::unique_ptr<replay::ByteSource>> file =
        replay::open_file_source(shop.path(i + 1 == kLogs ? "b.tumble" : "a.tumble"));
    ASSERT_TRUE(file.ok()) << file.error().message;
    Result<replay::LogReader> log =
        replay::LogReader::open(std::make_unique<CountingSource>(*std::move(file), read[i]));
    ASSERT_TRUE(log.ok()) << log.error().message;
    logs.push_back(*std::move(log));
  }
  const Result<tools::LogGroups> found = tools::group_logs(logs);
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->groups.size(), 2U);
  EXPECT_EQ(found->groups[0].logs.size(), kLogs - 1);
  EXPECT_EQ(found->groups[1].logs, std::vector<std::size_t>{kLogs - 1});
  const std::uint64_t size = shop.read("a.tumble").size();
  EXPECT_GE(read[0], size);
  // Once from end to end; the first log also for the first difference from the odd one.
  for (std::size_t i = 0; i + 1 < kLogs; ++i) EXPECT_LT(read[i], 4 * size) << "log " << i << " of " << size;
}

}  // namespace
}  // namespace tumble::test
