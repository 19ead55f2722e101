#include "replay/codec/chunk_codec.h"

#include <algorithm>
#include <new>
#include <string>

#include "replay/codec/blob.h"
#include "replay/codec/extras_codec.h"
#include "replay/codec/keyframe_codec.h"
#include "replay/codec/message.h"
#include "replay/codec/scene_codec.h"
#include "replay/codec/state_codec.h"
#include "replay/format/limits.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

// Numbers of steps are stored as columns, one Data field for each quantity. A list of structs would put unlike bytes
// side by side, and zstd would find few repetitions (see "Chunks" in docs/log_format.md).

using Steps = std::span<const StepRecord>;

/// One number of each step as a column.
template <class T, class Get>
void put_column(Steps steps, capnp::Data::Builder out, Get get) {
  for (std::size_t i = 0; i < steps.size(); ++i) store<T>(bytes_of(out) + i * sizeof(T), get(steps[i]));
}

void encode_inputs(Steps steps, schema::Chunk::Builder out) {
  std::size_t count = 0;
  for (const StepRecord& step : steps) count += step.inputs.size();
  auto inputs = out.initInputs(static_cast<unsigned>(count));
  unsigned next = 0;
  for (const StepRecord& step : steps) {
    for (const sim::Command& command : step.inputs) encode(sim::TimedCommand{step.step, command}, inputs[next++]);
  }
}

void encode_hashes(Steps steps, schema::Chunk::Builder out) {
  const auto n = static_cast<unsigned>(steps.size());
  std::vector<std::uint64_t> hashes;
  std::vector<std::uint64_t> words;
  std::size_t longest = 0;
  for (const StepRecord& step : steps) {
    hashes.push_back(step.state_hash.low);
    hashes.push_back(step.state_hash.high);
    longest = std::max(longest, step.phase_words.size());
  }
  // Word j of all steps, then word j + 1: a phase that does not change its result repeats its word from step to step.
  for (std::size_t j = 0; j < longest; ++j) {
    for (const StepRecord& step : steps) {
      if (step.phase_words.size() > j) words.push_back(step.phase_words[j]);
    }
  }
  put_plain(std::span<const std::uint64_t>(hashes), out.initStateHash(n * 16));
  put_plain(std::span<const std::uint64_t>(words), out.initPhaseWords(static_cast<unsigned>(words.size() * 8)));
  put_column<std::uint32_t>(steps, out.initPhaseWordCount(n * 4),
                            [](const StepRecord& step) { return static_cast<std::uint32_t>(step.phase_words.size()); });
}

void encode_counters(Steps steps, schema::Chunk::Builder out) {
  const auto n = static_cast<unsigned>(steps.size());
  const auto u32 = [&](capnp::Data::Builder column, std::uint32_t sim::StepCounters::*field) {
    put_column<std::uint32_t>(steps, column, [field](const StepRecord& step) { return step.counters.*field; });
  };
  const auto f64 = [&](capnp::Data::Builder column, double sim::StepCounters::*field) {
    put_column<std::uint64_t>(steps, column, [field](const StepRecord& step) { return bits_of(step.counters.*field); });
  };
  u32(out.initPairs(n * 4), &sim::StepCounters::pairs);
  u32(out.initContacts(n * 4), &sim::StepCounters::contacts);
  u32(out.initSubsteps(n * 4), &sim::StepCounters::substeps);
  f64(out.initKinetic(n * 8), &sim::StepCounters::kinetic);
  f64(out.initPotential(n * 8), &sim::StepCounters::potential);
  f64(out.initInputEnergy(n * 8), &sim::StepCounters::inputs);
  f64(out.initRemovedEnergy(n * 8), &sim::StepCounters::removed);
}

void encode_steps(Steps steps, schema::Chunk::Builder out) {
  const auto n = static_cast<unsigned>(steps.size());
  encode_inputs(steps, out);
  encode_hashes(steps, out);
  encode_counters(steps, out);
  put_column<std::uint64_t>(steps, out.initDt(n * 8), [](const StepRecord& step) { return bits_of(step.dt); });
  put_column<std::uint8_t>(steps, out.initHasStates(n),
                           [](const StepRecord& step) { return static_cast<std::uint8_t>(step.has_states ? 1 : 0); });
}

/// Calls set(step, value) down a column.
template <class T, class Set>
Status get_column(const char* name, capnp::Data::Reader in, std::vector<StepRecord>& steps, Set set) {
  if (Status ok = check_size(name, in, steps.size(), sizeof(T)); !ok.ok()) return ok;
  for (std::size_t i = 0; i < steps.size(); ++i) set(steps[i], load<T>(bytes_of(in) + i * sizeof(T)));
  return {};
}

