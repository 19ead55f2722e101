#pragma once

#include "schema/log.capnp.h"
#include "tumble/replay/chunk.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

/// Converts a complete WorldState to the schema and back. Included by codecs only.
namespace tumble::replay {

/// About the number of bytes that the message will need.
std::size_t encoded_bytes(const sim::WorldState& state);

void encode(const Keyframe& keyframe, schema::Keyframe::Builder out);

/// Errors (kDamaged): columns differ in length, ids do not ascend, or a row number is out of range.
Result<Keyframe> decode(schema::Keyframe::Reader in);

}  // namespace tumble::replay
