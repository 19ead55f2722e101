// Thesis III.B: equation 3.1 and Coulomb friction, with the numbers worked out by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "src/thesis/collision_impulse.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::ContactBody;
using sim::PairMaterial;
using sim::Vec3;

void expect_near(const Vec3& found, const Vec3& wanted, double tolerance = 1e-12) {
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), tolerance)
      << "found " << found.transpose() << ", wanted " << wanted.transpose();
}

ContactBody point_mass(double mass, const Vec3& velocity) {
  ContactBody body;
  body.inverse_mass = 1 / mass;
  body.velocity = velocity;
  return body;
}

sim::Collision collide(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                       const std::vector<Vec3>& patch) {
  sim::Encounter met;
  sim::find_encounter(a, b, normal, material, patch.size(), met);
  return sim::collide(a, b, normal, material, met, patch);
}

// Of a collision at one point.
Vec3 impulse_of(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material) {
  return collide(a, b, normal, material, {}).impulse;
}

PairMaterial smooth(double restitution) { return {0, 0, restitution, 0.01}; }

Vec3 velocity_of_point(const ContactBody& body) { return body.velocity + body.spin.cross(body.r); }

// The body after the impulse, by Newton and Euler; box axes along the world's.
ContactBody after(ContactBody body, const Vec3& impulse) {
  body.velocity += impulse * body.inverse_mass;
  body.spin += body.r.cross(impulse).cwiseProduct(body.inverse_inertia);
  return body;
}

// 1 kg at 2 m/s meets 3 kg at −1 m/s: approach 3, 1/mA + 1/mB = 4/3, so J = 1.5 · 3 / (4/3) = 3.375 at ε = ½. Then
// 2 − 3.375 and −1 + 3.375/3 part at 1.5 = ε · 3.
TEST(CollisionImpulse, CentralCollisionOfUnequalMasses) {
  const ContactBody a = point_mass(1, {2, 0, 0}), b = point_mass(3, {-1, 0, 0});
  const Vec3 impulse = impulse_of(a, b, {1, 0, 0}, smooth(0.5));
  expect_near(impulse, {3.375, 0, 0});
  EXPECT_NEAR(after(b, impulse).velocity.x() - after(a, -impulse).velocity.x(), 1.5, 1e-12);
}

ContactBody turning_a() {
  ContactBody a = point_mass(2, {1, 0, 0});
  a.spin = {0, 0, 2};
  a.r = {0.5, 0.3, 0};
  a.inverse_inertia = {1 / 0.3, 1 / 0.2, 1 / 0.4};
  return a;
}

ContactBody turning_b() {
  ContactBody b = point_mass(1, {-1, 0, 0.5});
  b.spin = {0, 1, 0};
  b.r = {-0.5, -0.2, 0.1};
  b.inverse_inertia = {1 / 0.1, 1 / 0.2, 1 / 0.5};
  return b;
}

// r × n: a (0, 0, −0.3), b (0, 0.1, 0.2). Denominator 1/2 + 1 + 0.09/0.4 + 0.01/0.2 + 0.04/0.5 = 1.855.
// Points: a (1, 0, 0) + (0, 0, 2) × r = (0.4, 1, 0); b (−1, 0, ½) + (0, 1, 0) × r = (−0.9, 0, 1). Approach 1.3.
TEST(CollisionImpulse, OffCentreCollisionOfTwoTurningBodies) {
  const ContactBody a = turning_a(), b = turning_b();
  const Vec3 impulse = impulse_of(a, b, {1, 0, 0}, smooth(0.2));
  expect_near(impulse, {1.2 * 1.3 / 1.855, 0, 0});
  const Vec3 parting = velocity_of_point(after(b, impulse)) - velocity_of_point(after(a, -impulse));
  EXPECT_NEAR(parting.x(), 0.2 * 1.3, 1e-12) << "ε times the approach";
}

// With B fixed, 1/mB and its rotation drop out: 1/2 + 0.225, approach 0.4 against n = x.
TEST(CollisionImpulse, CollisionWithAFixedBody) {
  const Vec3 impulse = impulse_of(turning_a(), ContactBody{}, {1, 0, 0}, smooth(0.2));
  expect_near(impulse, {1.2 * 0.4 / 0.725, 0, 0});
}

// A quarter turn about z lays the body's y axis along −x … so the world's x inertia is the body's y one: turning a long
// body changes how it yields. r × n = (0.6, 0, 0) for r = (0, 0, 0.6), n = −y; I about world x is the body's y: 0.2.
TEST(CollisionImpulse, InertiaTurnsWithTheBody) {
  ContactBody a = point_mass(2, {0, -1, 0});
  a.r = {0, 0, 0.6};
  a.inverse_inertia = {1 / 0.3, 1 / 0.2, 1 / 0.4};
  a.axes = axes_of(sim::normalised(turn({0, 0, 1}, 0, 1)));
  const Vec3 impulse = impulse_of(a, ContactBody{}, {0, -1, 0}, smooth(0));
  expect_near(impulse, {0, -1 / (0.5 + 0.36 / 0.2), 0});
  expect_near(spin_gain_of(a, {0, 1, 0}), {-0.6 / 0.2, 0, 0});
}

