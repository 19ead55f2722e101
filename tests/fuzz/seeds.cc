// Makes the seed inputs: small logs of both methods, whole and laid open, and their messages. Usage: fuzz_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "golden/expected/expected_codec.h"
#include "replay/log/byte_memory.h"
#include "tests/fuzz/mend.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/prelude.h"

namespace tumble::fuzz {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, std::span<const std::byte> head, std::span<const std::byte> bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(head.data()), static_cast<std::streamsize>(head.size()));
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write(const fs::path& path, std::span<const std::byte> bytes) { write(path, {}, bytes); }

/// The first message of each kind, with the codec target's first byte.
void write_messages(const fs::path& folder, const std::string& name, std::span<const std::byte> open) {
  while (open.size() > replay::kPreludeBytes) {
    const Result<replay::Prelude> prelude = replay::decode_prelude(open.first<replay::kPreludeBytes>());
    if (!prelude.ok()) return;
    const auto which = static_cast<std::byte>(prelude->kind == replay::RecordKind::kHeader  ? 1
                                              : prelude->kind == replay::RecordKind::kIndex ? 2
                                                                                            : 0);
    write(folder / (name + "_" + replay::name_of(prelude->kind) + ".bin"), std::span(&which, 1),
          open.subspan(replay::kPreludeBytes, prelude->raw_bytes));
    open = open.subspan(replay::kPreludeBytes + prelude->raw_bytes);
  }
}

/// With the commands target's first byte: a log as it is, and one laid open that is answered in JSON.
void write_commands(const fs::path& folder, const std::string& name, std::span<const std::byte> log,
                    std::span<const std::byte> open) {
  const std::byte as_it_is{0}, laid_open_json{3};
  write(folder / (name + ".bin"), std::span(&as_it_is, 1), log);
  write(folder / (name + "_open.bin"), std::span(&laid_open_json, 1), open);
}

void write_golden(const fs::path& folder) {
  golden::Expected expected;
  expected.method = "thesis";
  expected.state_hashes.assign(3, Hash128{1, 2});
  expected.step_words.assign(2, 7);
  expected.phases = {"integrate", "freeze"};
  expected.phase_words.assign(2, std::vector<std::uint16_t>{1, 2});
  const Result<replay::MessageBytes> message = golden::encode(expected);
  const std::byte which{3};
  if (message.ok()) write(folder / "golden.bin", std::span(&which, 1), message->bytes());
}

/// A log of another engine with every kind of extra.
Bytes engine_log() {
  const auto file = std::make_shared<Bytes>();
  sim::SceneDef start;
  start.name = "engine";
  start.boxes.resize(2);
  start.boxes[0].id = 1;
  start.boxes[1].id = 2;
  replay::EngineDef def = {{"toy", "1"}};
  replay::Shape hull;
  hull.kind = replay::Shape::Kind::kHull;
  hull.points = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  def.declared.channels = {{"angle", {replay::ChannelKind::kFloat64, replay::ChannelScope::kBody}, "rad"},
                           {"force", {replay::ChannelKind::kFloat32, replay::ChannelScope::kPair}, "N"},
                           {"mode", {replay::ChannelKind::kText, replay::ChannelScope::kWorld}, ""}};
  def.declared.shapes = {hull};
  def.declared.bodies = {{1, "wheel", hash_of(hull)}};
  auto log = replay::EngineLog::create(std::make_unique<replay::MemoryByteSink>(file, "seed"), def, start);
  if (!log.ok()) return {};
  bool told = true;
  const auto tell = [&](const Status& status) { told = told && status.ok(); };
  for (int k = 1; k <= 8; ++k) {
    for (const sim::BodyId id : {1U, 2U}) {
      tell((*log)->set_value(0, 0.1 * k, {id, 0}));
      tell((*log)->set_state(id, {{0, 0, 1.0 * k}, {}, {0, 0, 0}, {0, 0, 0}, false}));
    }
    if (k > 3) tell((*log)->set_value(1, 0.5F * static_cast<float>(k), {1, 2}));
    tell((*log)->set_value(2, std::string("walk")));
    tell((*log)->add_contact({1, 2, {0, 0, 1}, {0, 0, 1}, 0.01, 0.1 * k}));
    tell((*log)->add_note("note"));
    tell((*log)->add_snapshot(std::as_bytes(std::span("state", 5))));
    tell((*log)->add_superseded({true, "position.x"}));
    tell((*log)->end_step(0.01));
  }
  if (!(*log)->finish().ok() || !told) return {};
  return *file;
}

void write_seeds(const fs::path& folder, const std::string& name, const Bytes& log) {
  const Bytes open = laid_open(log);
  write(folder / "log" / (name + ".bin"), log);
  write(folder / "messages" / (name + ".bin"), open);
  write_commands(folder / "commands", name, log, open);
  write_messages(folder / "codec", name, open);
}

void make_seeds(const fs::path& folder) {
  write_seeds(folder, "engine", engine_log());
  for (const sim::Method method : replay::kMethods) {
    const std::string name = name_of(method);
    write_seeds(folder, name, replay::record_to_memory(replay::scene_with_inputs(12, method), {}, 5));
  }
  write_golden(folder / "codec");
}

}  // namespace
}  // namespace tumble::fuzz

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  tumble::fuzz::make_seeds(argv[1]);
  return 0;
}
