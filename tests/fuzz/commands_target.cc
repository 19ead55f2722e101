// info, recover, replay and measure as the program runs them, one after the other on one file. The first byte of an
// input says whether the rest is a log as it is or one laid open, and whether JSON is asked for.
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "replay/log/verify.h"
#include "tests/fuzz/mend.h"
#include "tests/fuzz/program_place.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_log.h"
#include "tumble/replay/log_reader.h"

namespace tumble::fuzz {
namespace {

using tools::Exit;

constexpr unsigned kLaidOpen = 1;  // bits of the first byte
constexpr unsigned kJson = 2;
constexpr const char* kInput = "input.tumble";
constexpr const char* kOutput = "output.tumble";

class Commands {
 public:
  void use(std::span<const std::byte> log, bool json) {
    json_ = json;
    place_.write(kInput, log);
    place_.remove(kOutput);
    const Outcome info = run({"info"}, {Exit::kSame, Exit::kBadInput, Exit::kDamaged});
    recover(info);
    if (is_small()) {
      (void)run({"replay"}, {Exit::kSame, Exit::kDifference, Exit::kBadInput, Exit::kDamaged, Exit::kCannotFinish});
      (void)run({"measure"}, {Exit::kSame, Exit::kBadInput, Exit::kDamaged, Exit::kCannotFinish});
    }
    if (!std::ranges::equal(place_.read(kInput), log)) std::abort();  // all of them only read it
  }

 private:
  Outcome run(std::vector<std::string> arguments, std::initializer_list<Exit> allowed) {
    const std::string input = place_.path(kInput);
    arguments.insert(arguments.begin() + 1, input);
    if (json_) arguments.emplace_back("--json");
    Outcome outcome = place_.run(arguments);
    require_exit(outcome, allowed, input);
    const bool answers = outcome.exit == Exit::kSame || outcome.exit == Exit::kDifference;
    require(!answers || !outcome.out.empty(), "wanted a result", outcome);
    require(!json_ || outcome.out.empty() || nlohmann::json::accept(outcome.out), "wanted JSON", outcome);
    return outcome;
  }

  /// A log that is whole is recovered whole; what is written reads from end to end, and a refusal leaves nothing.
  void recover(const Outcome& info) {
    const Outcome outcome =
        run({"recover", "-o", place_.path(kOutput)}, {Exit::kSame, Exit::kBadInput, Exit::kDamaged});
    require(info.exit != Exit::kSame || outcome.exit == Exit::kSame, "wanted a whole log to be recovered", outcome);
    require(!place_.has_part_of(kOutput), "wanted no partial log left behind", outcome);
    require(outcome.exit != Exit::kSame || place_.has(kOutput), "wanted a new log", outcome);
    require(outcome.exit != Exit::kBadInput || !place_.has(kOutput), "wanted no log of what is none", outcome);
    if (!place_.has(kOutput)) return;
    const Outcome again = place_.run({"info", place_.path(kOutput)});
    Result<replay::LogReader> log = replay::LogReader::open(place_.path(kOutput));
    require(log.ok() && replay::verify(*log).condition.sound(), "wanted a recovered log that verifies", again);
    require(again.exit == Exit::kSame || outcome.exit == Exit::kDamaged, "wanted a recovered log to be whole", again);
  }

  [[nodiscard]] bool is_small() const {
    const Result<replay::LogReader> log = replay::LogReader::open(place_.path(kInput));
    return !log.ok() || (takes_a_moment(*log) && log->step_count() <= kStepsSimulated);
  }

  ProgramPlace place_;
  bool json_ = false;
};

}  // namespace
}  // namespace tumble::fuzz

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  static tumble::fuzz::Commands commands;
  if (size == 0) return 0;
  const auto rest = tumble::fuzz::as_bytes(data + 1, size - 1);
  const bool json = (data[0] & tumble::fuzz::kJson) != 0;
  if ((data[0] & tumble::fuzz::kLaidOpen) != 0) {
    commands.use(tumble::fuzz::mended(rest), json);
  } else {
    commands.use(rest, json);
  }
  return 0;
}
