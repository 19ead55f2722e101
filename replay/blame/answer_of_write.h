#pragma once

#include <cstddef>
#include <optional>

#include "replay/blame/blame_answer.h"
#include "replay/blame/body_account.h"
#include "tumble/sim/scene.h"

/// The answer that a phase's change of one value is, and what it came from.
namespace tumble::replay {

/// What a change came from, by its largest part.
struct Source {
  enum class Kind : std::uint8_t {
    kValue,    ///< another value of the same body, before the phase
    kContact,  ///< a contact
    kGravity,  ///< gravity, without a contact
    kEnd,      ///< nothing that can be followed
  };
  Kind kind = Kind::kEnd;
  std::size_t field = 0;             ///< kValue
  std::optional<sim::BodyId> other;  ///< kContact; none: the ground
};

/// The last write before `end` that changed the field; none.
std::optional<std::size_t> last_change(const BodyAccount& account, std::size_t field, std::size_t end);

/// The write with the largest change of the field, the later of two; none where no write changes it.
std::optional<std::size_t> largest_change(const BodyAccount& account, std::size_t field);

/// The answer about a field, with shares and a sentence.
BlameAnswer answer_of(const BodyAccount& account, const Write& write, std::size_t field);

/// Where to look next.
Source source_of(const BodyAccount& account, std::size_t write, std::size_t field);

}  // namespace tumble::replay
