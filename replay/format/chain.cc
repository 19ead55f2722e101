#include "replay/format/step_record.h"

namespace tumble::replay {
namespace {

void add(Hasher& hasher, const sim::Vec3& v) {
  hasher.add(v.x());
  hasher.add(v.y());
  hasher.add(v.z());
}

void add(Hasher& hasher, const sim::BoxDef& box) {
  hasher.add(box.id);
  add(hasher, box.size);
  hasher.add(box.mass);
  hasher.add(std::uint64_t{box.is_static});
  add(hasher, box.position);
  hasher.add(box.orientation.w);
  hasher.add(box.orientation.x);
  hasher.add(box.orientation.y);
  hasher.add(box.orientation.z);
  add(hasher, box.velocity);
  add(hasher, box.spin);
  hasher.add(box.material.friction);
  hasher.add(box.material.friction_dynamic);
  hasher.add(box.material.restitution);
  hasher.add(std::uint64_t{box.frozen});
}

/// The fields that change what happens; texture and origin do not.
struct AddCommand {
  Hasher& hasher;
  void operator()(const sim::Throw& c) const { add(hasher, c.box); }
  void operator()(const sim::Push& c) const {
    hasher.add(c.id);
    add(hasher, c.impulse);
    hasher.add(std::uint64_t{c.at_centre});
    if (!c.at_centre) add(hasher, c.at);
  }
  void operator()(const sim::Remove& c) const { hasher.add(c.id); }
  void operator()(const sim::Wake& c) const { hasher.add(c.id); }
  void operator()(const sim::SetVelocity& c) const {
    hasher.add(c.id);
    add(hasher, c.velocity);
    add(hasher, c.spin);
  }
  void operator()(const sim::SetGravity& c) const { add(hasher, c.gravity); }
  void operator()(const sim::SetDt& c) const { hasher.add(c.dt); }
};

void add(Hasher& hasher, const Hash128& hash) {
  hasher.add(hash.low);
  hasher.add(hash.high);
}

}  // namespace

Hash128 chain_start(const Hash128& state_hash_0) {
  Hasher hasher;
  add(hasher, state_hash_0);
  return hasher.digest();
}

Hash128 chain_next(const Hash128& before, const StepRecord& record) {
  Hasher hasher;
  add(hasher, before);
  hasher.add(record.step);
  hasher.add(record.dt);
  hasher.add(std::uint64_t{record.inputs.size()});
  for (const sim::Command& command : record.inputs) {
    hasher.add(std::uint64_t{command.index()});
    std::visit(AddCommand{hasher}, command);
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
  return hasher.digest();
}

}  // namespace tumble::replay
