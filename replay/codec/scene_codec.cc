#include "replay/codec/scene_codec.h"

#include <algorithm>
#include <string>

#include "replay/format/limits.h"
#include "src/model/command_fields.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

namespace field = sim::field;

void encode_origin(const sim::Origin& origin, schema::Origin::Builder out) {
  out.setKind(static_cast<std::uint8_t>(origin.kind));
  out.setTable(origin.table);
  out.setRow(origin.row);
  out.setColumn(origin.column);
}

sim::Origin decode_origin(schema::Origin::Reader in) {
  using Kind = sim::Origin::Kind;
  const bool known = in.getKind() <= static_cast<std::uint8_t>(Kind::kInput);
  return {known ? static_cast<Kind>(in.getKind()) : Kind::kBox, in.getTable(), in.getRow(), in.getColumn()};
}

/// Writes the fields of an input, a box or a material into the schema's struct of the same name. A field without a
/// line here does not compile.
template <class Builder>
struct PutFields {
  Builder out;

  void operator()(field::Id, sim::BodyId id) { out.setId(id); }
  void operator()(field::Size, const sim::Vec3& size) { encode(size, out.initSize()); }
  void operator()(field::Mass, double mass) { out.setMass(mass); }
  void operator()(field::Static, bool is_static) { out.setIsStatic(is_static); }
  void operator()(field::Position, const sim::Vec3& p) { encode(p, out.initPosition()); }
  void operator()(field::Orientation, const sim::Quat& q) {
    out.setOrientationW(q.w);
    out.setOrientationX(q.x);
    out.setOrientationY(q.y);
    out.setOrientationZ(q.z);
  }
  void operator()(field::Velocity, const sim::Vec3& v) { encode(v, out.initVelocity()); }
  void operator()(field::Spin, const sim::Vec3& w) { encode(w, out.initSpin()); }
  void operator()(field::Material, const sim::Material& m) {
    for_each_field(m, PutFields<schema::Material::Builder>{out.initMaterial()});
  }
  void operator()(field::Friction, double friction) { out.setFriction(friction); }
  void operator()(field::FrictionDynamic, double friction) { out.setFrictionDynamic(friction); }
  void operator()(field::Restitution, double restitution) { out.setRestitution(restitution); }
  void operator()(field::Texture, sim::Texture texture) { out.setTexture(static_cast<std::uint8_t>(texture)); }
  void operator()(field::Frozen, bool frozen) { out.setFrozen(frozen); }
  void operator()(field::Origin, const sim::Origin& origin) { encode_origin(origin, out.initOrigin()); }
  void operator()(field::Impulse, const sim::Vec3& impulse) { encode(impulse, out.initImpulse()); }
  void operator()(field::AtCentre, bool at_centre) { out.setAtCentre(at_centre); }
  void operator()(field::At, const sim::Vec3& p) { encode(p, out.initAt()); }
};

/// The inverse of PutFields: reads each field that PutFields writes.
template <class Reader>
struct GetFields {
  Reader in;

  void operator()(field::Id, sim::BodyId& id) { id = in.getId(); }
  void operator()(field::Size, sim::Vec3& size) { size = decode(in.getSize()); }
  void operator()(field::Mass, double& mass) { mass = in.getMass(); }
  void operator()(field::Static, bool& is_static) { is_static = in.getIsStatic(); }
  void operator()(field::Position, sim::Vec3& p) { p = decode(in.getPosition()); }
  void operator()(field::Orientation, sim::Quat& q) {
    q = {in.getOrientationW(), in.getOrientationX(), in.getOrientationY(), in.getOrientationZ()};
  }
  void operator()(field::Velocity, sim::Vec3& v) { v = decode(in.getVelocity()); }
  void operator()(field::Spin, sim::Vec3& w) { w = decode(in.getSpin()); }
  void operator()(field::Material, sim::Material& m) {
    for_each_field(m, GetFields<schema::Material::Reader>{in.getMaterial()});
  }
  void operator()(field::Friction, double& friction) { friction = in.getFriction(); }
  void operator()(field::FrictionDynamic, double& friction) { friction = in.getFrictionDynamic(); }
  void operator()(field::Restitution, double& restitution) { restitution = in.getRestitution(); }
  void operator()(field::Texture, sim::Texture& texture) {
    const bool known = in.getTexture() <= static_cast<std::uint8_t>(sim::Texture::kWhite);
    texture = known ? static_cast<sim::Texture>(in.getTexture()) : sim::Texture::kWhite;
  }
  void operator()(field::Frozen, bool& frozen) { frozen = in.getFrozen(); }
  void operator()(field::Origin, sim::Origin& origin) { origin = decode_origin(in.getOrigin()); }
  void operator()(field::Impulse, sim::Vec3& impulse) { impulse = decode(in.getImpulse()); }
  void operator()(field::AtCentre, bool& at_centre) { at_centre = in.getAtCentre(); }
  void operator()(field::At, sim::Vec3& p) { p = decode(in.getAt()); }
};

