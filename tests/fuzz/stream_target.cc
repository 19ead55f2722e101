// A recorder's stream: read, imported into memory, and verified against by the recorder. The first byte says whether
// the rest is taken as it is, or its frames are sealed anew, so that changed payloads get past their hashes, and how
// many of the frames are in the stream's file, and the others in its tail.
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

#include "replay/format/little_endian.h"
#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"
#include "replay/recorder/tumble_recorder.h"
#include "replay/stream/import_stream.h"
#include "replay/stream/stream_tail.h"
#include "tests/fuzz/target.h"
#include "tumble/replay/log_reader.h"

namespace tumble::fuzz {
namespace {

using replay::MemoryFile;
using Bytes = std::vector<std::byte>;

/// Gives every frame its right length, number and hash.
void seal(Bytes& stream) {
  if (stream.size() < replay::kStreamPreludeBytes) return;
  std::memcpy(stream.data(), replay::kStreamMagic.data(), replay::kStreamMagic.size());
  replay::store<std::uint32_t>(stream.data() + 16, replay::kStreamMajor);
  std::uint64_t tag = 0, number = 0;
  for (std::size_t at = replay::kStreamPreludeBytes; at + replay::kStreamFrameHeadBytes <= stream.size(); ++number) {
    std::byte* head = stream.data() + at;
    const std::size_t left = stream.size() - at - replay::kStreamFrameHeadBytes;
    const auto size = std::min<std::size_t>(replay::load<std::uint32_t>(head + 4), left);
    if (number == 0) replay::store<std::uint32_t>(head, 1);
    replay::store(head + 4, static_cast<std::uint32_t>(size));
    replay::store(head + 8, number);
    const std::uint64_t hash = XXH64(head + replay::kStreamFrameHeadBytes, size, XXH64(head, 16, tag));
    replay::store(head + 16, hash);
    if (number == 0) tag = hash;
    at += replay::kStreamFrameHeadBytes + size;
  }
}

/// A stream's file, and its tail.
struct Files {
  Bytes stream;
  Bytes tail;
};

/// The first `count` frames stay; the others go to a tail. 0: no tail.
Files split(const Bytes& whole, std::size_t count) {
  if (count == 0 || whole.size() < replay::kStreamPreludeBytes + replay::kStreamFrameHeadBytes) return {whole, {}};
  std::size_t at = replay::kStreamPreludeBytes, last = at;
  for (std::size_t k = 0; k < count && at + replay::kStreamFrameHeadBytes <= whole.size(); ++k) {
    last = at;
    const std::size_t left = whole.size() - at - replay::kStreamFrameHeadBytes;
    at +=
        replay::kStreamFrameHeadBytes + std::min<std::size_t>(replay::load<std::uint32_t>(whole.data() + at + 4), left);
  }
  Files files = {{whole.begin(), whole.begin() + static_cast<long>(at)}, Bytes(replay::kStreamTailHeadBytes)};
  std::memcpy(files.tail.data(), replay::kStreamTailMagic.data(), replay::kStreamTailMagic.size());
  std::memcpy(files.tail.data() + 16, whole.data() + replay::kStreamPreludeBytes + 16, 8);
  std::memcpy(files.tail.data() + 24, whole.data() + last + 8, 16);  // number and hash
  files.tail.insert(files.tail.end(), whole.begin() + static_cast<long>(at), whole.end());
  return files;
}

/// What is imported is a whole log.
void import(const Files& files) {
  auto file = std::make_shared<Bytes>(files.stream);
  Result<std::unique_ptr<replay::ByteSource>> source =
      replay::with_tail(std::make_unique<replay::MemoryByteSource>(file, "stream"), files.tail);
  if (!source.ok()) std::abort();
  const Result<replay::StreamReader> stream = replay::StreamReader::open(*std::move(source));
  if (!stream.ok()) return;
  const auto written = std::make_shared<Bytes>();
  const Result<replay::StreamImport> done = import_stream(*stream, [&]() -> Result<std::unique_ptr<replay::ByteSink>> {
    return std::unique_ptr<replay::ByteSink>(std::make_unique<replay::MemoryByteSink>(written, "log"));
  });
  if (!done.ok()) return;
  Result<replay::LogReader> log = replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(written, "log"));
  if (!log.ok() || !replay::verify(*log).condition.sound()) std::abort();
}

/// A small session that tells one of everything.
void record_against(const std::string& path) {
  TumbleRecDef def = {};
  def.engine = "C engine";
  def.precision_bits = 53;
  def.gravity[2] = -9.81;
  def.ground = 1;
  def.phases = "collide,solve";
  def.rollback_steps = 2;
  def.verify = path.c_str();
  TumbleRec* rec = tumble_rec_create(&def);
  TumbleRecBody body = {};
  body.mass = body.size[0] = body.size[1] = body.size[2] = body.state.orientation[0] = 1;
  TumbleRecPoint point = {};
  const TumbleRecContact contact = {1, 2, 0, {0, 0, 1}, &point, 1};
  std::uint32_t channel = 0;
  tumble_rec_channel(rec, "joint.angle", TUMBLE_REC_OF_PAIR, TUMBLE_REC_F64, &channel);
  for (body.id = 1; body.id <= 2; ++body.id) tumble_rec_body(rec, &body);
  for (int k = 0; k < 4; ++k) {
    if (k == 2) tumble_rec_rewind(rec, 1);
    tumble_rec_step_begin(rec, 0.5);
    for (std::uint64_t id = 1; id <= 2; ++id) tumble_rec_state(rec, id, &body.state);
    tumble_rec_contact(rec, &contact);
    tumble_rec_phase_hash(rec, 1, 8);
    tumble_rec_value(rec, channel, 1, 2, &point.depth, 1);
    tumble_rec_step_end(rec);
  }
  tumble_rec_close(rec);
}

bool write_file(const std::string& path, const Bytes& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  std::fwrite(bytes.data(), 1, bytes.size(), file);
  return std::fclose(file) == 0;
}

void verify_against(const Files& files) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("tumble_fuzz_stream_" + std::to_string(::getpid()))).string();
  if (!write_file(path, files.stream)) return;
  if (!files.tail.empty() && !write_file(path + replay::kStreamTailSuffix, files.tail)) return;
  record_against(path);
  std::remove(path.c_str());
  std::remove((path + replay::kStreamTailSuffix).c_str());
}

}  // namespace
}  // namespace tumble::fuzz

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto rest = tumble::fuzz::as_bytes(data + 1, size - 1);
  tumble::fuzz::Bytes stream(rest.begin(), rest.end());
  if ((data[0] & 1U) != 0) tumble::fuzz::seal(stream);
  const tumble::fuzz::Files files = tumble::fuzz::split(stream, (data[0] >> 1U) % 8);
  tumble::fuzz::import(files);
  tumble::fuzz::verify_against(files);
  return 0;
}
