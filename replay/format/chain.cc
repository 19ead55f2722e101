#include "replay/format/chain.h"

#include "src/model/command_fields.h"

namespace tumble::replay {
namespace {

/// Adds one value of an input. Called for the values that change what happens, in the order of for_each_effect(). That
/// order and the index of each kind of input are part of the log format: chains of old logs must stay equal.
struct AddField {
  Hasher& hasher;
  void operator()(auto, double value) const { hasher.add(value); }
  void operator()(auto, std::uint64_t value) const { hasher.add(value); }
  void operator()(auto, bool value) const { hasher.add(std::uint64_t{value}); }
  void operator()(auto, const sim::Vec3& v) const {
    for (const double value : {v.x(), v.y(), v.z()}) hasher.add(value);
  }
  void operator()(auto, const sim::Quat& q) const {
    for (const double value : {q.w, q.x, q.y, q.z}) hasher.add(value);
  }
};

void add(Hasher& hasher, const Hash128& hash) {
  hasher.add(hash.low);
  hasher.add(hash.high);
}

void add_step(Hasher& hasher, const StepRecord& record) {
  hasher.add(record.step);
  hasher.add(record.dt);
  hasher.add(std::uint64_t{record.inputs.size()});
  for (const sim::Command& command : record.inputs) {
    hasher.add(std::uint64_t{command.index()});
    sim::for_each_effect(command, AddField{hasher});
  }
  hasher.add(std::uint64_t{record.phase_words.size()});
  hasher.add(std::span<const std::uint64_t>(record.phase_words));
  add(hasher, record.state_hash);
  const sim::StepCounters& counters = record.counters;
  hasher.add(std::uint64_t{counters.pairs});
  hasher.add(std::uint64_t{counters.contacts});
  hasher.add(std::uint64_t{counters.substeps});
  hasher.add(counters.kinetic);
  hasher.add(counters.potential);
  hasher.add(counters.inputs);
  hasher.add(counters.removed);
}

}  // namespace

Hash128 chain_start(const Hash128& state_hash_0, const Extras& extras_0) {
  Hasher hasher;
  add(hasher, state_hash_0);
  if (extras_0.in_chain()) add(hasher, hash_of(extras_0));
  return hasher.digest();
}

Hash128 chain_next(const Hash128& before, const StepRecord& record) {
  Hasher hasher;
  add(hasher, before);
  add_step(hasher, record);
  if (record.extras.in_chain()) add(hasher, hash_of(record.extras));
  return hasher.digest();
}

Hash128 chain_next_of_states(const Hash128& before, const StepRecord& record) {
  Hasher hasher;
  add(hasher, before);
  add_step(hasher, record);
  return hasher.digest();
}

}  // namespace tumble::replay
