#include "golden/expected/expected_file.h"

#include <algorithm>

#include "golden/expected/expected_codec.h"
#include "src/base/check.h"
#include "tumble/replay/prelude.h"

namespace tumble::golden {
namespace {

constexpr int kLevel = 19;  // written once, kept for ever

// Both sides of the file rely on this: unpack() makes an error of any other shape.
void check_shape(const Expected& expected) {
  SIM_CHECK(!expected.state_hashes.empty());
  SIM_CHECK(expected.step_words.size() == expected.steps(), expected.step_words.size(), expected.steps());
  SIM_CHECK(expected.phase_words.size() == expected.steps(), expected.phase_words.size(), expected.steps());
}

Result<std::vector<std::byte>> pack_once(const Expected& expected) {
  Result<replay::MessageBytes> message = encode(expected);
  if (!message.ok()) return message.error();
  std::vector<std::byte> stored;
  if (Status ok = replay::Compressor(kLevel).compress(message->bytes(), stored); !ok.ok()) return ok.error();
  replay::Prelude prelude;
  prelude.kind = replay::RecordKind::kGolden;
  prelude.first_step = 1;
  prelude.step_count = expected.steps();
  prelude.stored_bytes = stored.size();
  prelude.raw_bytes = message->bytes().size();
  prelude.stored_hash = hash_bytes(stored);
  prelude.log_tag = prelude.stored_hash.low;
  const auto head = replay::encode(prelude);
  std::vector<std::byte> file(head.begin(), head.end());
  file.insert(file.end(), stored.begin(), stored.end());
  return file;
}

Result<Expected> unpack_unnamed(std::span<const std::byte> file) {
  if (file.empty()) return damaged("the file is empty");
  if (!replay::starts_like_log(file.first(std::min(file.size(), replay::kMagicEnd)))) {
    return bad_input("is no golden: it does not begin as one");
  }
  if (file.size() < replay::kPreludeBytes) return damaged("torn at byte " + std::to_string(file.size()));
  Result<replay::Prelude> prelude = replay::decode_prelude(file.first<replay::kPreludeBytes>());
  if (!prelude.ok()) return prelude.error();
  if (prelude->kind != replay::RecordKind::kGolden) {
    return bad_input("found a " + std::string(replay::name_of(prelude->kind)) + ", wanted a golden: is it a log?");
  }
  const std::span<const std::byte> stored = file.subspan(replay::kPreludeBytes);
  if (stored.size() != prelude->stored_bytes) {
    return damaged("found " + std::to_string(stored.size()) + " bytes after the first 128, wanted " +
                   std::to_string(prelude->stored_bytes) + ": torn, or something was added");
  }
  if (hash_bytes(stored) != prelude->stored_hash) return damaged("the stored bytes are not those that were written");
  Result<replay::MessageBytes> message = replay::decompress(stored, prelude->raw_bytes, kGoldenBytesMax);
  if (!message.ok()) return message.error();
  Result<Expected> expected = decode(*message);
  if (expected.ok() && expected->steps() != prelude->step_count) {
    return damaged("found " + std::to_string(expected->steps()) + " steps, wanted " +
                   std::to_string(prelude->step_count));
  }
  return expected;
}

}  // namespace

Result<std::vector<std::byte>> pack(Expected expected) {
  check_shape(expected);
  if (expected.scene_text.size() > kSceneTextMax) expected.scene_text.clear();
  Result<std::vector<std::byte>> file = pack_once(expected);
  for (const PhaseDetail detail : {PhaseDetail::kStep, PhaseDetail::kNone}) {
    if (!file.ok() || file->size() <= kGoldenBytesWanted) break;
    if (detail >= expected.phase_detail) continue;
    reduce_phase_words(expected, detail);
    file = pack_once(expected);
  }
  return file;
}

Result<Expected> unpack(std::span<const std::byte> file, const std::string& name) {
  Result<Expected> expected = unpack_unnamed(file);
  if (!expected.ok()) return Error{expected.error().kind, name + ": " + expected.error().message};
  return expected;
}

}  // namespace tumble::golden