double kinetic_energy(const ContactBody& body) {
  const double turning = body.spin.cwiseProduct(body.inverse_inertia.cwiseInverse()).dot(body.spin);
  return 0.5 * (body.velocity.squaredNorm() / body.inverse_mass + turning);
}

// III.E: no energy is pumped in. An elastic, rough, off-centre bounce of a unit cube would gain 33 % if 3.1 and
// Coulomb's bound were simply put together (each changes the speed that the other was found from).
TEST(CollisionImpulse, RestitutionWithFrictionGainsNoEnergy) {
  Random random(17);
  int shortened = 0;
  for (int k = 0; k < 2000; ++k) {
    ContactBody cube = point_mass(1, {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-5, 0)});
    cube.inverse_inertia = {6, 6, 6};
    cube.spin = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
    cube.r = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -0.5};
    const Vec3 impulse = impulse_of(ContactBody{}, cube, {0, 0, 1}, {0.8, 0.8, 1, 0.01});
    const double before = kinetic_energy(cube), gain = kinetic_energy(after(cube, impulse)) - before;
    EXPECT_LT(gain, 1e-12 * before) << "trial " << k;
    shortened += impulse.squaredNorm() > 0 && gain > -1e-12 * before ? 1 : 0;
  }
  EXPECT_GT(shortened, 100) << "the bound must have been reached";
}

TEST(CollisionImpulse, PartingBodiesGetNone) {
  for (const double speed : {0.0, 0.1, 5.0}) {
    const Vec3 impulse =
        impulse_of(point_mass(1, {0, 3, 0}), point_mass(1, {speed, 0, 0}), {1, 0, 0}, {0.5, 0.5, 1, 0.01});
    EXPECT_EQ(impulse, Vec3(0, 0, 0)) << speed;
  }
}

// 1 kg, approach 1, ε = 0: the normal impulse is 1. Sliding at 3 m/s in y: friction 0.3 · 1 against the slip of b.
TEST(Friction, SlidingIsBoundByTheDynamicCoefficient) {
  const ContactBody a = point_mass(1e300, {0, 0, 0});
  const ContactBody b = point_mass(1, {-1, 3, 0});
  expect_near(impulse_of(a, b, {1, 0, 0}, {0.5, 0.3, 0, 0.01}), {1, -0.3, 0});
}

// Below slip_speed the static coefficient bounds, at it the dynamic one. Approach 0.001, so the bounds are 5e-4 and
// 3e-4.
TEST(Friction, SlowSlipIsBoundByTheStaticCoefficient) {
  const ContactBody a = point_mass(1e300, {0, 0, 0});
  const PairMaterial material = {0.5, 0.3, 0, 0.01};
  const ContactBody slow = point_mass(1, {-0.001, 0.00999, 0}), quick = point_mass(1, {-0.001, 0.01, 0});
  expect_near(impulse_of(a, slow, {1, 0, 0}, material), {0.001, -0.0005, 0});
  expect_near(impulse_of(a, quick, {1, 0, 0}, material), {0.001, -0.0003, 0});
}

// 1 kg on a slope, put there at rest: 0.03 m/s of slip and 0.05 m/s of approach are what gravity has added in this
// substep. Friction 0.7 holds the slip, although it is above slip_speed; 0.5 does not, so the dynamic coefficient
// counts from the first substep on.
TEST(Friction, StaticFrictionIsJudgedBeforeGravity) {
  ContactBody resting = point_mass(1, {-0.05, 0.03, 0});
  resting.gained = resting.velocity;
  expect_near(impulse_of({}, resting, {1, 0, 0}, {0.7, 0.2, 0, 0.01}), {0.05, -0.03, 0});
  expect_near(impulse_of({}, resting, {1, 0, 0}, {0.5, 0.2, 0, 0.01}), {0.05, -0.01, 0});
  ContactBody sliding = resting;
  sliding.velocity.y() = 0.08;
  expect_near(impulse_of({}, sliding, {1, 0, 0}, {0.7, 0.2, 0, 0.01}), {0.05, -0.01, 0});
}

// At rest restitution adds to the impulse and III.E takes it back: it must not press. 0.5 · 0.05 bounds, not 0.5 ·
// 0.09.
TEST(Friction, RestitutionDoesNotPressAtRest) {
  ContactBody resting = point_mass(1, {-0.05, 1, 0});
  resting.gained = {-0.05, 0, 0};
  const std::vector<Vec3> patch = {{0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}};
  resting.inverse_inertia = {2, 2, 2};
  expect_near(collide({}, resting, {1, 0, 0}, {0.5, 0.5, 0.8, 0.01}, patch).impulse, {0.09, -0.025, 0});
}

