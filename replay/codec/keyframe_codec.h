#pragma once

#include "replay/format/chunk.h"
#include "schema/log.capnp.h"
#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/world_state.h"

/// A complete WorldState to and from the schema. Included by codecs only.
namespace tumble::replay {

/// Bytes that the message will need, roughly.
std::size_t encoded_bytes(const sim::WorldState& state);

void encode(const Keyframe& keyframe, schema::Keyframe::Builder out);

/// Errors: kDamaged where columns disagree in length, ids do not ascend, or a row does not exist.
Result<Keyframe> decode(schema::Keyframe::Reader in);

}  // namespace tumble::replay