Status decode_inputs(schema::Chunk::Reader in, Chunk& chunk) {
  std::uint64_t before = chunk.first_step;
  const auto inputs = in.getInputs();
  if (inputs.size() > sim::kInputsMax) return damaged("chunk: found more inputs than a session may have");
  std::vector<std::size_t> counts(chunk.steps.size());  // reserved exactly: a growing vector takes twice the memory
  for (const schema::Input::Reader input : inputs) {
    const std::uint64_t index = input.getStep() - chunk.first_step;
    if (index < counts.size()) ++counts[index];
  }
  for (std::size_t i = 0; i < counts.size(); ++i) chunk.steps[i].inputs.reserve(counts[i]);
  for (const schema::Input::Reader input : inputs) {
    Result<sim::TimedCommand> command = decode(input);
    if (!command.ok()) return command.error();
    if (command->step < before || command->step - chunk.first_step >= chunk.steps.size()) {
      return damaged("chunk: found an input before step " + std::to_string(command->step) + ", wanted steps from " +
                     std::to_string(before) + " on, inside the chunk");
    }
    before = command->step;
    chunk.steps[before - chunk.first_step].inputs.push_back(std::move(command->command));
  }
  return {};
}

Status decode_words(schema::Chunk::Reader in, std::vector<StepRecord>& steps) {
  std::uint64_t total = 0;
  std::uint32_t longest = 0;
  Status counts = get_column<std::uint32_t>("chunk: phaseWordCount", in.getPhaseWordCount(), steps,
                                            [&](StepRecord& step, std::uint32_t count) {
                                              step.phase_words.resize(std::min<std::uint64_t>(count, kPhaseWordsMax));
                                              longest = std::max(longest, count);
                                              total += count;
                                            });
  if (!counts.ok()) return counts;
  if (longest > kPhaseWordsMax) return damaged("chunk: found a step of " + std::to_string(longest) + " phase words");
  std::vector<std::uint64_t> words;
  if (Status ok = get_plain("chunk: phaseWords", in.getPhaseWords(), total, words); !ok.ok()) return ok;
  std::size_t next = 0;
  for (std::size_t j = 0; j < longest; ++j) {
    for (StepRecord& step : steps) {
      if (step.phase_words.size() > j) step.phase_words[j] = words[next++];
    }
  }
  return {};
}

Status decode_counters(schema::Chunk::Reader in, std::vector<StepRecord>& steps) {
  Status status;
  const auto u32 = [&](const char* name, capnp::Data::Reader column, std::uint32_t sim::StepCounters::*field) {
    if (!status.ok()) return;
    status = get_column<std::uint32_t>(name, column, steps,
                                       [field](StepRecord& step, std::uint32_t v) { step.counters.*field = v; });
  };
  const auto f64 = [&](const char* name, capnp::Data::Reader column, double sim::StepCounters::*field) {
    if (!status.ok()) return;
    status = get_column<std::uint64_t>(
        name, column, steps, [field](StepRecord& step, std::uint64_t v) { step.counters.*field = double_of(v); });
  };
  u32("chunk: pairs", in.getPairs(), &sim::StepCounters::pairs);
  u32("chunk: contacts", in.getContacts(), &sim::StepCounters::contacts);
  u32("chunk: substeps", in.getSubsteps(), &sim::StepCounters::substeps);
  f64("chunk: kinetic", in.getKinetic(), &sim::StepCounters::kinetic);
  f64("chunk: potential", in.getPotential(), &sim::StepCounters::potential);
  f64("chunk: inputEnergy", in.getInputEnergy(), &sim::StepCounters::inputs);
  f64("chunk: removedEnergy", in.getRemovedEnergy(), &sim::StepCounters::removed);
  return status;
}

Status decode_steps(schema::Chunk::Reader in, Chunk& chunk) {
  std::vector<StepRecord>& steps = chunk.steps;
  steps.resize(in.getStepCount());
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].step = chunk.first_step + i;
  if (Status ok = decode_inputs(in, chunk); !ok.ok()) return ok;
  if (Status ok = decode_words(in, steps); !ok.ok()) return ok;
  if (Status ok = decode_counters(in, steps); !ok.ok()) return ok;
  std::vector<std::uint64_t> hashes;
  if (Status ok = get_plain("chunk: stateHash", in.getStateHash(), steps.size() * 2, hashes); !ok.ok()) return ok;
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].state_hash = {hashes[2 * i + 1], hashes[2 * i]};
  Status dt = get_column<std::uint64_t>("chunk: dt", in.getDt(), steps,
                                        [](StepRecord& step, std::uint64_t v) { step.dt = double_of(v); });
  if (!dt.ok()) return dt;
  return get_column<std::uint8_t>("chunk: hasStates", in.getHasStates(), steps,
                                  [](StepRecord& step, std::uint8_t v) { step.has_states = v != 0; });
}

void encode_extras(Steps steps, const ChannelTypes& types, schema::Chunk::Builder out) {
  std::vector<const Extras*> extras;
  for (const StepRecord& step : steps) extras.push_back(&step.extras);
  if (!has_extras(steps)) return;
  encode(extras, steps.front().step, types, out.initExtras());
}

