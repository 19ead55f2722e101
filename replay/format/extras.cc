#include "tumble/replay/extras.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

void add(Hasher& hasher, const std::string& bytes) {
  hasher.add(std::uint64_t{bytes.size()});
  hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

void add(Hasher& hasher, const EngineContact& contact) {
  hasher.add(contact.a);
  hasher.add(contact.b);
  for (const double value : {contact.position.x(), contact.position.y(), contact.position.z(), contact.normal.x(),
                             contact.normal.y(), contact.normal.z(), contact.depth, contact.impulse}) {
    hasher.add(std::bit_cast<std::uint64_t>(value));
  }
}

bool has_value(const ChannelValues& values) { return !values.empty(); }

Status check_view(const View& view) {
  const sim::Camera& camera = view.camera;
  for (const double value :
       {view.part, view.wall_time, camera.position.x(), camera.position.y(), camera.position.z(), camera.target.x(),
        camera.target.y(), camera.target.z(), camera.fov, camera.focus, camera.blur}) {
    if (!std::isfinite(value)) return bad_input("view: found " + exact_bits(value) + ", wanted a finite number");
  }
  if (view.part < 0 || view.part > 1) {
    return bad_input("view: found part " + exact(view.part) + ", wanted 0 to 1");
  }
  if (view.effects.size() <= kColumnNameBytesMax) return {};
  return bad_input("view: found a list of effects of " + bytes_text(view.effects.size()));
}

Status check_bodies(const std::vector<BodyInfo>& bodies) {
  for (const BodyInfo& body : bodies) {
    if (Status ok = check_body_info(body); !ok.ok()) return ok;
  }
  return {};
}

Status check_shapes(const std::vector<Shape>& shapes) {
  if (shapes.size() > kShapesMax) return bad_input("found " + std::to_string(shapes.size()) + " shapes");
  for (const Shape& shape : shapes) {
    if (Status ok = check_shape(shape); !ok.ok()) return ok;
  }
  return {};
}

}  // namespace

bool Extras::in_chain() const { return !contacts.empty() || std::ranges::any_of(channels, has_value); }

bool Extras::empty() const {
  return notes.empty() && snapshots.empty() && views.empty() && superseded.empty() && bodies.empty() &&
         shapes.empty() && !in_chain();
}

void Extras::clear() {
  for (ChannelValues& values : channels) values.clear();
  contacts.clear();
  notes.clear();
  snapshots.clear();
  views.clear();
  superseded.clear();
  bodies.clear();
  shapes.clear();
}

const ChannelValues& Extras::values(std::size_t channel) const {
  static const ChannelValues kNone;
  return channel < channels.size() ? channels[channel] : kNone;
}

// Channels without a value are left out, so that a channel that an engine declares and never gives changes no hash.
Hash128 hash_of(const Extras& extras) {
  Hasher hasher;
  hasher.add(static_cast<std::uint64_t>(std::ranges::count_if(extras.channels, has_value)));
  for (std::size_t i = 0; i < extras.channels.size(); ++i) {
    const ChannelValues& values = extras.channels[i];
    if (values.empty()) continue;
    hasher.add(std::uint64_t{i});
    hasher.add(std::uint64_t{values.size()});
    for (const ChannelKey& key : values.keys) {
      hasher.add(key.a);
      hasher.add(key.b);
    }
    hasher.add(std::uint64_t{values.bits.size()});
    hasher.add(std::span<const std::uint64_t>(values.bits));
    for (const std::string& bytes : values.bytes) add(hasher, bytes);
  }
  hasher.add(std::uint64_t{extras.contacts.size()});
  for (const EngineContact& contact : extras.contacts) add(hasher, contact);
  return hasher.digest();
}

std::uint64_t bytes_of(const Extras& extras) {
  std::uint64_t bytes = extras.contacts.size() * sizeof(EngineContact) + extras.views.size() * 160 +
                        extras.bodies.size() * 80 + extras.superseded.size() * 48;
  for (const ChannelValues& values : extras.channels) {
    bytes += values.size() * (sizeof(ChannelKey) + 8);
    for (const std::string& text : values.bytes) bytes += text.size();
  }
  for (const std::string& text : extras.notes) bytes += text.size() + 32;
  for (const EngineSnapshot& snapshot : extras.snapshots) bytes += snapshot.bytes.size() + snapshot.name.size() + 40;
  for (const Superseded& step : extras.superseded) bytes += step.difference.size();
  for (const Shape& shape : extras.shapes) bytes += shape.points.size() * 24 + shape.triangles.size() * 4 + 96;
  return bytes;
}

Status check_snapshot(const EngineSnapshot& snapshot) {
  if (snapshot.bytes.size() > kSnapshotBytesMax) {
    return bad_input("snapshot: found " + bytes_text(snapshot.bytes.size()) + ", wanted at most " +
                     bytes_text(kSnapshotBytesMax));
  }
  if (snapshot.name.size() <= kColumnNameBytesMax && printable(snapshot.name) == snapshot.name) return {};
  return bad_input("snapshot: found the name " + in_quotes(snapshot.name) + ", wanted at most " +
                   std::to_string(kColumnNameBytesMax) + " bytes of text");
}

Status check_extras(const Extras& extras) {
  const auto pair_of = [](const EngineContact& contact) { return std::pair(contact.a, contact.b); };
  if (!std::ranges::is_sorted(extras.contacts, {}, pair_of)) return bad_input("contacts: wanted ascending pairs");
  if (extras.contacts.size() > kExtraRowsMax) return bad_input("contacts: found too many of one step");
  for (const View& view : extras.views) {
    if (Status ok = check_view(view); !ok.ok()) return ok;
  }
  for (const std::string& text : extras.notes) {
    if (text.size() > kNoteBytesMax) return bad_input("note: found a text of " + bytes_text(text.size()));
  }
  for (const EngineSnapshot& snapshot : extras.snapshots) {
    if (Status ok = check_snapshot(snapshot); !ok.ok()) return ok;
  }
  if (Status ok = check_bodies(extras.bodies); !ok.ok()) return ok;
  return check_shapes(extras.shapes);
}

bool Declared::empty() const {
  return channels.empty() && shapes.empty() && bodies.empty() && start.empty() && !velocity_derived && !spin_derived &&
         cut_short.empty();
}

std::size_t Declared::find(const std::string& name) const {
  return static_cast<std::size_t>(std::ranges::find(channels, name, &Channel::name) - channels.begin());
}

Status check_declared(const Declared& declared) {
  if (Status ok = check_channels(declared.channels); !ok.ok()) return ok;
  if (!std::ranges::is_sorted(declared.channels, {}, &Channel::name)) {
    return bad_input("channels: wanted ascending names");
  }
  if (Status ok = check_shapes(declared.shapes); !ok.ok()) return ok;
  if (Status ok = check_bodies(declared.bodies); !ok.ok()) return ok;
  std::set<std::pair<std::uint64_t, std::uint64_t>> known = {{0, 0}};
  for (const Shape& shape : declared.shapes) {
    const Hash128 hash = hash_of(shape);
    known.emplace(hash.high, hash.low);
  }
  for (std::size_t i = 0; i < declared.bodies.size(); ++i) {
    const BodyInfo& body = declared.bodies[i];
    if (i > 0 && declared.bodies[i - 1].id >= body.id) return bad_input("bodies: wanted ascending ids");
    if (known.contains({body.shape.high, body.shape.low})) continue;
    return bad_input("body " + std::to_string(body.id) + ": found a shape that is not declared");
  }
  return check_extras(declared.start);
}

}  // namespace tumble::replay
