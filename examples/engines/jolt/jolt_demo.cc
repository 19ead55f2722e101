// Ten cubes in Jolt, recorded. ../demo.h has the arguments.
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemThreadPool.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceMask.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterMask.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterMask.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/RegisterTypes.h>

#include "../demo.h"
#include "tumble_jolt.h"

using namespace JPH;

int main(int count, char** words) {
  Demo demo(count, words);
  RegisterDefaultAllocator();
  Factory::sInstance = new Factory();
  RegisterTypes();
  TempAllocatorImpl memory(16 << 20);
  JobSystemThreadPool jobs(cMaxPhysicsJobs, cMaxPhysicsBarriers, 2);
  constexpr uint32 kFixed = 1, kMoves = 2;  // groups
  BroadPhaseLayerInterfaceMask layers(2);
  layers.ConfigureLayer(BroadPhaseLayer(0), kFixed, 0);
  layers.ConfigureLayer(BroadPhaseLayer(1), kMoves, 0);
  const ObjectVsBroadPhaseLayerFilterMask broad_filter(layers);
  const ObjectLayerPairFilterMask pair_filter;
  const ObjectLayer fixed = ObjectLayerPairFilterMask::sGetObjectLayer(kFixed, kMoves);
  const ObjectLayer moving = ObjectLayerPairFilterMask::sGetObjectLayer(kMoves, kFixed | kMoves);
  PhysicsSystem system;
  system.Init(1024, 0, 1024, 1024, layers, broad_filter, pair_filter);
  system.SetGravity({0, 0, -9.81f});
  JoltRecorder recorder(system, demo.def);

  BodyInterface& bodies = system.GetBodyInterface();
  BodyCreationSettings floor(new BoxShape({50, 50, 1}), {0, 0, -1}, Quat::sIdentity(), EMotionType::Static, fixed);
  floor.mFriction = static_cast<float>(demo.friction);  // not in the log: what diff finds is its effect
  bodies.CreateAndAddBody(floor, EActivation::DontActivate);
  const RefConst<Shape> cube = new BoxShape({0.5f, 0.5f, 0.5f});
  for (int k = 0; k < 10; ++k) {
    double at[3], tilt = 0;
    demo_cube(k, at, &tilt);
    BodyCreationSettings settings(cube, {Real(at[0]), Real(at[1]), Real(at[2])},
                                  Quat::sRotation(Vec3::sAxisX(), static_cast<float>(tilt)), EMotionType::Dynamic,
                                  moving);
    settings.mFriction = 0.5f;
    char name[16];
    std::snprintf(name, sizeof name, "cube %d", k);
    recorder.add(bodies.CreateAndAddBody(settings, EActivation::Activate), name);
  }
  for (int k = 0; k < demo.steps; ++k) recorder.step(1.0f / 60, 1, &memory, &jobs);
  return Demo::end(recorder.rec);
}
