// Logs of builds that do not exist yet.
#include <capnp/dynamic.h>
#include <capnp/message.h>
#include <capnp/schema-parser.h>
#include <gtest/gtest.h>
#include <kj/filesystem.h>

#include <algorithm>

#include "replay/codec/header_codec.h"
#include "replay/codec/message.h"
#include "replay/log/verify.h"
#include "tests/fuzz/mend.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

/// A sample's header read, changed by a schema that is newer than this program's, and put back.
class FutureLog {
 public:
  FutureLog() {
    const kj::Path path = files_->getCurrentPath().evalNative(TUMBLE_SOURCE_DIR "/tests/data/future_log.capnp");
    root_ = parser_.parseFromDirectory(files_->getRoot(), path.clone(), nullptr);
    open_ = fuzz::laid_open(record_to_memory(scene_with_inputs(12), {}, 6));
  }

  /// change(header): a capnp::DynamicStruct::Builder of the future's Header.
  template <class Change>
  Bytes with_header(Change change) {
    const std::size_t raw = decode_prelude(std::span<const std::byte>(open_).first<kPreludeBytes>())->raw_bytes;
    MessageBytes message(raw);
    std::copy_n(open_.begin() + kPreludeBytes, raw, message.bytes().begin());
    const auto* words = reinterpret_cast<const capnp::word*>(message.bytes().data());
    capnp::FlatArrayMessageReader reader(kj::arrayPtr(words, raw / sizeof(capnp::word)));
    const auto header = root_.getNested("Header").asStruct();
    capnp::MallocMessageBuilder builder;
    builder.setRoot(reader.getRoot<capnp::DynamicStruct>(header));
    change(builder.getRoot<capnp::DynamicStruct>(header));
    const kj::Array<capnp::word> flat = capnp::messageToFlatArray(builder);
    return put_back(std::as_bytes(std::span(flat.begin(), flat.size())), raw);
  }

 private:
  [[nodiscard]] Bytes put_back(std::span<const std::byte> header, std::size_t raw) const {
    Prelude prelude = *decode_prelude(std::span<const std::byte>(open_).first<kPreludeBytes>());
    prelude.raw_bytes = header.size();
    const auto encoded = encode(prelude);
    Bytes open(encoded.begin(), encoded.end());
    open.insert(open.end(), header.begin(), header.end());
    open.insert(open.end(), open_.begin() + static_cast<std::ptrdiff_t>(kPreludeBytes + raw), open_.end());
    return fuzz::mended(open);
  }

  kj::Own<kj::Filesystem> files_ = kj::newDiskFilesystem();
  capnp::SchemaParser parser_;
  capnp::ParsedSchema root_;
  Bytes open_;
};

TEST(NewerLogs, FieldsThatThisProgramDoesNotKnowAreIgnored) {
  const Bytes bytes = FutureLog().with_header([](capnp::DynamicStruct::Builder header) {
    header.set("wind", 12.5);
    header.set("weather", "rain");
    header.get("scene").as<capnp::DynamicStruct>().set("seasons", 4);
  });
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok()) << log.error().message;
  const VerifyReport verified = verify(*log);
  EXPECT_EQ(verified.states_checked, 12U);
  // The header is longer than the index knows; nothing else is wrong.
  ASSERT_EQ(verified.condition.damages.size(), 1U);
  EXPECT_EQ(verified.condition.damages.front().kind, RecordKind::kIndex);
  const Result<ReplayReport> report = replay_log(*log);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->identical());
}

TEST(NewerLogs, PhasesThatThisProgramDoesNotKnowLeaveStatesToCompare) {
  const Bytes bytes = FutureLog().with_header(
      [](capnp::DynamicStruct::Builder header) { header.get("phases").as<capnp::DynamicList>().set(1, "blow_wind"); });
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok()) << log.error().message;
  const Result<ReplayReport> report = replay_log(*log);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->identical());
  EXPECT_NE(report->notes.front().find("only states are compared"), std::string::npos) << report->notes.front();
}

TEST(NewerLogs, AnInputThatThisProgramDoesNotKnowIsNamed) {
  const Bytes bytes = FutureLog().with_header([](capnp::DynamicStruct::Builder header) {
    auto input = header.get("scene").as<capnp::DynamicStruct>().get("inputs").as<capnp::DynamicList>()[0];
    input.as<capnp::DynamicStruct>().set("explode", 3.5);
    input.as<capnp::DynamicStruct>().set("kind", "explode");
  });
  const Result<LogReader> log = open_memory(bytes);
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  for (const char* part : {"memory.tumble", "kind \"explode\"", "before step 3", "use a newer one"}) {
    EXPECT_NE(log.error().message.find(part), std::string::npos) << log.error().message;
  }
}

TEST(NewerLogs, ANewerMajorVersionSaysWhichIsNeededAndIsNotRecoveredAway) {
  Bytes bytes = record_to_memory(small_scene(), {}, 6);
  Prelude prelude = *decode_prelude(std::span<const std::byte>(bytes).first<kPreludeBytes>());
  prelude.major = 3;
  const auto encoded = encode(prelude);
  std::copy(encoded.begin(), encoded.end(), bytes.begin());
  const Result<LogReader> log = open_memory(bytes);
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(log.error().message.find("writes or reads version 3"), std::string::npos) << log.error().message;
}

}  // namespace
}  // namespace tumble::replay