template <class Struct, class Builder>
void put(const Struct& from, Builder out) {
  for_each_field(from, PutFields<Builder>{out});
}

template <class Struct, class Reader>
Struct get(Reader in) {
  Struct to;
  for_each_field(to, GetFields<Reader>{in});
  return to;
}

/// One alternative of sim::Command each; there is no catch-all, so the compiler asks for a new one. Inputs of one field
/// have no struct in the schema: the union holds the value.
struct EncodeCommand {
  schema::Input::Builder out;
  void operator()(const sim::Throw& c) {
    for_each_field(c, [&](field::Box, const sim::BoxDef& box) { put(box, out.initThrow()); });
  }
  void operator()(const sim::Push& c) { put(c, out.initPush()); }
  void operator()(const sim::Remove& c) {
    for_each_field(c, [&](field::Id, sim::BodyId id) { out.setRemove(id); });
  }
  void operator()(const sim::Wake& c) {
    for_each_field(c, [&](field::Id, sim::BodyId id) { out.setWake(id); });
  }
  void operator()(const sim::SetVelocity& c) { put(c, out.initSetVelocity()); }
  void operator()(const sim::SetGravity& c) {
    for_each_field(c, [&](field::Gravity, const sim::Vec3& gravity) { encode(gravity, out.initSetGravity()); });
  }
  void operator()(const sim::SetDt& c) {
    for_each_field(c, [&](field::Dt, double dt) { out.setSetDt(dt); });
  }
};

Error unknown_input(schema::Input::Reader in) {
  return bad_input("the log has an input of kind \"" + std::string(in.getKind().cStr()) + "\" before step " +
                   std::to_string(in.getStep()) + ", which this program does not know; use a newer one");
}

}  // namespace

void encode(const sim::Vec3& v, schema::Vec3::Builder out) {
  out.setX(v.x());
  out.setY(v.y());
  out.setZ(v.z());
}

sim::Vec3 decode(schema::Vec3::Reader in) { return {in.getX(), in.getY(), in.getZ()}; }

void encode(const sim::Camera& camera, schema::Camera::Builder out) {
  encode(camera.position, out.initPosition());
  encode(camera.target, out.initTarget());
  out.setFov(camera.fov);
  out.setFocus(camera.focus);
  out.setBlur(camera.blur);
}

sim::Camera decode(schema::Camera::Reader in) {
  return {decode(in.getPosition()), decode(in.getTarget()), in.getFov(), in.getFocus(), in.getBlur()};
}

void encode(const sim::WorldDef& def, schema::WorldDef::Builder out) {
  out.setMethod(static_cast<std::uint8_t>(def.method));
  out.setDt(def.dt);
  out.setSubsteps(def.substeps);
  out.setSplitCollisions(def.split_collisions);
  encode(def.gravity, out.initGravity());
  out.setGround(def.ground);
  out.setFreezing(def.freezing);
  out.setFreezeEnergy(def.freeze_energy);
  out.setFreezeTime(def.freeze_time);
  out.setSlipSpeed(def.slip_speed);
  out.setAirDrag(def.air_drag);
  put(def.ground_material, out.initGroundMaterial());
}

Result<sim::WorldDef> decode(schema::WorldDef::Reader in) {
  if (in.getMethod() > static_cast<std::uint8_t>(sim::Method::kLayered)) {
    return bad_input("the log was recorded by method number " + std::to_string(in.getMethod()) +
                     ", which this program does not know; use a newer one");
  }
  sim::WorldDef def;
  def.method = static_cast<sim::Method>(in.getMethod());
  def.dt = in.getDt();
  def.substeps = in.getSubsteps();
  def.split_collisions = in.getSplitCollisions();
  def.gravity = decode(in.getGravity());
  def.ground = in.getGround();
  def.freezing = in.getFreezing();
  def.freeze_energy = in.getFreezeEnergy();
  def.freeze_time = in.getFreezeTime();
  def.slip_speed = in.getSlipSpeed();
  def.air_drag = in.getAirDrag();
  def.ground_material = get<sim::Material>(in.getGroundMaterial());
  return def;
}

