#include "replay/codec/scene_codec.h"

#include <algorithm>
#include <string>

#include "replay/format/limits.h"
#include "src/model/limits.h"

namespace tumble::replay {
namespace {

void encode_material(const sim::Material& material, schema::Material::Builder out) {
  out.setFriction(material.friction);
  out.setFrictionDynamic(material.friction_dynamic);
  out.setRestitution(material.restitution);
  out.setTexture(static_cast<std::uint8_t>(material.texture));
}

sim::Material decode_material(schema::Material::Reader in) {
  sim::Material material{in.getFriction(), in.getFrictionDynamic(), in.getRestitution()};
  const bool known = in.getTexture() <= static_cast<std::uint8_t>(sim::Texture::kWhite);
  material.texture = known ? static_cast<sim::Texture>(in.getTexture()) : sim::Texture::kWhite;
  return material;
}

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

void encode_box(const sim::BoxDef& box, schema::Box::Builder out) {
  out.setId(box.id);
  encode(box.size, out.initSize());
  out.setMass(box.mass);
  out.setIsStatic(box.is_static);
  encode(box.position, out.initPosition());
  out.setOrientationW(box.orientation.w);
  out.setOrientationX(box.orientation.x);
  out.setOrientationY(box.orientation.y);
  out.setOrientationZ(box.orientation.z);
  encode(box.velocity, out.initVelocity());
  encode(box.spin, out.initSpin());
  encode_material(box.material, out.initMaterial());
  out.setFrozen(box.frozen);
  encode_origin(box.origin, out.initOrigin());
}

sim::BoxDef decode_box(schema::Box::Reader in) {
  sim::BoxDef box;
  box.id = in.getId();
  box.size = decode(in.getSize());
  box.mass = in.getMass();
  box.is_static = in.getIsStatic();
  box.position = decode(in.getPosition());
  box.orientation = {in.getOrientationW(), in.getOrientationX(), in.getOrientationY(), in.getOrientationZ()};
  box.velocity = decode(in.getVelocity());
  box.spin = decode(in.getSpin());
  box.material = decode_material(in.getMaterial());
  box.frozen = in.getFrozen();
  box.origin = decode_origin(in.getOrigin());
  return box;
}

/// One alternative of sim::Command each; there is no catch-all, so the compiler asks for a new one.
struct EncodeCommand {
  schema::Input::Builder out;
  void operator()(const sim::Throw& c) { encode_box(c.box, out.initThrow()); }
  void operator()(const sim::Push& c) {
    schema::Push::Builder push = out.initPush();
    push.setId(c.id);
    encode(c.impulse, push.initImpulse());
    push.setAtCentre(c.at_centre);
    encode(c.at, push.initAt());
  }
  void operator()(const sim::Remove& c) { out.setRemove(c.id); }
  void operator()(const sim::Wake& c) { out.setWake(c.id); }
  void operator()(const sim::SetVelocity& c) {
    schema::SetVelocity::Builder set = out.initSetVelocity();
    set.setId(c.id);
    encode(c.velocity, set.initVelocity());
    encode(c.spin, set.initSpin());
  }
  void operator()(const sim::SetGravity& c) { encode(c.gravity, out.initSetGravity()); }
  void operator()(const sim::SetDt& c) { out.setSetDt(c.dt); }
};

Error unknown_input(schema::Input::Reader in) {
  return bad_input("the log has an input of kind \"" + std::string(in.getKind().cStr()) + "\" before step " +
                   std::to_string(in.getStep()) + ", which this program does not know; use a newer one");
}

void encode_camera(const sim::Camera& camera, schema::Camera::Builder out) {
  encode(camera.position, out.initPosition());
  encode(camera.target, out.initTarget());
  out.setFov(camera.fov);
  out.setFocus(camera.focus);
  out.setBlur(camera.blur);
}

}  // namespace

void encode(const sim::Vec3& v, schema::Vec3::Builder out) {
  out.setX(v.x());
  out.setY(v.y());
  out.setZ(v.z());
}

sim::Vec3 decode(schema::Vec3::Reader in) { return {in.getX(), in.getY(), in.getZ()}; }

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
  encode_material(def.ground_material, out.initGroundMaterial());
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
  def.ground_material = decode_material(in.getGroundMaterial());
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
      return timed(sim::Throw{decode_box(in.getThrow())});
    case schema::Input::PUSH: {
      const schema::Push::Reader push = in.getPush();
      return timed(sim::Push{push.getId(), decode(push.getImpulse()), push.getAtCentre(), decode(push.getAt())});
    }
    case schema::Input::REMOVE:
      return timed(sim::Remove{in.getRemove()});
    case schema::Input::WAKE:
      return timed(sim::Wake{in.getWake()});
    case schema::Input::SET_VELOCITY: {
      const schema::SetVelocity::Reader set = in.getSetVelocity();
      return timed(sim::SetVelocity{set.getId(), decode(set.getVelocity()), decode(set.getSpin())});
    }
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
  for (unsigned i = 0; i < boxes.size(); ++i) encode_box(scene.boxes[i], boxes[i]);
  auto inputs = out.initInputs(static_cast<unsigned>(scene.inputs.size()));
  for (unsigned i = 0; i < inputs.size(); ++i) encode(scene.inputs[i], inputs[i]);
  encode_camera(scene.camera, out.initCamera());
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
    scene.boxes.push_back(decode_box(box));
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
  const schema::Camera::Reader camera = in.getCamera();
  scene.camera = {decode(camera.getPosition()), decode(camera.getTarget()), camera.getFov(), camera.getFocus(),
                  camera.getBlur()};
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
