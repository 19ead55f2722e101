#include "replay/codec/keyframe_codec.h"

#include <array>

#include "replay/codec/blob.h"
#include "replay/codec/scene_codec.h"
#include "replay/format/limits.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kDoubleColumns = 28;

/// The order of Keyframe.doubles. The order never changes; a new column goes to the end.
template <class Bodies, class Column>
std::array<Column*, kDoubleColumns> double_columns(Bodies& b) {
  return {&b.position.x,
          &b.position.y,
          &b.position.z,
          &b.orientation.w,
          &b.orientation.x,
          &b.orientation.y,
          &b.orientation.z,
          &b.velocity.x,
          &b.velocity.y,
          &b.velocity.z,
          &b.spin.x,
          &b.spin.y,
          &b.spin.z,
          &b.low_energy_time,
          &b.half_extent.x,
          &b.half_extent.y,
          &b.half_extent.z,
          &b.mass,
          &b.inverse_mass,
          &b.inertia.x,
          &b.inertia.y,
          &b.inertia.z,
          &b.inverse_inertia.x,
          &b.inverse_inertia.y,
          &b.inverse_inertia.z,
          &b.friction,
          &b.friction_dynamic,
          &b.restitution};
}

void encode_bodies(const sim::Bodies& bodies, schema::Keyframe::Builder out) {
  const auto n = static_cast<unsigned>(bodies.size());
  put_differences(std::span<const std::uint64_t>(bodies.id), out.initId(n * 8));
  auto lists = out.initDoubles(kDoubleColumns);
  unsigned next = 0;
  for (const auto* column : double_columns<const sim::Bodies, const std::vector<double>>(bodies)) {
    put_planes(std::span<const std::uint64_t>(bits_of(*column)), lists.init(next++, n * 8));
  }
  put_plain(std::span<const std::uint8_t>(bodies.frozen), out.initFrozen(n));
  put_plain(std::span<const std::uint8_t>(bodies.is_static), out.initIsStatic(n));
}

Status check_ids(const std::vector<sim::BodyId>& ids) {
  sim::BodyId before = 0;
  for (const sim::BodyId id : ids) {
    if (id <= before || id > sim::kBodyIdMax) {
      return damaged("keyframe: found body id " + std::to_string(id) + " after " + std::to_string(before) +
                     ", wanted ascending ids up to 2^53 - 1");
    }
    before = id;
  }
  return {};
}

Status check_flags(const char* column, const std::vector<std::uint8_t>& flags) {
  for (const std::uint8_t flag : flags) {
    if (flag > 1)
      return damaged("keyframe: " + std::string(column) + ": found " + std::to_string(flag) + ", wanted 0 or 1");
  }
  return {};
}

Status decode_bodies(schema::Keyframe::Reader in, sim::Bodies& bodies) {
  const capnp::Data::Reader ids = in.getId();
  const std::size_t n = ids.size() / 8;
  if (n > sim::kBodiesMax) {
    return damaged("keyframe: found " + std::to_string(n) + " bodies, wanted at most " +
                   std::to_string(sim::kBodiesMax));
  }
  if (Status ok = get_differences("keyframe: id", ids, n, bodies.id); !ok.ok()) return ok;
  if (Status ok = check_ids(bodies.id); !ok.ok()) return ok;
  const auto lists = in.getDoubles();
  if (lists.size() < kDoubleColumns) {
    return damaged("keyframe: found " + std::to_string(lists.size()) + " columns, wanted " +
                   std::to_string(kDoubleColumns));
  }
  std::vector<std::uint64_t> bits;
  unsigned next = 0;
  for (auto* column : double_columns<sim::Bodies, std::vector<double>>(bodies)) {
    if (Status ok = get_planes("keyframe: doubles", lists[next++], n, bits); !ok.ok()) return ok;
    doubles_of(bits, *column);
  }
  if (Status ok = get_plain("keyframe: frozen", in.getFrozen(), n, bodies.frozen); !ok.ok()) return ok;
  if (Status ok = get_plain("keyframe: isStatic", in.getIsStatic(), n, bodies.is_static); !ok.ok()) return ok;
  if (Status ok = check_flags("frozen", bodies.frozen); !ok.ok()) return ok;
  return check_flags("isStatic", bodies.is_static);
}

