@0xd1a4f6b2c8e07395;
# schema/log.capnp as a version to come might have it, for tests: more fields, another input. Kept as it is.
#
# Rules of evolution: fields are added with the next ordinal and never change their type, ordinal or default; a default
# means the behaviour of the versions that did not have the field. Units are SI; angles in degrees only in Camera.
# Columns are Data: little-endian elements, one a row, because lists of structs compress badly. "Planes" means that the
# bytes of a column are regrouped: byte 0 of all elements, then byte 1, and so on.

struct Vec3 {
  x @0 :Float64;
  y @1 :Float64;
  z @2 :Float64;
}

struct Material {
  friction @0 :Float64;         # >= 0, static coefficient
  frictionDynamic @1 :Float64;  # >= 0
  restitution @2 :Float64;      # 0 .. 1
  texture @3 :UInt8;            # 0 crate, 1 brick, 2 wood, 3 concrete, 4 white; look only
}

struct WorldDef {
  method @0 :UInt8;             # 0 thesis, 1 layered
  dt @1 :Float64;               # s, > 0; the step's length when the message was written
  substeps @2 :UInt32;          # 1 .. 1024
  splitCollisions @3 :UInt32;   # thesis: a sub-step that meets more collisions is halved
  gravity @4 :Vec3;             # m/s^2
  ground @5 :Bool;              # the half-space z <= 0
  freezing @6 :Bool;
  freezeEnergy @7 :Float64;     # J/kg
  freezeTime @8 :Float64;       # s
  slipSpeed @9 :Float64;        # m/s
  airDrag @10 :Float64;         # 1/s
  groundMaterial @11 :Material;
}

struct Box {
  id @0 :UInt64;                # 1 .. 2^53 - 1, unique in a session
  size @1 :Vec3;                # m, edge lengths, > 0
  mass @2 :Float64;             # kg, > 0
  isStatic @3 :Bool;
  position @4 :Vec3;            # m, centre of mass
  orientationW @5 :Float64;     # unit quaternion, scalar first
  orientationX @6 :Float64;
  orientationY @7 :Float64;
  orientationZ @8 :Float64;
  velocity @9 :Vec3;            # m/s
  spin @10 :Vec3;               # rad/s, world axes
  material @11 :Material;
  frozen @12 :Bool;             # starts at rest and frozen
  origin @13 :Origin;
}

# Which table of the scene made a body. Columns of a generator's bodies share row and column numbers.
struct Origin {
  kind @0 :UInt8;               # 0 box, 1 grid, 2 tower, 3 pyramid, 4 wall, 5 pile, 6 input
  table @1 :UInt32;             # 0-based: the first, second, ... table of that kind
  row @2 :UInt32;
  column @3 :UInt32;
}

# One input, applied before a step. `kind` repeats the union's word, so that a reader that does not know a newer kind
# can name it in its error.
struct Input {
  step @0 :UInt64;              # 1 .. number of steps: the step before which it is applied
  kind @1 :Text;                # "throw", "push", ...
  union {
    throw @2 :Box;
    push @3 :Push;
    remove @4 :UInt64;          # the body's id
    wake @5 :UInt64;            # the body's id
    setVelocity @6 :SetVelocity;
    setGravity @7 :Vec3;        # m/s^2
    setDt @8 :Float64;          # s, > 0
    explode @9 :Float64;        # J, of the future
  }
}

struct Push {
  id @0 :UInt64;
  impulse @1 :Vec3;             # N s
  atCentre @2 :Bool;            # true: at the centre of mass, `at` means nothing
  at @3 :Vec3;                  # m, world point
}

struct SetVelocity {
  id @0 :UInt64;
  velocity @1 :Vec3;            # m/s
  spin @2 :Vec3;                # rad/s
}

struct Camera {
  position @0 :Vec3;            # m
  target @1 :Vec3;              # m
  fov @2 :Float64;              # degrees, vertical
  focus @3 :Float64;            # m
  blur @4 :Float64;             # 0 = no depth of field
}

struct Light {
  position @0 :Vec3;            # m
  target @1 :Vec3;              # m
}

# The scene with all values resolved: what a session starts from, without the text it was written as.
struct Scene {
  name @0 :Text;
  title @1 :Text;
  category @2 :Text;
  world @3 :WorldDef;
  steps @4 :UInt64;             # the steps that were planned; the log may hold fewer
  boxes @5 :List(Box);          # ascending id
  inputs @6 :List(Input);       # ascending step; the scripted ones
  camera @7 :Camera;
  light @8 :Light;
  seasons @9 :UInt32;           # of the future
}

# The first record.
struct Header {
  toolVersion @0 :Text;         # of the program that wrote the log, "0.1.0"
  toolBuild @1 :Text;           # compiler and its version; for people
  method @2 :Text;              # "thesis" or "layered"
  methodVersion @3 :UInt32;     # a build with another version may give other bits
  floatFormat @4 :Text;         # "binary64, little-endian"
  phases @5 :List(Text);        # names, in the order of the words of Chunk.phaseWords
  phaseRowsMax @6 :UInt32;      # sub-steps that have a row of words of their own; later ones share the last
  scene @7 :Scene;
  sceneText @8 :Text;           # the TOML file, byte for byte; empty if there was none
  overrides @9 :List(Text);     # "world.dt=0.01", in the order given
  statesEvery @10 :UInt32;      # 1: every step has states; n: every n-th and those alone; 0: none
  chunkStepsMax @11 :UInt32;    # what the writer closes a chunk at, for people
  chunkBytesMax @12 :UInt64;    # likewise
  transform @13 :Transform;     # what was made of the scene file before the session began
  goesOn @14 :GoesOn;           # null: the session begins with step 1 of its scene
  union {                       # no field: Tumble computed the steps
    engine @15 :Engine;
    imported @18 :Engine;
  }
  recovered @16 :Recovered;     # null: the log is as it was recorded
  phaseHashVersion @17 :UInt32 = 1;
  phaseHashesEvery @19 :UInt32 = 1;
  declared @20 :AnyPointer;
  wind @21 :Float64;            # m/s, of the future
  weather @22 :Text;            # of the future
}

struct Engine {
  name @0 :Text;
  version @1 :Text;
  precisionBits @2 :UInt8 = 53;
}

# What is missing since the log was recovered from a damaged one.
struct Recovered {
  log @0 :Text;                 # the damaged log's file, as it was given; for people
  headerLost @1 :Bool;          # this header was made from a keyframe: no names, looks, camera, scene text
  gaps @2 :List(Gap);           # ascending, none touches the next; chunks stand before and after each

  struct Gap {
    firstStep @0 :UInt64;       # 1 ..
    stepCount @1 :UInt64;       # 1 ..
  }
}

# Where a session that goes on from another one's state began.
struct GoesOn {
  step @0 :UInt64;              # steps of the other session before; this log's first step is the next
  log @1 :Text;                 # the other log's file, as it was given; for people
  continuationLow @2 :UInt64;   # the continuation hash of the state between them
  continuationHigh @3 :UInt64;
}

# A symmetry of the simulation, done to the scene in this order. `scene` has it done already.
struct Transform {
  mirrorX @0 :Bool;
  mirrorY @1 :Bool;
  swapXy @2 :Bool;              # a mirror in the plane x = y
  shift @3 :Vec3;               # m
  permuted @4 :Bool;            # the bodies have new names
  permuteSeed @5 :UInt64;       # which; means nothing unless permuted
}
