#pragma once

#include <cstddef>
#include <cstdint>

#include "replay/blame/steps_again.h"
#include "tumble/sim/result.h"

/// Steps found by the states after them alone, backward.
namespace tumble::replay {

struct StepFound {
  std::uint64_t step = 0;
  bool lost = false;  ///< the log lacks this step: up to here the value was as it was asked for, and may be so before
};

/// The value after step k; 0 where there is no such body. Errors: StepsAgain::after's.
Result<double> value_after(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field);

/// The last step up to k whose state differs in the field from the one before it, or before which there was no such
/// body; the log's first state, where none does. Errors: StepsAgain::after's.
Result<StepFound> step_it_changed(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field);

/// The last step up to k in which the greater part of the value arose: before it, the value was further away than half
/// of it, or there was no such body. Likewise else.
Result<StepFound> step_it_began(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field);

/// The last step up to k in which the value did not change by `fall` alone, to a billionth; likewise else.
Result<StepFound> step_before_fall(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field,
                                   double fall);

}  // namespace tumble::replay
