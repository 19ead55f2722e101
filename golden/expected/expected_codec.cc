#include "golden/expected/expected_codec.h"

#include <algorithm>
#include <string>

#include "golden/expected/extras_codec.h"
#include "replay/codec/blob.h"
#include "replay/codec/message.h"
#include "schema/golden.capnp.h"
#include "tumble/replay/body_states.h"
#include "tumble/sim/limits.h"

namespace tumble::golden {
namespace {

using replay::get_differences;
using replay::get_planes;
using replay::put_differences;
using replay::put_planes;

template <class T>
std::span<const T> view(const std::vector<T>& values) {
  return values;
}

unsigned bytes_for(std::size_t count, std::size_t size) { return static_cast<unsigned>(count * size); }

void put_ids(const std::vector<sim::BodyId>& ids, capnp::Data::Builder out) { put_differences(view(ids), out); }

Status get_ids(capnp::Data::Reader in, std::vector<sim::BodyId>& ids) {
  if (Status ok = get_differences("id", in, in.size() / 8, ids); !ok.ok()) return ok;
  if (std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end()) return {};
  return damaged("found body ids that do not ascend");
}

std::vector<std::uint64_t> words_of(const std::vector<Hash128>& hashes) {
  std::vector<std::uint64_t> words;
  for (const Hash128& hash : hashes) words.insert(words.end(), {hash.low, hash.high});
  return words;
}

void encode_words(const Expected& expected, schema::Expected::Builder out) {
  std::vector<std::uint32_t> counts;
  std::vector<std::uint16_t> words;
  for (const std::vector<std::uint16_t>& step : expected.phase_words) {
    counts.push_back(static_cast<std::uint32_t>(step.size()));
    words.insert(words.end(), step.begin(), step.end());
  }
  put_planes(view(counts), out.initPhaseWordCount(bytes_for(counts.size(), 4)));
  put_planes(view(words), out.initPhaseWords(bytes_for(words.size(), 2)));
}

void encode_state(const KeyState& key, schema::State::Builder out) {
  out.setStep(key.step);
  put_ids(key.states.id, out.initId(bytes_for(key.states.size(), 8)));
  const replay::ConstColumns columns = replay::columns_of(key.states);
  auto lists = out.initColumns(replay::kColumnCount);
  for (unsigned c = 0; c < replay::kColumnCount; ++c) {
    const std::vector<std::uint64_t> bits = replay::bits_of(view(*columns[c]));
    put_planes(view(bits), lists.init(c, bytes_for(bits.size(), 8)));
  }
  replay::put_plain(view(key.states.frozen), out.initFrozen(bytes_for(key.states.size(), 1)));
}

void encode_coordinate(const std::vector<std::int32_t>& values, capnp::Data::Builder out) {
  const std::vector<std::uint32_t> words(values.begin(), values.end());
  put_planes(view(words), out);
}

void encode_track(const TrackPoint& point, schema::TrackPoint::Builder out) {
  out.setStep(point.step);
  put_ids(point.id, out.initId(bytes_for(point.id.size(), 8)));
  encode_coordinate(point.x, out.initX(bytes_for(point.x.size(), 4)));
  encode_coordinate(point.y, out.initY(bytes_for(point.y.size(), 4)));
  encode_coordinate(point.z, out.initZ(bytes_for(point.z.size(), 4)));
}

void encode_provenance(const Provenance& from, schema::Provenance::Builder out) {
  out.setCommit(from.commit);
  out.setTree(from.tree);
  out.setCompiler(from.compiler);
  out.setFlags(from.flags);
  out.setMachine(from.machine);
  out.setDate(from.date);
  out.setSeconds(from.seconds);
}

Status encode_root(const Expected& expected, schema::Expected::Builder out) {
  out.setToolVersion(expected.provenance.version);
  out.setSceneText(expected.scene_text);
  if (!expected.provenance.date.empty()) encode_provenance(expected.provenance, out.initProvenance());
  out.setMethod(expected.method);
  out.setMethodVersion(expected.method_version);
  out.setSceneLow(expected.scene.low);
  out.setSceneHigh(expected.scene.high);
  out.setStepCount(expected.steps());
  const std::vector<std::uint64_t> hashes = words_of(expected.state_hashes);
  replay::put_plain(view(hashes), out.initStateHash(bytes_for(hashes.size(), 8)));
  put_planes(view(expected.step_words), out.initStepWord(bytes_for(expected.step_words.size(), 4)));
  auto phases = out.initPhases(static_cast<unsigned>(expected.phases.size()));
  for (unsigned i = 0; i < phases.size(); ++i) phases.set(i, expected.phases[i]);
  out.setPhaseDetail(static_cast<std::uint8_t>(expected.phase_detail));
  out.setPhaseHashVersion(expected.phase_hash_version);
  encode_words(expected, out);
  out.setContinuationLow(expected.continuation.low);
  out.setContinuationHigh(expected.continuation.high);
  auto hashes_of_bodies = out.initBodyHashes(static_cast<unsigned>(expected.body_hashes.size()));
  for (unsigned i = 0; i < hashes_of_bodies.size(); ++i) {
    const BodyHashes& from = expected.body_hashes[i];
    hashes_of_bodies[i].setStep(from.step);
    put_ids(from.id, hashes_of_bodies[i].initId(bytes_for(from.id.size(), 8)));
    put_planes(view(from.hash), hashes_of_bodies[i].initHash(bytes_for(from.hash.size(), 4)));
  }
  auto states = out.initStates(static_cast<unsigned>(expected.states.size()));
  for (unsigned i = 0; i < states.size(); ++i) encode_state(expected.states[i], states[i]);
  auto track = out.initTrack(static_cast<unsigned>(expected.track.size()));
  for (unsigned i = 0; i < track.size(); ++i) encode_track(expected.track[i], track[i]);
  if (expected.extras) encode(*expected.extras, out);
  if (expected.shapes) encode(*expected.shapes, out);
  return expected.setup ? encode(*expected.setup, out) : Status();
}

Status decode_hashes(schema::Expected::Reader in, Expected& out) {
  const std::uint64_t steps = in.getStepCount();
  if (steps > sim::kStepsMax) return damaged("found " + std::to_string(steps) + " steps, more than any session has");
  std::vector<std::uint64_t> words;
  if (Status ok = replay::get_plain("stateHash", in.getStateHash(), 2 * (steps + 1), words); !ok.ok()) return ok;
  for (std::size_t i = 0; i < words.size(); i += 2) out.state_hashes.push_back({words[i + 1], words[i]});
  return get_planes("stepWord", in.getStepWord(), steps, out.step_words);
}

Status decode_words(schema::Expected::Reader in, Expected& out) {
  for (const capnp::Text::Reader name : in.getPhases()) out.phases.emplace_back(name.cStr(), name.size());
  if (in.getPhaseDetail() > static_cast<std::uint8_t>(PhaseDetail::kSubstep)) {
    return bad_input("found phase detail " + std::to_string(in.getPhaseDetail()) +
                     ", which this program does not know; use a newer one");
  }
  out.phase_detail = static_cast<PhaseDetail>(in.getPhaseDetail());
  std::vector<std::uint32_t> counts;
  std::vector<std::uint16_t> words;
  if (Status ok = get_planes("phaseWordCount", in.getPhaseWordCount(), out.steps(), counts); !ok.ok()) return ok;
  std::size_t total = 0;
  for (const std::uint32_t count : counts) total += count;
  if (total > 0 && out.phases.empty()) return damaged("found phase words without phases");
  if (Status ok = get_planes("phaseWords", in.getPhaseWords(), total, words); !ok.ok()) return ok;
  auto from = words.begin();
  for (const std::uint32_t count : counts) {
    out.phase_words.emplace_back(from, from + count);
    from += count;
  }
  return {};
}

Status decode_state(schema::State::Reader in, KeyState& out) {
  out.step = in.getStep();
  if (Status ok = get_ids(in.getId(), out.states.id); !ok.ok()) return ok;
  const auto lists = in.getColumns();
  if (lists.size() != replay::kColumnCount) return damaged("found " + std::to_string(lists.size()) + " columns");
  const replay::Columns columns = replay::columns_of(out.states);
  std::vector<std::uint64_t> bits;
  for (unsigned c = 0; c < replay::kColumnCount; ++c) {
    if (Status ok = get_planes(replay::kColumnNames[c], lists[c], out.states.size(), bits); !ok.ok()) return ok;
    replay::doubles_of(bits, *columns[c]);
  }
  return replay::get_plain("frozen", in.getFrozen(), out.states.size(), out.states.frozen);
}

Status decode_coordinate(capnp::Data::Reader in, std::size_t count, std::vector<std::int32_t>& out) {
  std::vector<std::uint32_t> words;
  if (Status ok = get_planes("track", in, count, words); !ok.ok()) return ok;
  out.assign(words.begin(), words.end());
  return {};
}

Status decode_track(schema::TrackPoint::Reader in, TrackPoint& out) {
  out.step = in.getStep();
  if (Status ok = get_ids(in.getId(), out.id); !ok.ok()) return ok;
  if (Status ok = decode_coordinate(in.getX(), out.id.size(), out.x); !ok.ok()) return ok;
  if (Status ok = decode_coordinate(in.getY(), out.id.size(), out.y); !ok.ok()) return ok;
  return decode_coordinate(in.getZ(), out.id.size(), out.z);
}

Status decode_body_hashes(schema::BodyHashes::Reader in, BodyHashes& out) {
  out.step = in.getStep();
  if (Status ok = get_ids(in.getId(), out.id); !ok.ok()) return ok;
  return get_planes("hash", in.getHash(), out.id.size(), out.hash);
}

/// Each element by its own decoder; steps ascend and lie within the session.
template <class List, class T, class Decode>
Status decode_list(const char* what, List in, std::uint64_t steps, std::vector<T>& out, Decode decode_one) {
  for (const auto element : in) {
    T value;
    if (Status ok = decode_one(element, value); !ok.ok()) return ok;
    if (value.step > steps || (!out.empty() && value.step <= out.back().step)) {
      return damaged(std::string(what) + ": found step " + std::to_string(value.step) + " out of order");
    }
    out.push_back(std::move(value));
  }
  return {};
}

Provenance decode_provenance(schema::Provenance::Reader in) {
  Provenance out;
  out.commit = in.getCommit().cStr();
  out.tree = in.getTree().cStr();
  out.compiler = in.getCompiler().cStr();
  out.flags = in.getFlags().cStr();
  out.machine = in.getMachine().cStr();
  out.date = in.getDate().cStr();
  out.seconds = in.getSeconds();
  return out;
}

Result<Expected> decode_root(schema::Expected::Reader in) {
  Expected out;
  out.scene_text = in.getSceneText().cStr();
  if (in.hasProvenance()) out.provenance = decode_provenance(in.getProvenance());
  out.provenance.version = in.getToolVersion().cStr();
  out.method = in.getMethod().cStr();
  out.method_version = in.getMethodVersion();
  out.phase_hash_version = in.getPhaseHashVersion();
  out.scene = {in.getSceneHigh(), in.getSceneLow()};
  out.continuation = {in.getContinuationHigh(), in.getContinuationLow()};
  if (Status ok = decode_hashes(in, out); !ok.ok()) return ok.error();
  if (Status ok = decode_words(in, out); !ok.ok()) return ok.error();
  const std::uint64_t steps = out.steps();
  Status ok = decode_list("bodyHashes", in.getBodyHashes(), steps, out.body_hashes, decode_body_hashes);
  if (ok.ok()) ok = decode_list("states", in.getStates(), steps, out.states, decode_state);
  if (ok.ok()) ok = decode_list("track", in.getTrack(), steps, out.track, decode_track);
  if (ok.ok()) ok = decode(in, steps, out.extras);
  if (ok.ok()) ok = decode(in, out.shapes);
  if (ok.ok()) ok = decode(in, out.setup);
  if (!ok.ok()) return ok.error();
  return out;
}

}  // namespace

Result<replay::MessageBytes> encode(const Expected& expected) {
  const std::size_t guess = expected.steps() * 300 + 4096;
  Status done;
  Result<replay::MessageBytes> message = replay::write_message<schema::Expected>(
      guess, [&](schema::Expected::Builder out) { done = encode_root(expected, out); });
  if (!done.ok()) return done.error();
  return message;
}

Result<Expected> decode(const replay::MessageBytes& message) {
  return replay::read_message<schema::Expected>(message, decode_root);
}

}  // namespace tumble::golden
