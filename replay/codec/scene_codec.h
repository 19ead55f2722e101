#pragma once

#include <vector>

#include "replay/format/step_record.h"
#include "schema/log.capnp.h"
#include "src/base/result.h"
#include "src/model/scene.h"
#include "src/model/transform.h"

/// Scenes, worlds and inputs to and from the schema's structs. Readers throw kj::Exception on bad pointers; callers are
/// inside read_message(). Included by codecs only.
namespace tumble::replay {

void encode(const sim::Vec3& v, schema::Vec3::Builder out);
sim::Vec3 decode(schema::Vec3::Reader in);

void encode(const sim::WorldDef& def, schema::WorldDef::Builder out);
/// Errors (kBadInput): a method that this build does not know.
Result<sim::WorldDef> decode(schema::WorldDef::Reader in);

void encode(const sim::TimedCommand& input, schema::Input::Builder out);
/// Errors (kBadInput): a kind of input that this build does not know, with its name.
Result<sim::TimedCommand> decode(schema::Input::Reader in);

void encode(const sim::SceneDef& scene, schema::Scene::Builder out);
/// Errors: as above; kDamaged where ids or steps do not ascend.
/// message_bytes: of the message that the scene is in, which bounds its lists.
Result<sim::SceneDef> decode(schema::Scene::Reader in, std::uint64_t message_bytes);

void encode(const sim::Transform& transform, schema::Transform::Builder out);
sim::Transform decode(schema::Transform::Reader in);

}  // namespace tumble::replay
