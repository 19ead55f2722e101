#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "replay/stream/stream_step.h"
#include "tumble/replay/extras.h"
#include "tumble/replay/imported_table.h"

/// The contacts of a stream as a log keeps them: points, and a channel for what no point says.
namespace tumble::replay {

/// The contact points of a step in SI units, z up.
std::vector<EngineContact> contacts_of(const StreamStep& step, const EngineAxes& axes);

/// Channels of bytes, of pairs and, where b is the ground, of bodies. A pair has a value in a step where one of its
/// contacts has no points or a part other than 0: of each of its contacts, in their order, u32 part, u32 number of
/// points and, where that is 0, f64 × 3 normal, little-endian.
inline constexpr const char* kPairContacts = "told.contacts";
inline constexpr const char* kGroundContacts = "told.ground_contacts";

/// The values of these channels in a step, by the name of the channel and its bodies.
std::map<std::pair<std::string, ChannelKey>, std::string> contacts_told(const StreamStep& step, const EngineAxes& axes);

/// Adds the names of those channels that a step has values of.
void add_contact_channels(const StreamStep& step, std::map<std::string, ChannelType>& channels);

}  // namespace tumble::replay
