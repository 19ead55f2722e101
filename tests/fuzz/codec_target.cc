// Messages without any file around them. The first byte says which kind the rest is.
#include <algorithm>

#include "golden/expected/expected_codec.h"
#include "replay/codec/chunk_codec.h"
#include "replay/codec/header_codec.h"
#include "replay/codec/index_codec.h"
#include "tests/fuzz/target.h"

namespace tumble::fuzz {
namespace {

void decode_chunk(const replay::MessageBytes& message) {
  Result<replay::ChunkDecoder> chunk = replay::ChunkDecoder::open(message);
  if (!chunk.ok()) return;
  for (std::size_t i = 0; i < chunk->step_count(); ++i) {
    if (!chunk->step(i).ok()) return;
  }
}

}  // namespace
}  // namespace tumble::fuzz

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto bytes = tumble::fuzz::as_bytes(data + 1, size - 1);
  tumble::replay::MessageBytes message(bytes.size() / 8 * 8);
  std::copy_n(bytes.begin(), message.bytes().size(), message.bytes().begin());
  switch (data[0] % 4) {
    case 0:
      tumble::fuzz::decode_chunk(message);
      break;
    case 1:
      (void)tumble::replay::decode_header(message).ok();
      break;
    case 2:
      (void)tumble::replay::decode_index(message).ok();
      break;
    default:
      (void)tumble::golden::decode(message).ok();
      break;
  }
  return 0;
}
