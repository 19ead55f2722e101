#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "replay/log/byte_memory.h"
#include "replay/recorder/tumble_recorder.h"
#include "replay/stream/stream_reader.h"

/// Streams recorded to memory.
namespace tumble::test {

using StreamBytes = std::vector<std::byte>;

inline int append(void* user, const void* bytes, std::size_t size) {
  const auto* at = static_cast<const std::byte*>(bytes);
  static_cast<StreamBytes*>(user)->insert(static_cast<StreamBytes*>(user)->end(), at, at + size);
  return 0;
}

inline TumbleRecDef small_def(StreamBytes& to) {
  TumbleRecDef def = {};
  def.engine = "test engine";
  def.precision_bits = 24;
  def.gravity[2] = -10;
  def.write = append;
  def.write_user = &to;
  return def;
}

inline TumbleRecBody small_cube(std::uint64_t id) {
  TumbleRecBody body = {};
  body.id = id;
  body.size[0] = body.size[1] = body.size[2] = 1;
  body.mass = 1;
  body.state.position[0] = 2 * static_cast<double>(id);
  body.state.position[2] = 5;
  body.state.orientation[0] = 1;
  return body;
}

/// The state of body `id` after step k.
inline TumbleRecState state_at(std::uint64_t id, std::uint64_t k) {
  TumbleRecState state = small_cube(id).state;
  state.position[2] -= 0.125 * static_cast<double>(k);
  state.velocity[2] = -1;
  return state;
}

/// Bodies 1 … `bodies`, `steps` steps; body 2 sleeps from step 3 on. Then what `more` does, and the end.
inline StreamBytes record(std::uint64_t bodies, std::uint64_t steps, const std::function<void(TumbleRec*)>& more = {},
                          const std::function<void(TumbleRecDef&)>& change = {}) {
  StreamBytes bytes;
  TumbleRecDef def = small_def(bytes);
  if (change) change(def);
  TumbleRec* rec = tumble_rec_create(&def);
  for (std::uint64_t id = 1; id <= bodies; ++id) {
    const TumbleRecBody body = small_cube(id);
    tumble_rec_body(rec, &body);
  }
  for (std::uint64_t k = 1; k <= steps; ++k) {
    tumble_rec_step_begin(rec, 0.0625);
    for (std::uint64_t id = 1; id <= bodies; ++id) {
      TumbleRecState state = state_at(id, k);
      if (id == 2 && k >= 3) state = state_at(id, 3), state.asleep = 1;
      tumble_rec_state(rec, id, &state);
    }
    tumble_rec_step_end(rec);
  }
  if (more) more(rec);
  tumble_rec_close(rec);
  return bytes;
}

inline Result<replay::StreamReader> open_stream(StreamBytes bytes) {
  auto file = std::make_shared<StreamBytes>(std::move(bytes));
  return replay::StreamReader::open(std::make_unique<replay::MemoryByteSource>(file, "memory"));
}

}  // namespace tumble::test
