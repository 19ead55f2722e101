#include "tests/toy/toy_solver.h"

#include <algorithm>

#include "replay/probe/tumble_probe.h"

namespace tumble::toy {
namespace {

constexpr int kIterations = 6;
constexpr double kFriction = 0.5;
constexpr double kBaumgarte = 0.2;

}  // namespace

void Solver::find_contacts() {
  contacts_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool on_ground = i == 0;
    const double below = on_ground ? -0.5 : bodies[i - 1].z;
    const double depth = line(2, below + 1 - bodies[i].z);
    TUMBLE_PROBE(&tumble_probes, "toy.depth", bodies[i].id, depth);
    if (depth < -0.01) continue;
    Contact contact;
    contact.a = on_ground ? kGround : i - 1;
    contact.b = i;
    contact.depth = depth;
    contact.mass = line(3, on_ground ? 1.0 : 0.5);
    TUMBLE_PROBE(&tumble_probes, "toy.mass", bodies[i].id, contact.mass);
    contact.bias = line(4, kBaumgarte * std::max(depth, 0.0) / kDt);
    TUMBLE_PROBE(&tumble_probes, "toy.bias", bodies[i].id, contact.bias);
    contacts_.push_back(contact);
  }
  if (reverse) std::ranges::reverse(contacts_);
}

void Solver::solve() {
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    for (Contact& contact : contacts_) {
      Body ground;
      Body& a = contact.a == kGround ? ground : bodies[contact.a];
      Body& b = bodies[contact.b];
      const double relative = line(5, b.vz - a.vz);
      TUMBLE_PROBE_PAIR(&tumble_probes, "toy.relative", a.id, b.id, relative);
      const double before = contact.lambda;
      contact.lambda = line(6, std::max(before + contact.mass * (contact.bias - relative), 0.0));
      TUMBLE_PROBE_PAIR(&tumble_probes, "toy.lambda", a.id, b.id, contact.lambda);
      const double push = contact.lambda - before;
      const double slip =
          line(7, std::clamp(contact.mass * (a.vx - b.vx), -kFriction * contact.lambda, kFriction * contact.lambda));
      TUMBLE_PROBE_PAIR(&tumble_probes, "toy.slip", a.id, b.id, slip);
      b.vz = line(8, b.vz + push);
      TUMBLE_PROBE(&tumble_probes, "toy.upper", b.id, b.vz);
      b.vx += slip;
      if (contact.a == kGround) continue;
      a.vz -= push;
      a.vx -= slip;
    }
  }
}

void Solver::step(std::uint64_t k) {
  tumble_probes_step(&tumble_probes, k);
  for (Body& body : bodies) {
    body.vz = line(1, body.vz - gravity * kDt);
    TUMBLE_PROBE(&tumble_probes, "toy.fall", body.id, body.vz);
  }
  find_contacts();
  solve();
  for (Body& body : bodies) {
    body.z = line(9, body.z + kDt * body.vz);
    TUMBLE_PROBE(&tumble_probes, "toy.z", body.id, body.z);
    body.x = line(10, body.x + kDt * body.vx);
    TUMBLE_PROBE(&tumble_probes, "toy.x", body.id, body.x);
  }
}

}  // namespace tumble::toy
