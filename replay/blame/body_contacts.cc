#include "replay/blame/body_contacts.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "replay/blame/question.h"
#include "replay/blame/steps_again.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "src/world/scratch.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

constexpr double kTouching = 0.02;  // m; as islands of method layered

/// Bodies joined by contacts.
class Joined {
 public:
  explicit Joined(std::size_t bodies) : neighbours_(bodies) {}
  void join(sim::BodyIndex a, sim::BodyIndex b) {
    if (a == sim::kGround || b == sim::kGround) return;
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
  }
  /// Through bodies that are not static.
  [[nodiscard]] std::vector<sim::BodyId> around(sim::BodyIndex row, const sim::Bodies& bodies) const {
    std::vector<std::uint8_t> seen(neighbours_.size(), 0);
    std::vector<sim::BodyIndex> front = {row};
    std::vector<sim::BodyId> found;
    seen[row] = 1;
    while (!front.empty()) {
      const sim::BodyIndex i = front.back();
      front.pop_back();
      found.push_back(bodies.id[i]);
      if (bodies.is_static[i] != 0) continue;
      for (const sim::BodyIndex next : neighbours_[i]) {
        if (seen[next] != 0 || bodies.is_static[next] != 0) continue;
        seen[next] = 1;
        front.push_back(next);
      }
    }
    std::ranges::sort(found);
    return found;
  }

 private:
  std::vector<std::vector<sim::BodyIndex>> neighbours_;
};

