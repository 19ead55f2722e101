#include "replay/view/state_frame.h"

#include <array>
#include <bit>
#include <cmath>
#include <type_traits>
#include <vector>

#include "replay/format/not_finite.h"

namespace tumble::replay {
namespace {

template <class T>
void append(std::string& out, T value) {
  using Word = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint16_t>;
  const auto word = std::bit_cast<Word>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) out += static_cast<char>(word >> (8 * i) & 255U);
}

template <class T>
void append_column(std::string& out, const std::vector<T>& column) {
  for (const T value : column) append(out, value);
}

std::int16_t sixteenth(double value) { return static_cast<std::int16_t>(std::lround(32767 * value)); }

}  // namespace

BodyMark mark_of(const BodyStates& states, std::size_t row) {
  if (!is_finite(states, row)) return BodyMark::kNotFinite;
  return states.frozen[row] != 0 ? BodyMark::kFrozen : BodyMark::kAwake;
}

void append_frame(std::uint64_t step, FrameStatus status, const BodyStates* states, ViewedBodies& table,
                  std::string& out) {
  const std::size_t count = states == nullptr ? 0 : states->size();
  std::vector<std::size_t> row(count);
  for (std::size_t i = 0; i < count; ++i) row[i] = table.row_of(states->id[i]);
  const std::size_t rows = states == nullptr ? 0 : table.bodies().size();
  append(out, static_cast<std::uint32_t>(step));
  append(out, static_cast<std::uint32_t>(status));
  append(out, static_cast<std::uint32_t>(rows));
  append(out, table.version());
  if (states == nullptr) return;
  std::array<std::vector<float>, 4> numbers;
  std::array<std::vector<std::int16_t>, 4> turns;
  for (auto& column : numbers) column.resize(rows);
  for (auto& column : turns) column.resize(rows);
  std::vector<std::uint8_t> marks(rows);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t r = row[i];
    const BodyMark mark = mark_of(*states, i);
    marks[r] = static_cast<std::uint8_t>(mark);
    if (mark == BodyMark::kNotFinite) continue;
    const sim::Vec3 x = states->position[i], v = states->velocity[i];
    const std::array<double, 4> place = {x.x(), x.y(), x.z(), sim::length(v)};
    const sim::Quat q = states->orientation[i];
    const std::array<double, 4> turn = {q.w, q.x, q.y, q.z};
    for (std::size_t c = 0; c < 4; ++c) {
      numbers[c][r] = static_cast<float>(place[c]);
      turns[c][r] = std::abs(turn[c]) <= 1 ? sixteenth(turn[c]) : std::int16_t{0};
    }
  }
  for (const auto& column : numbers) append_column(out, column);
  for (const auto& column : turns) append_column(out, column);
  out.append(marks.begin(), marks.end());
  out.append((4 - rows % 4) % 4, '\0');
}

}  // namespace tumble::replay
