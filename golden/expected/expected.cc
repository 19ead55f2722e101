#include "tumble/golden/expected.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "replay/format/chain.h"
#include "src/base/check.h"
#include "tumble/replay/body_states.h"

namespace tumble::golden {
namespace {

// Limit for the states and body hashes of one golden before compression, bytes: a suite of fifty stays small enough for
// git.
constexpr std::size_t kStatesBytes = 200'000;
constexpr std::size_t kHashesBytes = 40'000;
constexpr std::size_t kTrackBytes = 100'000;
constexpr std::size_t kStateBytesEach = 105;
constexpr std::size_t kHashBytesEach = 5;
constexpr std::size_t kTrackBytesEach = 13;

/// `count` steps from 0 to the last, evenly spread.
std::vector<std::uint64_t> spread(std::uint64_t steps, std::size_t count) {
  std::vector<std::uint64_t> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(steps * i / (count - 1));
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Folds the substeps' rows into one by a multiplicative hash, word by word, so that their order counts. The factor is
/// 2^64 over the golden ratio (Knuth, The Art of Computer Programming 3, section 6.4), whose high bits mix best.
std::vector<std::uint16_t> folded(const std::vector<std::uint16_t>& words, std::size_t phase_count) {
  std::vector<std::uint64_t> row(phase_count, 0);
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::uint64_t& word = row[i % phase_count];
    word = (word ^ words[i]) * 0x9E3779B97F4A7C15;
  }
  std::vector<std::uint16_t> out;
  out.reserve(row.size());
  for (const std::uint64_t word : row) out.push_back(static_cast<std::uint16_t>(word >> 48));
  return out;
}

std::int32_t millimetres(double metres) {
  constexpr double kMax = std::numeric_limits<std::int32_t>::max();
  const double mm = std::floor(metres * 1000 + 0.5);
  return mm != mm ? 0 : static_cast<std::int32_t>(std::clamp(mm, -kMax, kMax));
}

TrackPoint track_point(std::uint64_t step, const replay::BodyStates& states) {
  TrackPoint point;
  point.step = step;
  point.id = states.id;
  for (std::size_t i = 0; i < states.size(); ++i) {
    point.x.push_back(millimetres(states.position.x[i]));
    point.y.push_back(millimetres(states.position.y[i]));
    point.z.push_back(millimetres(states.position.z[i]));
  }
  return point;
}

}  // namespace

std::uint32_t step_word(const replay::StepRecord& record, bool with_extras) {
  const Hash128 hash = with_extras ? replay::chain_next({}, record) : replay::chain_next_of_states({}, record);
  return static_cast<std::uint32_t>(hash.low);
}

std::vector<std::uint16_t> phase_words_of(const replay::StepRecord& record, std::size_t phase_count,
                                          PhaseDetail detail) {
  std::vector<std::uint16_t> words;
  if (detail == PhaseDetail::kNone || phase_count == 0) return words;
  for (const std::uint64_t word : record.phase_words) words.push_back(static_cast<std::uint16_t>(word));
  return detail == PhaseDetail::kSubstep ? words : folded(words, phase_count);
}

void reduce_phase_words(Expected& expected, PhaseDetail detail) {
  SIM_CHECK(detail < expected.phase_detail);
  expected.phase_detail = detail;
  for (std::vector<std::uint16_t>& words : expected.phase_words) {
    words = detail == PhaseDetail::kNone ? std::vector<std::uint16_t>() : folded(words, expected.phases.size());
  }
}

BodyHashes hash_bodies(std::uint64_t step, const replay::BodyStates& states) {
  BodyHashes out{.step = step, .id = states.id, .hash = {}};
  const replay::ConstColumns columns = replay::columns_of(states);
  Hasher hasher;
  for (std::size_t i = 0; i < states.size(); ++i) {
    hasher.reset();
    hasher.add(states.id[i]);
    for (const std::vector<double>* column : columns) hasher.add((*column)[i]);
    hasher.add(std::uint64_t{states.frozen[i]});
    out.hash.push_back(static_cast<std::uint32_t>(hasher.digest().low));
  }
  return out;
}

// Evenly spread steps find the neighbourhood of a difference in a session of any length. Their number shrinks as bodies
// grow in number, because git keeps every version of every golden; the exact values of any other step can be had by
// recording the scene again.
Milestones choose_milestones(std::uint64_t steps, std::size_t bodies) {
  const std::size_t each = std::max<std::size_t>(bodies, 1);
  const auto fitting = [&](std::size_t budget, std::size_t bytes) { return budget / (bytes * each); };
  Milestones out;
  // If not even start and end fit, the golden has hashes of bodies instead of states.
  const std::size_t states = fitting(kStatesBytes, kStateBytesEach);
  if (states >= 2) out.states = spread(steps, std::min<std::size_t>(states, 5));
  out.body_hashes = spread(steps, std::clamp<std::size_t>(fitting(kHashesBytes, kHashBytesEach), 2, 17));
  out.track = spread(steps, std::clamp<std::size_t>(fitting(kTrackBytes, kTrackBytesEach), 2, 33));
  return out;
}

ExpectedBuilder::ExpectedBuilder(const replay::LogHeader& header, std::uint64_t steps, const Hash128& scene)
    : milestones_(choose_milestones(steps, header.scene.boxes.size())),
      extras_(header.declared.channels),
      shapes_(header),
      setup_(header) {
  expected_.provenance.version = TUMBLE_VERSION;
  expected_.method = header.method;
  expected_.method_version = header.method_version;
  expected_.scene = scene;
  expected_.phases = header.phases;
  expected_.phase_hash_version = header.phase_hash_version;
}

void ExpectedBuilder::add(const replay::StepRecord& record) {
  SIM_CHECK(record.step == expected_.state_hashes.size(), record.step, expected_.state_hashes.size());
  expected_.state_hashes.push_back(record.state_hash);
  if (record.step > 0) {
    expected_.step_words.push_back(step_word(record, false));
    expected_.phase_words.push_back(phase_words_of(record, expected_.phases.size(), expected_.phase_detail));
  }
  extras_.add(record);
  shapes_.add(record);
  setup_.add(record);
  const auto is_in = [&](const std::vector<std::uint64_t>& steps) {
    return std::ranges::binary_search(steps, record.step);
  };
  if (is_in(milestones_.body_hashes)) expected_.body_hashes.push_back(hash_bodies(record.step, record.states));
  if (is_in(milestones_.states)) expected_.states.push_back({record.step, record.states});
  if (is_in(milestones_.track)) expected_.track.push_back(track_point(record.step, record.states));
}

Expected ExpectedBuilder::finish(const Hash128& continuation) {
  expected_.continuation = continuation;
  expected_.extras = extras_.finish();
  expected_.shapes = shapes_.shapes();
  expected_.setup = setup_.finish();
  return std::move(expected_);
}

}  // namespace tumble::golden
