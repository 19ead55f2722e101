#include "replay/view/contact_points.h"

#include <string>
#include <utility>

#include "src/world/scratch.h"

namespace tumble::replay {
namespace {

/// With the lower id first, and the ground last.
ContactPoint point_of(const sim::World& world, sim::BodyIndex a, sim::BodyIndex b, const sim::Vec3& normal) {
  ContactPoint point;
  const auto& ids = world.bodies().id;
  const bool b_is_first = a == sim::kGround || (b != sim::kGround && ids[b] < ids[a]);
  point.normal = b_is_first ? sim::Vec3(-normal) : normal;
  point.a = ids[b_is_first ? b : a];
  const sim::BodyIndex other = b_is_first ? a : b;
  if (other != sim::kGround) {
    point.b = ids[other];
  } else if (point.normal.z() < 0) {
    point.normal = -point.normal;
  }
  return point;
}

std::vector<ContactPoint> thesis_points(const sim::World& world) {
  std::vector<ContactPoint> points;
  const sim::Contacts& contacts = world.scratch().contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ContactPoint point = point_of(world, contacts.a[i], contacts.b[i], contacts.normal[i]);
    point.at = world.scratch().frames[contacts.a[i]].position + contacts.r_a[i];
    point.depth = contacts.depth[i];
    point.impulse = sim::length(contacts.impulse[i]);
    points.push_back(point);
  }
  return points;
}

std::vector<ContactPoint> layered_points(const sim::World& world) {
  std::vector<ContactPoint> points;
  const sim::Scratch& scratch = world.scratch();
  for (const sim::Manifold& manifold : scratch.manifolds) {
    if (manifold.asleep) continue;
    const sim::Vec3 centre = world.bodies().position[manifold.b];
    for (const sim::ManifoldPoint& found : sim::points_of(scratch, manifold)) {
      ContactPoint point = point_of(world, manifold.a, manifold.b, manifold.n);
      point.at = centre + manifold.t1 * found.p + manifold.t2 * found.q + manifold.n * manifold.offset;
      point.depth = -found.separation;
      point.impulse = found.impulse;
      points.push_back(point);
    }
  }
  return points;
}

constexpr std::uint64_t kStepsOn = 64;  // stepping that far on costs no more than a keyframe and the steps after it

}  // namespace

std::vector<ContactPoint> contact_points(const sim::World& world) {
  return world.state().def.method == sim::Method::kThesis ? thesis_points(world) : layered_points(world);
}

Result<std::vector<ContactPoint>> ContactSource::logged(std::uint64_t k) {
  const Result<const StepRecord*> record = log_->read_step(k);
  if (!record.ok()) return record.error();
  const std::vector<EngineContact>& contacts = (*record)->extras.contacts;
  if (contacts.empty()) {
    return bad_input(log_->name() + ": the log of another engine holds no contacts of step " + std::to_string(k));
  }
  std::vector<ContactPoint> points;
  for (const EngineContact& contact : contacts) {
    ContactPoint point = {contact.a, std::nullopt, contact.position, contact.normal, contact.depth, contact.impulse};
    if (contact.b != 0) {
      point.b = contact.b;
    } else {
      point.normal = -contact.normal;  // from the world to the body
    }
    points.push_back(point);
  }
  return points;
}

Result<std::vector<ContactPoint>> ContactSource::read(std::uint64_t k) {
  if (log_->header().engine) return logged(k);
  if (k <= log_->first_state()) return std::vector<ContactPoint>();
  if (!player_ || player_->world().state().step >= k || player_->world().state().step + kStepsOn < k) {
    player_.reset();
    Result<Player> player = Player::at(*log_, k - 1);
    if (!player.ok()) return player.error();
    player_ = *std::move(player);
  }
  if (Status ok = player_->step_to(k); !ok.ok()) {
    player_.reset();
    return ok.error();
  }
  return contact_points(player_->world());
}

}  // namespace tumble::replay
