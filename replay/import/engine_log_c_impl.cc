#include "replay/import/engine_log_c_impl.h"

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "replay/format/step_values.h"

using tumble::Result;
using tumble::Status;
using tumble::replay::ChannelValue;
using tumble::replay::EngineLog;
using tumble::replay::guarded;
using tumble::replay::missing;
using tumble::replay::Shape;
using tumble::replay::vector_of;
using tumble::replay::while_open;

namespace {

Result<Shape> shape_of(const TumbleLogShape& shape) {
  if (shape.kind < TUMBLE_SPHERE || shape.kind > TUMBLE_MESH || shape.axis < 0 || shape.axis > 2) {
    return tumble::bad_input("found a shape of kind " + std::to_string(shape.kind) + " and axis " +
                             std::to_string(shape.axis) + ", wanted a kind of TumbleLogShapeKind and 0, 1 or 2");
  }
  const bool null =
      (shape.points == nullptr && shape.point_count > 0) || (shape.triangles == nullptr && shape.triangle_count > 0);
  if (null) return missing("points and triangles of a shape");
  Shape made;
  made.kind = static_cast<Shape::Kind>(shape.kind);
  made.axis = static_cast<std::uint8_t>(shape.axis);
  made.radius = shape.radius;
  made.half_length = shape.half_length;
  for (std::size_t i = 0; i < shape.point_count; ++i) made.points.push_back(vector_of(shape.points + 3 * i));
  made.triangles.assign(shape.triangles, shape.triangles + 3 * shape.triangle_count);
  return made;
}

Status describe(TumbleLog& log, std::uint64_t id, const char* name, const TumbleLogShape* shape) {
  tumble::replay::BodyInfo info = {id, name != nullptr ? name : "", {}};
  Shape made;
  if (shape != nullptr) {
    Result<Shape> of = shape_of(*shape);
    if (!of.ok()) return of.error();
    made = *std::move(of);
    info.shape = hash_of(made);
  }
  if (log.log) return log.log->describe_body(info, shape != nullptr ? &made : nullptr);
  log.declared_bodies.add(std::move(info), shape != nullptr ? &made : nullptr, log.def.declared);
  return {};
}

Status set_value(TumbleLog& log, std::size_t channel, std::uint64_t a, std::uint64_t b, ChannelValue value) {
  if (!log.log) {
    log.start_values.push_back({channel, {a, b}, std::move(value)});
    return {};
  }
  return log.log->set_value(channel < log.place.size() ? log.place[channel] : log.place.size(), value, {a, b});
}

}  // namespace

Status tumble::replay::declare_channels(TumbleLog& log) {
  Declared& declared = log.def.declared;
  declared.channels = log.channels;
  std::ranges::sort(declared.channels, {}, &Channel::name);
  std::ranges::sort(declared.bodies, {}, &tumble::replay::BodyInfo::id);
  for (const Channel& channel : log.channels) log.place.push_back(declared.find(channel.name));
  StepValues values(declared.channels);
  for (const StartValue& start : log.start_values) {
    const std::size_t place = start.channel < log.place.size() ? log.place[start.channel] : log.place.size();
    if (Status ok = values.set(place, start.value, start.key); !ok.ok()) return ok;
  }
  values.move_to(declared.start);
  return {};
}

void tumble::replay::end_refused(TumbleLog& log) {
  const std::unique_ptr<EngineLog> ended = std::move(log.log);
  if (ended->is_finished()) return;
  ended->drop_step();
  const Result<LogSummary> summary = ended->finish("a call was refused: " + log.status.error().message);
  if (!summary.ok()) log.status = bad_input(log.status.error().message + "; " + summary.error().message);
}

TumbleLogStatus tumble_log_add_channel(TumbleLog* log, const char* name, TumbleLogKind kind, TumbleLogScope scope,
                                       const char* unit) {
  return guarded(log, [&]() -> Status {
    if (log->log) return tumble::bad_input("found a channel after tumble_log_begin(), wanted it before");
    if (name == nullptr) return missing("the name of a channel");
    if (kind < TUMBLE_FLOAT64 || kind > TUMBLE_TEXT || scope < TUMBLE_WORLD || scope > TUMBLE_PAIR) {
      return tumble::bad_input("channel \"" + std::string(name) + "\": found kind " + std::to_string(kind) +
                               " and scope " + std::to_string(scope) + ", wanted a TumbleLogKind and a TumbleLogScope");
    }
    using tumble::replay::Channel;
    Channel channel = {
        name,
        {static_cast<tumble::replay::ChannelKind>(kind), static_cast<tumble::replay::ChannelScope>(scope)},
        unit != nullptr ? unit : ""};
    if (Status ok = tumble::replay::check_channels({channel}); !ok.ok()) return ok;
    if (std::ranges::find(log->channels, channel.name, &Channel::name) != log->channels.end()) {
      return tumble::bad_input("channel \"" + channel.name + "\": found twice, wanted names that differ");
    }
    log->channels.push_back(std::move(channel));
    return {};
  });
}

TumbleLogStatus tumble_log_describe_body(TumbleLog* log, uint64_t id, const char* name, const TumbleLogShape* shape) {
  return guarded(log, [&] { return describe(*log, id, name, shape); });
}

TumbleLogStatus tumble_log_set_f64(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, double value) {
  return guarded(log, [&] { return set_value(*log, channel, a, b, value); });
}

TumbleLogStatus tumble_log_set_f32(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, float value) {
  return guarded(log, [&] { return set_value(*log, channel, a, b, value); });
}

TumbleLogStatus tumble_log_set_i64(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, int64_t value) {
  return guarded(log, [&] { return set_value(*log, channel, a, b, value); });
}

TumbleLogStatus tumble_log_set_u64(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, uint64_t value) {
  return guarded(log, [&] { return set_value(*log, channel, a, b, value); });
}

TumbleLogStatus tumble_log_set_bytes(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, const void* bytes,
                                     size_t count) {
  return guarded(log, [&]() -> Status {
    if (bytes == nullptr && count > 0) return missing("bytes");
    return set_value(*log, channel, a, b, std::string(static_cast<const char*>(bytes), count));
  });
}

TumbleLogStatus tumble_log_set_text(TumbleLog* log, size_t channel, uint64_t a, uint64_t b, const char* text) {
  return guarded(log, [&]() -> Status {
    if (text == nullptr) return missing("a text");
    return set_value(*log, channel, a, b, std::string(text));
  });
}

TumbleLogStatus tumble_log_contact(TumbleLog* log, const TumbleLogContact* contact) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (contact == nullptr) return missing("a contact");
    return open.add_contact({contact->a, contact->b, vector_of(contact->position), vector_of(contact->normal),
                             contact->depth, contact->impulse});
  });
}

TumbleLogStatus tumble_log_note(TumbleLog* log, const char* text) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (text == nullptr) return missing("a text");
    return open.add_note(text);
  });
}

TumbleLogStatus tumble_log_snapshot(TumbleLog* log, const void* bytes, size_t count) {
  return tumble_log_named_snapshot(log, "", bytes, count);
}

TumbleLogStatus tumble_log_named_snapshot(TumbleLog* log, const char* name, const void* bytes, size_t count) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (bytes == nullptr && count > 0) return missing("bytes of a snapshot");
    return open.add_snapshot(std::span(static_cast<const std::byte*>(bytes), count), name == nullptr ? "" : name);
  });
}
