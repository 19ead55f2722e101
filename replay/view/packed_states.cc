#include "replay/view/packed_states.h"

#include <algorithm>
#include <cmath>

#include "replay/view/state_frame.h"

namespace tumble::replay {
namespace {

constexpr double kPlaceMax = 2e9 * PackedStates::kQuantum;  // m; states lie far within

std::int32_t place_of(double metres) {
  return static_cast<std::int32_t>(std::llround(std::clamp(metres, -kPlaceMax, kPlaceMax) / PackedStates::kQuantum));
}

/// Small numbers of either sign as small numbers.
template <class Word, class Signed>
Word zigzag(Word value) {
  const auto number = static_cast<Signed>(value);
  return static_cast<Word>(static_cast<Word>(value << 1U) ^ static_cast<Word>(number < 0 ? ~Word{0} : Word{0}));
}

/// Where the two values before would lead; sums wrap around, which unpacking undoes.
template <class Word>
struct Course {
  Word one = 0, two = 0;
  Word residual(Word value) {
    const auto expected = static_cast<Word>(2 * one - two);
    two = one;
    one = value;
    return static_cast<Word>(value - expected);
  }
};

}  // namespace

void PackedStates::add(std::uint64_t step, const BodyStates& states, ViewedBodies& table) {
  std::vector<std::size_t> row(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) row[i] = table.row_of(states.id[i]);
  const std::size_t rows = table.bodies().size();
  Frame frame;
  if (!frames_.empty()) frame = frames_.back();
  frame.place.resize(3 * rows);
  frame.turn.resize(4 * rows);
  frame.mark.assign(rows, 0);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::size_t r = row[i];
    const BodyMark mark = mark_of(states, i);
    frame.mark[r] = static_cast<std::uint8_t>(mark);
    if (mark == BodyMark::kNotFinite) continue;
    const sim::Vec3 x = states.position[i];
    for (int c = 0; c < 3; ++c) frame.place[3 * r + static_cast<std::size_t>(c)] = place_of(x[c]);
    const sim::Quat q = states.orientation[i];
    const double turn[4] = {q.w, q.x, q.y, q.z};
    for (std::size_t c = 0; c < 4; ++c) {
      frame.turn[4 * r + c] = static_cast<std::int16_t>(std::lround(32767 * std::clamp(turn[c], -1.0, 1.0)));
    }
  }
  steps_.push_back(step);
  frames_.push_back(std::move(frame));
}

std::string PackedStates::planes(const std::vector<std::size_t>& frames, std::size_t bodies) const {
  const std::size_t cells = frames.size() * bodies;
  std::string out(21 * cells, '\0');
  std::size_t at = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t cell = 0;
    for (std::size_t r = 0; r < bodies; ++r) {
      Course<std::uint32_t> course;
      for (const std::size_t f : frames) {
        const auto& place = frames_[f].place;
        const std::int32_t value = 3 * r < place.size() ? place[3 * r + axis] : 0;
        const auto word = zigzag<std::uint32_t, std::int32_t>(course.residual(static_cast<std::uint32_t>(value)));
        for (std::size_t p = 0; p < 4; ++p) out[at + p * cells + cell] = static_cast<char>(word >> (8 * p) & 255U);
        ++cell;
      }
    }
    at += 4 * cells;
  }
  for (std::size_t part = 0; part < 4; ++part) {
    std::size_t cell = 0;
    for (std::size_t r = 0; r < bodies; ++r) {
      Course<std::uint16_t> course;
      for (const std::size_t f : frames) {
        const auto& turn = frames_[f].turn;
        const std::int16_t value = 4 * r < turn.size() ? turn[4 * r + part] : std::int16_t{0};
        const auto word = zigzag<std::uint16_t, std::int16_t>(course.residual(static_cast<std::uint16_t>(value)));
        for (std::size_t p = 0; p < 2; ++p) out[at + p * cells + cell] = static_cast<char>(word >> (8 * p) & 255U);
        ++cell;
      }
    }
    at += 2 * cells;
  }
  std::size_t cell = 0;
  for (std::size_t r = 0; r < bodies; ++r) {
    for (const std::size_t f : frames) {
      out[at + cell++] = static_cast<char>(r < frames_[f].mark.size() ? frames_[f].mark[r] : 0);
    }
  }
  return out;
}

}  // namespace tumble::replay
