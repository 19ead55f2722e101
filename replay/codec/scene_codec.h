#pragma once

#include <vector>

#include "schema/log.capnp.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/transform.h"

/// Converts scenes, worlds and inputs to the structs of the schema and back. Decoding throws kj::Exception on bad
/// pointers, so callers stay inside read_message(). Included by codecs only.
namespace tumble::replay {

void encode(const sim::Vec3& v, schema::Vec3::Builder out);
sim::Vec3 decode(schema::Vec3::Reader in);

void encode(const sim::WorldDef& def, schema::WorldDef::Builder out);
/// Errors (kBadInput): the method is unknown to this build.
Result<sim::WorldDef> decode(schema::WorldDef::Reader in);

void encode(const sim::Camera& camera, schema::Camera::Builder out);
sim::Camera decode(schema::Camera::Reader in);

void encode(const sim::TimedCommand& input, schema::Input::Builder out);
/// Errors (kBadInput): the kind of input is unknown to this build; the message names the kind.
Result<sim::TimedCommand> decode(schema::Input::Reader in);

void encode(const sim::SceneDef& scene, schema::Scene::Builder out);
/// message_bytes: size of the message that holds the scene; limits the lengths of its lists. Errors: as above; kDamaged
/// where ids do not ascend or a list is too long.
Result<sim::SceneDef> decode(schema::Scene::Reader in, std::uint64_t message_bytes);

void encode(const sim::Transform& transform, schema::Transform::Builder out);
sim::Transform decode(schema::Transform::Reader in);

}  // namespace tumble::replay