/// Errors (kDamaged): a row number beyond the bodies. ground_too: kGround is allowed. World::restore() and the phases
/// use these rows as indices without a further check.
Status check_rows(const char* column, const std::vector<sim::BodyIndex>& rows, std::size_t bodies, bool ground_too) {
  for (const sim::BodyIndex row : rows) {
    if (row < bodies || (ground_too && row == sim::kGround)) continue;
    return damaged("keyframe: " + std::string(column) + ": found row " + std::to_string(row) + " of " +
                   std::to_string(bodies) + " bodies");
  }
  return {};
}

Status decode_pairs(schema::Keyframe::Reader in, std::size_t bodies, sim::PairTable& pairs) {
  const capnp::Data::Reader planes = in.getPairPlanes();
  const std::size_t n = planes.size() / 2;
  if (n > kPairsMax) return damaged("keyframe: found " + std::to_string(n) + " pairs");
  if (Status ok = get_differences("keyframe: pairA", in.getPairA(), n, pairs.a); !ok.ok()) return ok;
  if (Status ok = get_differences("keyframe: pairB", in.getPairB(), n, pairs.b); !ok.ok()) return ok;
  if (Status ok = get_planes("keyframe: pairPlanes", planes, n, pairs.planes); !ok.ok()) return ok;
  if (Status ok = check_rows("pairA", pairs.a, bodies, false); !ok.ok()) return ok;
  return check_rows("pairB", pairs.b, bodies, false);
}

Status decode_contacts(schema::Keyframe::Reader in, std::size_t bodies, sim::ContactObjects& contacts) {
  const capnp::Data::Reader contact_bodies = in.getContactBody();
  const std::size_t n = contact_bodies.size() / 4;
  if (n > kPairsMax) return damaged("keyframe: found " + std::to_string(n) + " contact objects");
  if (Status ok = get_differences("keyframe: contactBody", contact_bodies, n, contacts.body); !ok.ok()) return ok;
  if (Status ok = get_differences("keyframe: contactObject", in.getContactObject(), n, contacts.object); !ok.ok()) {
    return ok;
  }
  if (Status ok = check_rows("contactBody", contacts.body, bodies, false); !ok.ok()) return ok;
  return check_rows("contactObject", contacts.object, bodies, true);
}

template <class Memory, class Column>
std::array<Column*, 4> memory_columns(Memory& m) {
  return {&m.friction.x, &m.friction.y, &m.friction.z, &m.twist};
}

void encode_memory(const sim::ContactMemory& memory, schema::Keyframe::Builder out) {
  const auto n = static_cast<unsigned>(memory.size());
  const auto points = static_cast<unsigned>(memory.feature.size());
  put_differences(std::span<const sim::BodyIndex>(memory.a), out.initMemoryA(n * 4));
  put_differences(std::span<const sim::BodyIndex>(memory.b), out.initMemoryB(n * 4));
  put_planes(std::span<const std::uint32_t>(memory.count), out.initMemoryCount(n * 4));
  auto lists = out.initMemoryDoubles(4);
  unsigned next = 0;
  for (const auto* column : memory_columns<const sim::ContactMemory, const std::vector<double>>(memory)) {
    put_planes(std::span<const std::uint64_t>(bits_of(*column)), lists.init(next++, n * 8));
  }
  put_planes(std::span<const sim::Feature>(memory.feature), out.initMemoryFeature(points * 4));
  put_planes(std::span<const std::uint64_t>(bits_of(memory.impulse)), out.initMemoryImpulse(points * 8));
}