Status decode_extras(schema::Chunk::Reader in, Chunk& chunk, std::vector<std::pair<std::size_t, ChannelType>>& found) {
  if (!in.hasExtras()) return {};
  std::vector<Extras*> extras;
  for (StepRecord& step : chunk.steps) extras.push_back(&step.extras);
  auto channels = decode(in.getExtras(), chunk.first_step, extras);
  if (!channels.ok()) return channels.error();
  found = *std::move(channels);
  return {};
}

constexpr std::size_t kStoredBytes = kColumnCount * 8 + 1;  // of a body that touched something, in one step

/// Memory for the first message and for those to come, in which more bodies may move: pages that are never used cost
/// nothing. Empty where there is not as much: each message then takes what it needs.
MessageBytes room_for(std::size_t bytes) {
  try {
    return MessageBytes(bytes / 8 * 8);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

Status check_counts(schema::Chunk::Reader in) {
  if (in.getStepCount() > kStepsPerChunkRead || in.getFirstStep() == 0 || in.getFirstStep() > sim::kStepsMax) {
    return damaged("chunk: found " + std::to_string(in.getStepCount()) + " steps from step " +
                   std::to_string(in.getFirstStep()) + " on");
  }
  return {};
}

}  // namespace

bool has_extras(Steps steps) {
  return std::ranges::any_of(steps, [](const StepRecord& step) { return !step.extras.empty(); });
}

ChunkEncoder::ChunkEncoder() : states_(std::make_unique<StateEncoder>()) {}
ChunkEncoder::~ChunkEncoder() = default;

Result<MessageBytes> ChunkEncoder::encode(const Keyframe& keyframe, Steps steps, const ChannelTypes& types) {
  begin(keyframe.state);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (Status ok = states_->add(steps[i], steps.first(i)); !ok.ok()) return ok.error();
  }
  return finish(keyframe, steps, types);
}

void ChunkEncoder::begin(const sim::WorldState& keyframe) { states_->begin(keyframe); }

Status ChunkEncoder::take_states(StepRecord& step, Steps earlier) { return states_->take(step, earlier); }

Result<MessageBytes> ChunkEncoder::finish(const Keyframe& keyframe, Steps steps, const ChannelTypes& types) {
  std::size_t bytes = states_->bytes() + encoded_bytes(keyframe.state);
  for (const StepRecord& step : steps) {
    bytes += 80 + step.phase_words.size() * 8 + step.inputs.size() * 400 + bytes_of(step.extras);
  }
  if (spare_.bytes().empty()) spare_ = room_for(bytes + steps.size() * keyframe.state.bodies.size() * kStoredBytes);
  const auto fill = [&](schema::Chunk::Builder out) {
    out.setFirstStep(keyframe.state.step + 1);
    out.setStepCount(static_cast<std::uint32_t>(steps.size()));
    replay::encode(keyframe, out.initKeyframe());
    encode_steps(steps, out);
    states_->copy_to(out.initStates());
    encode_extras(steps, types, out);
  };
  return write_message<schema::Chunk>(bytes, fill, std::move(spare_));
}

ChunkDecoder::ChunkDecoder() = default;
ChunkDecoder::ChunkDecoder(ChunkDecoder&&) noexcept = default;
ChunkDecoder& ChunkDecoder::operator=(ChunkDecoder&&) noexcept = default;
ChunkDecoder::~ChunkDecoder() = default;

Result<ChunkDecoder> ChunkDecoder::open(const MessageBytes& message) {
  ChunkDecoder decoder;
  const auto read = [&](schema::Chunk::Reader in) -> Status {
    if (Status ok = check_counts(in); !ok.ok()) return ok;
    decoder.chunk_.first_step = in.getFirstStep();
    Result<Keyframe> keyframe = decode(in.getKeyframe());
    if (!keyframe.ok()) return keyframe.error();
    decoder.chunk_.keyframe = *std::move(keyframe);
    if (decoder.chunk_.keyframe.state.step + 1 != decoder.chunk_.first_step) {
      return damaged("chunk: found a keyframe of step " + std::to_string(decoder.chunk_.keyframe.state.step) +
                     " before step " + std::to_string(decoder.chunk_.first_step));
    }
    if (Status ok = decode_steps(in, decoder.chunk_); !ok.ok()) return ok;
    if (Status ok = decode_extras(in, decoder.chunk_, decoder.channels_); !ok.ok()) return ok;
    decoder.states_ = std::make_unique<StateDecoder>(decoder.chunk_.keyframe.state, in.getStates());
    return decoder.states_->check(in.getStepCount());
  };
  if (Status ok = read_message<schema::Chunk>(message, read); !ok.ok()) return ok.error();
  return decoder;
}

Result<const StepRecord*> ChunkDecoder::step(std::size_t index) {
  SIM_CHECK(index < chunk_.steps.size(), index, chunk_.steps.size());
  while (decoded_ <= index) {
    if (Status ok = states_->decode(chunk_.steps[decoded_]); !ok.ok()) return ok.error();
    ++decoded_;
  }
  return &chunk_.steps[index];
}

}  // namespace tumble::replay
