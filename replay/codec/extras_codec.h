#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "schema/log.capnp.h"
#include "tumble/replay/extras.h"
#include "tumble/sim/result.h"

/// The extras of consecutive steps, as one struct of the schema and back. Included by codecs only.
namespace tumble::replay {

/// Kind and scope of each channel of a chunk, by index; those of channels without values are unspecified.
using ChannelTypes = std::vector<ChannelType>;

/// types: of all channels that have values.
void encode(std::span<const Extras* const> steps, std::uint64_t first_step, const ChannelTypes& types,
            schema::Extras::Builder out);

/// Fills empty extras. Returns the channels that have values, with index and type. Errors (kDamaged): a value that no
/// writer produces.
Result<std::vector<std::pair<std::size_t, ChannelType>>> decode(schema::Extras::Reader in, std::uint64_t first_step,
                                                                std::span<Extras* const> steps);

}  // namespace tumble::replay