// A flat crate of 1 kg rubs at its bottom, 0.5 m below the centre: its corners share the load so that it does not tilt.
// A crate that turns on the spot is braked by 0.4 · 0.1 N·s at the mean distance of the corners, √2 m.
TEST(Friction, ARestingFaceNeitherTiltsNorTwists) {
  ContactBody crate = point_mass(1, {1, 0, -0.1});
  crate.gained = {0, 0, -0.1};
  crate.inverse_inertia = {2, 2, 2};
  crate.r = {0, 0, -0.5};
  const std::vector<Vec3> patch = {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
  const sim::Collision slides = collide(crate, {}, {0, 0, -1}, {0.4, 0.4, 0, 0.01}, patch);
  expect_near(slides.impulse, {0.04, 0, -0.1});
  expect_near(slides.shift, {0.2, 0, 0}, 1e-10);
  crate.r += slides.shift;
  expect_near(spin_gain_of(crate, -slides.impulse, -slides.twist), {0, 0, 0}, 1e-10);
  crate.r = {0, 0, -0.5};
  crate.velocity = {0, 0, -0.1};
  crate.spin = {0, 0, 3};
  const sim::Collision turns = collide(crate, {}, {0, 0, -1}, {0.4, 0.4, 0, 0.01}, patch);
  expect_near(turns.impulse, {0, 0, -0.1});
  expect_near(turns.twist, {0, 0, 0.04 * std::sqrt(2.0)}, 1e-10);
}

// Slip of 0.1 m/s is stopped by 0.1 N·s, less than 0.5 · 1, and not turned round.
TEST(Friction, StopsTheSlipAndNeverReversesIt) {
  const ContactBody a = point_mass(1e300, {0, 0, 0}), b = point_mass(1, {-1, 0.1, 0});
  const Vec3 impulse = impulse_of(a, b, {1, 0, 0}, {0.5, 0.5, 0, 0.01});
  expect_near(impulse, {1, -0.1, 0});
  expect_near(after(b, impulse).velocity, {0, 0, 0});
}

// A cube of 1 kg on its face, 6 per kg·m² of inverse inertia, point ½ m below the centre: along the tangent a unit
// impulse moves the point by 1 + 6/4 = 2.5. Slip 0.2 is stopped by 0.08; torque −½ z × −0.08 x = +0.04 y rolls it
// forward: spin 0.24 about y.
TEST(Friction, OffCentreFrictionStopsThePointAndTurnsTheBody) {
  ContactBody a = point_mass(1, {0.2, 0, -1});
  a.r = {0, 0, -0.5};
  a.inverse_inertia = {6, 6, 6};
  const Vec3 impulse = impulse_of(a, ContactBody{}, {0, 0, -1}, {0.5, 0.5, 0, 0.01});
  expect_near(impulse, {0.08, 0, -1});
  expect_near(spin_gain_of(a, -impulse), {0, 0.24, 0});
  expect_near(velocity_of_point(after(a, -impulse)), {0, 0, 0});
}

TEST(Friction, WithoutNormalImpulseThereIsNone) {
  const Vec3 impulse = impulse_of(point_mass(1, {0, 0, 0}), point_mass(1, {0, 4, 0}), {1, 0, 0}, {0.9, 0.9, 0, 0.01});
  EXPECT_EQ(impulse, Vec3(0, 0, 0));
}

// Over random contacts: inside the cone, opposed to the slip of b, and no more than stops it.
TEST(Friction, LiesInTheConeAgainstTheSlip) {
  Random random(12);
  const auto vector = [&](double s) {
    const double x = random.uniform(-s, s), y = random.uniform(-s, s);
    return Vec3(x, y, random.uniform(-s, s));
  };
  int in_contact = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    ContactBody a = turning_a(), b = turning_b();
    for (ContactBody* body : {&a, &b}) {
      body->velocity = vector(2);
      body->spin = vector(3);
      body->r = vector(0.5);
    }
    const Vec3 n = vector(1).normalized();
    const PairMaterial material = {0.6, 0.35, random.uniform(0, 1), 0.5};
    const Vec3 impulse = impulse_of(a, b, n, material);
    const Vec3 relative = velocity_of_point(b) - velocity_of_point(a);
    if (relative.dot(n) >= 0) continue;
    ++in_contact;
    const double along = impulse.dot(n);
    const Vec3 friction = impulse - n * along, slip = relative - n * relative.dot(n);
    const double coefficient = slip.norm() < 0.5 ? 0.6 : 0.35;
    EXPECT_GT(along, 0);
    EXPECT_LE(friction.norm(), coefficient * along * (1 + 1e-12));
    EXPECT_NEAR(friction.dot(slip), -friction.norm() * slip.norm(), 1e-12) << "straight against the slip";
    // Friction by itself, over what the normal part does, takes speed from the slip and does not turn it round.
    const Vec3 with = velocity_of_point(after(b, friction)) - velocity_of_point(after(a, -friction));
    EXPECT_GE(with.dot(slip), -1e-12);
  }
  EXPECT_GT(in_contact, 1000);
}

}  // namespace
}  // namespace tumble::test