class ContactsObserver : public sim::Observer {
 public:
  ContactsObserver(const sim::World& world, sim::BodyIndex row, BodyContacts& out)
      : row_(row), out_(out), joined_(world.bodies().size()) {}

  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    const sim::PhaseTable table = sim::phase_table(world.state().def.method);
    const std::string_view name = table.phases[phase].name;
    const bool last = phase + 1 == table.phases.size();
    if (world.state().def.method == sim::Method::kThesis) {
      if (name == "compute_separation") add_thesis(substep, world);
    } else {
      if (phase + 1 == table.substeps_end) {
        add_batches(substep, world, world.scratch().contact_batches, false);
        if (!world.scratch().fast.none()) add_batches(substep, world, world.scratch().fast.batches, true);
      }
      if (last) finish_layered(substep, world);
    }
    // Method thesis has its last phase in every substep.
    if (last) out_.island = joined_.around(row_, world.bodies());
  }

 private:
  [[nodiscard]] bool of_row(sim::BodyIndex a, sim::BodyIndex b) const { return a == row_ || b == row_; }
  std::optional<sim::BodyId> other(sim::BodyIndex a, sim::BodyIndex b, const sim::Bodies& bodies) const {
    const sim::BodyIndex i = a == row_ ? b : a;
    return i == sim::kGround ? std::nullopt : std::optional(bodies.id[i]);
  }

  void add_thesis(std::uint32_t substep, const sim::World& world) {
    const sim::Contacts& contacts = world.scratch().contacts;
    const sim::Bodies& bodies = world.bodies();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      joined_.join(contacts.a[k], contacts.b[k]);
      if (!of_row(contacts.a[k], contacts.b[k])) continue;
      const double sign = contacts.b[k] == row_ ? 1 : -1;
      BodyContact contact;
      contact.substep = substep;
      contact.other = other(contacts.a[k], contacts.b[k], bodies);
      contact.normal = contacts.normal[k] * sign;
      const sim::Vec3 impulse = contacts.impulse[k] * sign;
      contact.impulse = sim::dot(impulse, contact.normal);
      contact.friction = impulse - contact.normal * contact.impulse;
      contact.points.push_back(
          {bodies.position[contacts.a[k]] + contacts.r_a[k], contacts.depth[k], contact.impulse, 0});
      out_.contacts.push_back(contact);
    }
  }

  void add_batches(std::uint32_t substep, const sim::World& world, const sim::ContactBatches& all, bool fast) {
    const sim::Scratch& scratch = world.scratch();
    const LargeVector<sim::Manifold>& manifolds = fast ? scratch.fast.found.manifolds : scratch.manifolds;
    for (const sim::ContactBatch& batch : all.batches) {
      for (unsigned lane = 0; lane < batch.used; ++lane) {
        const sim::Manifold& m = manifolds[all.order[batch.members + lane]];
        if (fast) joined_.join(m.a, m.b);
        if (!of_row(m.a, m.b)) continue;
        BodyContact contact = of_manifold(m, world.bodies());
        contact.substep = substep;
        contact.fast = fast;
        const double sign = m.b == row_ ? 1 : -1;
        contact.friction = (m.t1 * batch.force1.of[lane] + m.t2 * batch.force2.of[lane]) * sign;
        contact.twist = batch.twist.of[lane];
        for (unsigned k = 0; k < m.count; ++k) {
          const sim::PointBatch& point = all.points[batch.first + k];
          add_point(contact, place_of(m, world.bodies(), point.p.of[lane], point.q.of[lane], batch.offset.of[lane]),
                    -point.separation.of[lane], point.impulse.of[lane], point.load.of[lane]);
        }
        out_.contacts.push_back(contact);
      }
    }
  }

  BodyContact of_manifold(const sim::Manifold& m, const sim::Bodies& bodies) const {
    BodyContact contact;
    contact.other = other(m.a, m.b, bodies);
    contact.normal = m.b == row_ ? m.n : sim::Vec3(-m.n);
    contact.asleep = m.asleep;
    return contact;
  }

  // A point of a manifold in the world. offset: m, as Manifold::offset.
  static sim::Vec3 place_of(const sim::Manifold& m, const sim::Bodies& bodies, double p, double q, double offset) {
    return bodies.position[m.b] + (m.t1 * p + m.t2 * q + m.n * offset);
  }

  static void add_point(BodyContact& contact, const sim::Vec3& place, double depth, double impulse, double load) {
    contact.points.push_back({place, depth, impulse, load});
    contact.impulse += impulse;
  }

  void finish_layered(std::uint32_t substep, const sim::World& world) {
    const sim::Scratch& scratch = world.scratch();
    for (const sim::Manifold& m : scratch.manifolds) {
      const auto points = sim::points_of(scratch, m);
      const auto touches = [](const sim::ManifoldPoint& point) { return point.separation < kTouching; };
      if (m.asleep || std::ranges::any_of(points, touches)) joined_.join(m.a, m.b);
      if (!m.asleep || !of_row(m.a, m.b)) continue;
      BodyContact contact = of_manifold(m, world.bodies());
      contact.substep = substep;
      contact.friction = m.d * (m.b == row_ ? 1.0 : -1.0);
      contact.twist = m.twist;
      for (const sim::ManifoldPoint& point : points) {
        add_point(contact, place_of(m, world.bodies(), point.p, point.q, m.offset), -point.separation, point.impulse,
                  point.load);
      }
      out_.contacts.push_back(contact);
    }
    if (row_ < scratch.weights.borne.size()) out_.borne = scratch.weights.borne[row_];
    if (row_ < scratch.solver_mass.size()) out_.lent = scratch.solver_mass[row_] - out_.mass;
  }

  sim::BodyIndex row_;
  BodyContacts& out_;
  Joined joined_;
};

}  // namespace

Result<BodyContacts> contacts_of_body(LogReader& log, sim::BodyId body, std::uint64_t k, const Progress& progress) {
  StepsAgain steps(log, progress);
  const Result<BodyMotion> asked = body_asked(steps, body, k);
  if (!asked.ok()) return asked.error();
  if (k == log.first_state()) {
    return bad_input(log.name() + ": state " + std::to_string(k) +
                     " is the log's first: no step led to it, so it has no " + "contacts; ask for --step " +
                     std::to_string(k + 1) + " or more");
  }
  Result<sim::World> world = steps.world_before(k);
  if (!world.ok()) return world.error();
  const std::optional<sim::BodyIndex> row = world->bodies().find(body);
  SIM_CHECK(row.has_value(), body);
  BodyContacts found;
  found.step = k;
  found.body = body;
  found.mass = world->bodies().mass[*row];
  ContactsObserver observer(*world, *row, found);
  if (Status ok = steps.take(*world, observer); !ok.ok()) return ok.error();
  if (world->state().def.method == sim::Method::kThesis) {
    found.notes.emplace_back("method thesis passes no weight on, so there is no load");
  }
  if (!log.condition().whole())
    found.notes.push_back(log.name() + " is not whole: " + log.condition().summary(log.last_step()));
  return found;
}

}  // namespace tumble::replay
