#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "replay/view/channel_history.h"
#include "tools/output/text.h"
#include "tumble/replay/channel.h"
#include "tumble/replay/step_record.h"

namespace tumble::tools {

inline constexpr std::size_t kPairsShown = 24;

/// One body in one state, to the last bit: {"id", "step", "frozen", "fields": [{"field", "value", "hex"}], "channels":
/// [{"field", "value", "channel", "with"}], "pairs"}; null where the state has no such body. The channels are those of
/// the body, and of its pairs up to kPairsShown, of which there are "pairs"; "channel": by index in
/// replay::channel_columns(), null where it is no number; "with": the other body of a pair, null otherwise.
Json body_json(const replay::StepRecord& record, sim::BodyId id, const std::vector<replay::Channel>& channels);

/// Columns, a step each: {"step", "value"}, null where there is none, and "next": the step to ask for next. from: the
/// first step that was asked for.
Json channel_history_json(std::uint64_t from, std::span<const replay::ChannelMoment> history);

}  // namespace tumble::tools