void encode(const sim::TimedCommand& input, schema::Input::Builder out) {
  out.setStep(input.step);
  out.setKind(sim::name_of(input.command));
  std::visit(EncodeCommand{out}, input.command);
}

Result<sim::TimedCommand> decode(schema::Input::Reader in) {
  const auto timed = [&](sim::Command command) { return sim::TimedCommand{in.getStep(), std::move(command)}; };
  switch (in.which()) {
    case schema::Input::THROW:
      return timed(sim::Throw{get<sim::BoxDef>(in.getThrow())});
    case schema::Input::PUSH:
      return timed(get<sim::Push>(in.getPush()));
    case schema::Input::REMOVE:
      return timed(sim::Remove{in.getRemove()});
    case schema::Input::WAKE:
      return timed(sim::Wake{in.getWake()});
    case schema::Input::SET_VELOCITY:
      return timed(get<sim::SetVelocity>(in.getSetVelocity()));
    case schema::Input::SET_GRAVITY:
      return timed(sim::SetGravity{decode(in.getSetGravity())});
    case schema::Input::SET_DT:
      return timed(sim::SetDt{in.getSetDt()});
  }
  return unknown_input(in);
}

void encode(const sim::SceneDef& scene, schema::Scene::Builder out) {
  out.setName(scene.name);
  out.setTitle(scene.title);
  out.setCategory(scene.category);
  encode(scene.world, out.initWorld());
  out.setSteps(scene.steps);
  auto boxes = out.initBoxes(static_cast<unsigned>(scene.boxes.size()));
  for (unsigned i = 0; i < boxes.size(); ++i) put(scene.boxes[i], boxes[i]);
  auto inputs = out.initInputs(static_cast<unsigned>(scene.inputs.size()));
  for (unsigned i = 0; i < inputs.size(); ++i) encode(scene.inputs[i], inputs[i]);
  encode(scene.camera, out.initCamera());
  encode(scene.light.position, out.initLight().initPosition());
  encode(scene.light.target, out.getLight().initTarget());
}

Result<sim::SceneDef> decode(schema::Scene::Reader in, std::uint64_t message_bytes) {
  sim::SceneDef scene;
  scene.name = in.getName().cStr();
  scene.title = in.getTitle().cStr();
  scene.category = in.getCategory().cStr();
  Result<sim::WorldDef> world = decode(in.getWorld());
  if (!world.ok()) return world.error();
  scene.world = *world;
  scene.steps = in.getSteps();
  const auto boxes = in.getBoxes();
  const auto inputs = in.getInputs();
  if (boxes.size() > std::min(sim::kBodiesMax, message_bytes / kBoxBytesMin) ||
      inputs.size() > std::min(sim::kInputsMax, message_bytes / kInputBytesMin)) {
    return damaged("found a scene of " + std::to_string(boxes.size()) + " boxes and " + std::to_string(inputs.size()) +
                   " inputs in a message of " + std::to_string(message_bytes) + " bytes");
  }
  scene.boxes.reserve(boxes.size());
  scene.inputs.reserve(inputs.size());
  for (const schema::Box::Reader box : boxes) {
    scene.boxes.push_back(get<sim::BoxDef>(box));
    const sim::BodyId id = scene.boxes.back().id;
    const sim::BodyId before = scene.boxes.size() > 1 ? scene.boxes[scene.boxes.size() - 2].id : 0;
    if (id <= before || id > sim::kBodyIdMax) {
      return damaged("found body id " + std::to_string(id) + " after " + std::to_string(before) +
                     ", wanted ascending ids up to 2^53 - 1");
    }
  }
  for (const schema::Input::Reader input : inputs) {
    Result<sim::TimedCommand> command = decode(input);
    if (!command.ok()) return command.error();
    scene.inputs.push_back(*command);
  }
  scene.camera = decode(in.getCamera());
  const schema::Light::Reader light = in.getLight();
  scene.light = {decode(light.getPosition()), decode(light.getTarget())};
  return scene;
}

void encode(const sim::Transform& transform, schema::Transform::Builder out) {
  out.setMirrorX(transform.mirror_x);
  out.setMirrorY(transform.mirror_y);
  out.setSwapXy(transform.swap_xy);
  encode(transform.shift, out.initShift());
  out.setPermuted(transform.permute.has_value());
  out.setPermuteSeed(transform.permute.value_or(0));
}

sim::Transform decode(schema::Transform::Reader in) {
  sim::Transform transform{in.getMirrorX(), in.getMirrorY(), in.getSwapXy(), decode(in.getShift()), std::nullopt};
  if (in.getPermuted()) transform.permute = in.getPermuteSeed();
  return transform;
}

}  // namespace tumble::replay
