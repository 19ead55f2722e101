#include "replay/codec/index_codec.h"

#include <string>

#include "replay/codec/message.h"
#include "replay/format/limits.h"
#include "schema/log.capnp.h"

namespace tumble::replay {

Result<MessageBytes> encode_index(const std::vector<ChunkPlace>& chunks) {
  return write_message<schema::Index>(chunks.size() * 72, [&](schema::Index::Builder out) {
    auto entries = out.initChunks(static_cast<unsigned>(chunks.size()));
    for (unsigned i = 0; i < entries.size(); ++i) {
      entries[i].setOffset(chunks[i].offset);
      entries[i].setLength(chunks[i].length);
      entries[i].setFirstStep(chunks[i].first_step);
      entries[i].setStepCount(static_cast<std::uint32_t>(chunks[i].step_count));
      entries[i].setChainAfterLow(chunks[i].chain_after.low);
      entries[i].setChainAfterHigh(chunks[i].chain_after.high);
      entries[i].setHashLow(chunks[i].stored_hash.low);
      entries[i].setHashHigh(chunks[i].stored_hash.high);
    }
  });
}

Result<std::vector<ChunkPlace>> decode_index(const MessageBytes& message) {
  using Places = std::vector<ChunkPlace>;
  return read_message<schema::Index>(message, [](schema::Index::Reader in) -> Result<Places> {
    const auto entries = in.getChunks();
    if (entries.size() > kChunksMax) return damaged("index: found " + std::to_string(entries.size()) + " chunks");
    Places places;
    places.reserve(entries.size());
    for (const schema::Index::Entry::Reader entry : entries) {
      places.push_back({entry.getOffset(),
                        entry.getLength(),
                        entry.getFirstStep(),
                        entry.getStepCount(),
                        {entry.getChainAfterHigh(), entry.getChainAfterLow()},
                        {entry.getHashHigh(), entry.getHashLow()}});
    }
    return places;
  });
}

}  // namespace tumble::replay