Status decode_memory(schema::Keyframe::Reader in, std::size_t bodies, sim::ContactMemory& memory) {
  const capnp::Data::Reader counts = in.getMemoryCount();
  const capnp::Data::Reader features = in.getMemoryFeature();
  const std::size_t n = counts.size() / 4;
  const std::size_t points = features.size() / 4;
  if (n > kPairsMax || points > kPairsMax)
    return damaged("keyframe: found " + std::to_string(points) + " contact points");
  if (Status ok = get_differences("keyframe: memoryA", in.getMemoryA(), n, memory.a); !ok.ok()) return ok;
  if (Status ok = get_differences("keyframe: memoryB", in.getMemoryB(), n, memory.b); !ok.ok()) return ok;
  if (Status ok = get_planes("keyframe: memoryCount", counts, n, memory.count); !ok.ok()) return ok;
  if (Status ok = get_planes("keyframe: memoryFeature", features, points, memory.feature); !ok.ok()) return ok;
  std::vector<std::uint64_t> bits;
  const auto lists = in.getMemoryDoubles();
  unsigned next = 0;
  for (auto* column : memory_columns<sim::ContactMemory, std::vector<double>>(memory)) {
    const capnp::Data::Reader list = next < lists.size() ? lists[next++] : capnp::Data::Reader();
    if (Status ok = get_planes("keyframe: memoryDoubles", list, n, bits); !ok.ok()) return ok;
    doubles_of(bits, *column);
  }
  if (Status ok = get_planes("keyframe: memoryImpulse", in.getMemoryImpulse(), points, bits); !ok.ok()) return ok;
  doubles_of(bits, memory.impulse);
  std::uint64_t sum = 0;
  for (const std::uint32_t count : memory.count) sum += count;
  if (sum != points) {
    return damaged("keyframe: found " + std::to_string(points) + " contact points, wanted " + std::to_string(sum));
  }
  if (Status ok = check_rows("memoryA", memory.a, bodies, true); !ok.ok()) return ok;
  return check_rows("memoryB", memory.b, bodies, false);
}

}  // namespace

std::size_t encoded_bytes(const sim::WorldState& state) {
  return state.bodies.size() * (kDoubleColumns * 8 + 10) + state.pairs.size() * 10 + state.contact_objects.size() * 8 +
         state.contact_memory.size() * 44 + state.contact_memory.feature.size() * 12 + 4096;
}

void encode(const Keyframe& keyframe, schema::Keyframe::Builder out) {
  // A field added to WorldState must be added here and to the schema: this line then no longer compiles.
  const auto& [step, def, bodies, pairs, contact_objects, contact_memory] = keyframe.state;
  out.setStep(step);
  encode(def, out.initWorld());
  out.setContinuationLow(keyframe.continuation_hash.low);
  out.setContinuationHigh(keyframe.continuation_hash.high);
  encode_bodies(bodies, out);
  const auto n = static_cast<unsigned>(pairs.size());
  put_differences(std::span<const sim::BodyIndex>(pairs.a), out.initPairA(n * 4));
  put_differences(std::span<const sim::BodyIndex>(pairs.b), out.initPairB(n * 4));
  put_planes(std::span<const std::uint16_t>(pairs.planes), out.initPairPlanes(n * 2));
  const auto m = static_cast<unsigned>(contact_objects.size());
  put_differences(std::span<const sim::BodyIndex>(contact_objects.body), out.initContactBody(m * 4));
  put_differences(std::span<const sim::BodyIndex>(contact_objects.object), out.initContactObject(m * 4));
  encode_memory(contact_memory, out);
}

Result<Keyframe> decode(schema::Keyframe::Reader in) {
  Keyframe keyframe;
  sim::WorldState& state = keyframe.state;
  state.step = in.getStep();
  Result<sim::WorldDef> def = decode(in.getWorld());
  if (!def.ok()) return def.error();
  state.def = *def;
  keyframe.continuation_hash = {in.getContinuationHigh(), in.getContinuationLow()};
  if (Status ok = decode_bodies(in, state.bodies); !ok.ok()) return ok.error();
  const std::size_t bodies = state.bodies.size();
  if (Status ok = decode_pairs(in, bodies, state.pairs); !ok.ok()) return ok.error();
  if (Status ok = decode_contacts(in, bodies, state.contact_objects); !ok.ok()) return ok.error();
  if (Status ok = decode_memory(in, bodies, state.contact_memory); !ok.ok()) return ok.error();
  return keyframe;
}

}  // namespace tumble::replay
