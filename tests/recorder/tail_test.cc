// The tail of a stream: the frames of a recorder that was killed before they were in its file.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "replay/format/little_endian.h"
#include "replay/stream/stream_format.h"
#include "replay/stream/stream_tail.h"
#include "tests/recorder/recorded.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using replay::StreamReader;

StreamBytes bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

class Tail : public testing::Test {
 protected:
  /// Records in a child that ends without a word to its recorder; `steps_a_write` as in TumbleRecDef.
  void record_and_die(std::uint64_t bodies, std::uint64_t steps, std::uint32_t steps_a_write = 0) const {
    const pid_t child = ::fork();
    if (child == 0) {
      (void)record(
          bodies, steps, [](TumbleRec* rec) { ::_exit(tumble_rec_message(rec)[0] == 0 ? 0 : 1); },
          [&](TumbleRecDef& def) { to_file(def), def.steps_a_write = steps_a_write; });
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }

  void to_file(TumbleRecDef& def) const { def.write = nullptr, def.path = path_.c_str(); }

  /// The last step that is there.
  [[nodiscard]] std::uint64_t last_step(const StreamBytes& tail) const {
    auto file = std::make_shared<StreamBytes>(bytes_of(path_));
    auto source = replay::with_tail(std::make_unique<replay::MemoryByteSource>(file, "memory"), tail);
    const Result<StreamReader> stream = StreamReader::open(*std::move(source));
    EXPECT_TRUE(stream.ok());
    EXPECT_FALSE(stream->condition().damage) << *stream->condition().damage;
    return stream->steps().empty() ? 0 : stream->steps().back().step;
  }

  /// Records three bodies again, against the stream and its tail.
  void verify_steps(std::uint64_t steps) const {
    TumbleRecDef def = {};
    def.engine = "test engine";
    def.precision_bits = 24, def.gravity[2] = -10;
    def.verify = path_.c_str();
    (void)record(
        3, steps, [&](TumbleRec* end) { EXPECT_EQ(tumble_rec_steps_verified(end), steps) << tumble_rec_message(end); },
        [&](TumbleRecDef& to) { to = def; });
  }

  Workshop shop_;
  std::string path_ = shop_.path("run.tumblestream");
  std::string tail_ = path_ + replay::kStreamTailSuffix;
};

TEST_F(Tail, HasTheLastStepsOfAProcessThatDied) {
  record_and_die(3, 12);
  EXPECT_LT(last_step({}), 12U) << "the file alone lacks steps";
  const Outcome imported = shop_.run({"import", "run.tumblestream", "--json"});
  EXPECT_EQ(imported.exit, 0) << imported.err;
  EXPECT_NE(imported.out.find("\"steps\": 12"), std::string::npos) << imported.out;
  EXPECT_NE(imported.err.find("stopped after step 12"), std::string::npos) << imported.err;
  verify_steps(12);  // verify mode reads it too

  std::filesystem::rename(tail_, shop_.path("elsewhere"));
  const Outcome alone = shop_.run({"import", "run.tumblestream"});
  EXPECT_NE(alone.err.find("run.tumblestream.tail: found no such file"), std::string::npos) << alone.err;
  std::string other = shop_.read("elsewhere");
  other[16] = static_cast<char>(other[16] ^ 1);  // the tag of another session
  shop_.write("run.tumblestream.tail", other);
  const Outcome beside = shop_.run({"import", "run.tumblestream"});
  EXPECT_NE(beside.err.find("run.tumblestream.tail: is not the tail of this stream"), std::string::npos) << beside.err;
}

TEST_F(Tail, IsGoneOnceTheStreamIsClosed) {
  const auto file = [&](TumbleRecDef& def) { to_file(def); };
  (void)record(3, 12, {}, file);
  EXPECT_FALSE(std::filesystem::exists(tail_));
  EXPECT_EQ(bytes_of(path_), record(3, 12)) << "the same bytes as without it";
  (void)record(
      3, 12, [&](TumbleRec* rec) { EXPECT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_BAD_CALL); }, file);
  EXPECT_FALSE(std::filesystem::exists(tail_)) << "an error leaves nothing in it";
  EXPECT_EQ(last_step({}), 12U);
}

TEST_F(Tail, OfAnEarlierStreamIsNotMixedIn) {
  record_and_die(3, 12);
  const StreamBytes old = bytes_of(tail_);
  record_and_die(3, 5, 1);
  EXPECT_FALSE(std::filesystem::exists(tail_)) << "a recorder removes what the one before left";
  EXPECT_EQ(last_step({}), 5U);
  (void)record(4, 5, {}, [&](TumbleRecDef& def) { to_file(def), def.version = "2"; });
  EXPECT_EQ(last_step(old), 5U) << "finished, and another stream";

  shop_.write("run.tumblestream.tail", "a file of the user");
  record_and_die(3, 7);
  EXPECT_EQ(shop_.read("run.tumblestream.tail"), "a file of the user");
  EXPECT_EQ(last_step({}), 7U) << "without a tail each step is written";
}

TEST_F(Tail, TakesFramesLargerThanItself) {
  record_and_die(25000, 3);  // 1.5 MB a step
  EXPECT_EQ(last_step(bytes_of(tail_)), 3U);
}

/// A recorder that is killed between writing its file and emptying its tail.
TEST_F(Tail, MayHoldFramesThatTheFileHasToo) {
  record_and_die(3, 12);
  const StreamBytes tail = bytes_of(tail_);
  const std::span first = std::span(tail).subspan(replay::kStreamTailHeadBytes);
  const auto size = replay::kStreamFrameHeadBytes + replay::load<std::uint32_t>(first.data() + 4);
  std::ofstream file(path_, std::ios::binary | std::ios::app);
  file.write(reinterpret_cast<const char*>(first.data()), static_cast<std::streamsize>(size));
  file.close();
  EXPECT_EQ(last_step(tail), 12U);
  verify_steps(12);
}

TEST_F(Tail, DamagedAnywhereCostsStepsAndNothingElse) {
  record_and_die(2, 6);
  const StreamBytes whole = bytes_of(tail_);
  ASSERT_EQ(last_step(whole), 6U);
  for (std::size_t at = 0; at < 1500; ++at) {
    StreamBytes hurt = whole;
    hurt[at] ^= std::byte{16};
    EXPECT_LE(last_step(hurt), 6U) << at;  // expects that nothing is called damaged, too
    hurt.resize(at);
    EXPECT_LE(last_step(hurt), 6U) << at;
  }
}

}  // namespace
}  // namespace tumble::test
