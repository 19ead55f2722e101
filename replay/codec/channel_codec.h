#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "schema/log.capnp.h"
#include "tumble/replay/channel.h"
#include "tumble/sim/result.h"

/// Rows of values that belong to bodies or pairs, over the steps of a chunk. Included by codecs only.
namespace tumble::replay {

/// The rows of all steps, one after the other.
struct StepRows {
  std::vector<std::uint32_t> counts;  ///< rows of each step
  std::vector<std::uint8_t> same;     ///< 1: a step has the keys of the step before
  std::vector<ChannelKey> keys;       ///< of all rows

  /// Adds the rows of the next step.
  void add_step(std::span<const ChannelKey> next);
};

void encode(const StepRows& rows, ChannelScope scope, schema::Rows::Builder out);

/// `left`: the rows that the chunk may still have; reduced. Allocates nothing that the caller's `row_bytes` (bytes that
/// each row takes elsewhere in the message, at least) and `value_bytes` (bytes there) do not cover. `each_once`: keys
/// must differ within a step. Errors (kDamaged): sizes that do not fit, keys that do not ascend.
struct RowLimits {
  std::uint64_t& left;
  std::uint64_t row_bytes;
  std::uint64_t value_bytes;
  bool each_once = true;
};
Result<StepRows> decode(schema::Rows::Reader in, ChannelScope scope, std::size_t step_count, const RowLimits& limits);

/// Differences of each row's value to the value of the same row of the step before, where its keys are equal, else to
/// the row before in its step. Small where values change little. Word: std::uint64_t or std::uint32_t.
template <class Word>
std::vector<Word> residuals_of(const StepRows& rows, std::span<const Word> values);
/// The other way.
template <class Word>
std::vector<Word> values_of(const StepRows& rows, std::vector<Word> residuals);

/// The values of channel `channel` in all steps. Errors of decoding: kDamaged.
void encode(std::size_t channel, ChannelType type, std::span<const ChannelValues* const> steps,
            schema::ChannelValues::Builder out);
Status decode(schema::ChannelValues::Reader in, ChannelType type, std::span<ChannelValues* const> steps,
              std::uint64_t& rows_left);

}  // namespace tumble::replay
