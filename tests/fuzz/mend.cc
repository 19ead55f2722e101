#include "tests/fuzz/mend.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/zstd_frame.h"
#include "replay/format/chain.h"
#include "replay/format/little_endian.h"
#include "tumble/replay/prelude.h"

namespace tumble::fuzz {
namespace {

using replay::kPreludeBytes;
using replay::Prelude;
using replay::RecordKind;

constexpr std::size_t kRawBytesAt = 56;  // of the prelude's field

/// The numbers of a prelude whose hash nobody keeps right.
Prelude fields_of(std::span<const std::byte> bytes) {
  using replay::load;
  Prelude prelude;
  prelude.kind = static_cast<RecordKind>(load<std::uint16_t>(bytes.data() + 20));
  prelude.sequence = load<std::uint64_t>(bytes.data() + 24);
  prelude.first_step = load<std::uint64_t>(bytes.data() + 32);
  prelude.step_count = load<std::uint64_t>(bytes.data() + 40);
  return prelude;
}

/// The start of the chain, or its next link, as far as the message tells.
Hash128 chain_after(const Prelude& prelude, const replay::MessageBytes& message, Hash128 chain) {
  if (prelude.kind != RecordKind::kChunk) return chain;
  const Result<replay::ChunkDecoder> chunk = replay::ChunkDecoder::open(message);
  if (!chunk.ok()) return chain;
  for (std::size_t i = 0; i < chunk->step_count(); ++i) chain = chain_next(chain, chunk->without_states(i));
  return chain;
}

Hash128 chain_begin(std::span<const std::byte> header) {
  return {replay::load<std::uint64_t>(header.data() + 88), replay::load<std::uint64_t>(header.data() + 80)};
}

}  // namespace

Bytes laid_open(std::span<const std::byte> log) {
  Bytes open;
  while (log.size() >= kPreludeBytes) {
    const Result<Prelude> prelude = replay::decode_prelude(log.first<kPreludeBytes>());
    if (!prelude.ok() || prelude->kind == RecordKind::kFooter) break;
    const auto stored = log.subspan(kPreludeBytes, prelude->stored_bytes);
    const Result<replay::MessageBytes> message = replay::decompress(stored, prelude->raw_bytes, prelude->raw_bytes);
    if (!message.ok()) break;
    open.insert(open.end(), log.begin(), log.begin() + kPreludeBytes);
    open.insert(open.end(), message->bytes().begin(), message->bytes().end());
    log = log.subspan(kPreludeBytes + prelude->stored_bytes);
  }
  return open;
}

Bytes mended(std::span<const std::byte> open) {
  Bytes log;
  Bytes stored;
  replay::Compressor compressor;
  std::uint64_t tag = 0;
  Hash128 chain;
  while (open.size() >= kPreludeBytes) {
    Prelude prelude = fields_of(open);
    if (log.empty()) chain = chain_begin(open);
    const std::size_t room = (open.size() - kPreludeBytes) / 8 * 8;
    const auto claimed = replay::load<std::uint64_t>(open.data() + kRawBytesAt) / 8 * 8;
    replay::MessageBytes message(static_cast<std::size_t>(std::min<std::uint64_t>(claimed, room)));
    std::copy_n(open.begin() + kPreludeBytes, message.bytes().size(), message.bytes().begin());
    if (!compressor.compress(message.bytes(), stored).ok()) break;
    prelude.raw_bytes = message.bytes().size();
    prelude.stored_bytes = stored.size();
    prelude.stored_hash = hash_bytes(stored);
    if (prelude.kind == RecordKind::kHeader) tag = prelude.stored_hash.low;
    prelude.log_tag = tag;
    prelude.chain_before = chain;
    prelude.chain_after = chain = chain_after(prelude, message, chain);
    const auto encoded = encode(prelude);
    log.insert(log.end(), encoded.begin(), encoded.end());
    log.insert(log.end(), stored.begin(), stored.end());
    open = open.subspan(kPreludeBytes + message.bytes().size());
  }
  return log;
}

}  // namespace tumble::fuzz
