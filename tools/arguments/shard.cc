#include "tools/arguments/shard.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "src/base/text.h"
#include "tools/arguments/numbers.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kShardsMax = 10'000;
constexpr const char* kWanted = "wanted K/N with K from 1 to N, and N at most 10000, as in 2/5";

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// first: the number of the first part.
std::optional<Shard> shard_of(const std::string& part, const std::string& parts, std::uint64_t first) {
  const std::optional<std::uint64_t> k = parse_whole(part), n = parse_whole(parts);
  if (!k || !n || *n < 1 || *n > kShardsMax || *k < first || *k - first >= *n) return std::nullopt;
  return Shard{*k - first + 1, *n};
}

std::optional<Shard> shard_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  return shard_of(text.substr(0, slash), text.substr(slash + 1), 1);
}

Result<Shard> shard_of_pair(const char* part, const char* parts, std::uint64_t first) {
  const std::string k = variable(part), n = variable(parts);
  if (const std::optional<Shard> shard = shard_of(k, n, first)) return *shard;
  return bad_input("--shard auto: " + std::string(part) + "=" + in_quotes(k) + ", " + parts + "=" + in_quotes(n) +
                   ": wanted a part from " + std::to_string(first) + " and the number of parts");
}

Result<Shard> shard_of_environment() {
  if (const std::string text = variable("TUMBLE_SHARD"); !text.empty()) {
    if (const std::optional<Shard> shard = shard_of(text)) return *shard;
    return bad_input("--shard auto: TUMBLE_SHARD=" + in_quotes(text) + ": " + kWanted);
  }
  if (!variable("CI_NODE_TOTAL").empty()) return shard_of_pair("CI_NODE_INDEX", "CI_NODE_TOTAL", 1);
  if (!variable("TEST_TOTAL_SHARDS").empty()) {
    // Bazel runs a test that does not touch this file as often as there are shards, each time whole.
    const std::string status = variable("TEST_SHARD_STATUS_FILE");
    if (!status.empty() && !std::ofstream(status, std::ios::app)) {
      return cannot_finish("--shard auto: TEST_SHARD_STATUS_FILE=" + in_quotes(status) + ": cannot be written");
    }
    return shard_of_pair("TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS", 0);
  }
  return bad_input(
      "--shard auto: found none of TUMBLE_SHARD (K/N), CI_NODE_INDEX and CI_NODE_TOTAL, TEST_SHARD_INDEX and "
      "TEST_TOTAL_SHARDS; set one of them, or give --shard K/N");
}

}  // namespace

Result<Shard> read_shard(const std::string& text) {
  if (text.empty()) return Shard{};
  if (text == "auto") return shard_of_environment();
  if (const std::optional<Shard> shard = shard_of(text)) return *shard;
  return bad_input("--shard: found " + in_quotes(text) + ", " + kWanted + ", or auto");
}

}  // namespace tumble::tools
