@0xc4d1d5b0a9e3f217;
# The messages of a .tumble log. docs/log_format.md explains how messages are framed, hashed and found.
#
# Rules of evolution: new fields get the next ordinal. Type, ordinal and default of a field never change. A default means
# the behaviour of versions without the field. Units are SI; only Camera has angles in degrees. Columns are Data:
# little-endian elements, one per row, because lists of structs compress badly. "Planes": the bytes of a column are
# regrouped, byte 0 of all elements, then byte 1, and so on.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("tumble::replay::schema");

using Extras = import "extras.capnp";

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
  splitCollisions @3 :UInt32;   # thesis: a substep with more collisions is halved
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
  id @0 :UInt64;                # 1 .. 2^53 - 1; another box never has it
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

# The table of the scene that made a body, and the place of the body in that table.
struct Origin {
  kind @0 :UInt8;               # 0 box, 1 grid, 2 tower, 3 pyramid, 4 wall, 5 pile, 6 input
  table @1 :UInt32;             # 0-based: the first, second, ... table of that kind
  row @2 :UInt32;
  column @3 :UInt32;
}

# One input, applied before a step. `kind` repeats the word of the union, so that an older reader can name a newer kind
# in its error.
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
  }
}

struct Push {
  id @0 :UInt64;
  impulse @1 :Vec3;             # N s
  atCentre @2 :Bool;            # true: at the centre of mass, `at` is ignored
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

# The scene with all values resolved: the start of a session, without the TOML text.
struct Scene {
  name @0 :Text;
  title @1 :Text;
  category @2 :Text;
  world @3 :WorldDef;
  steps @4 :UInt64;             # planned steps; the log may hold fewer
  boxes @5 :List(Box);          # ascending id
  inputs @6 :List(Input);       # ascending step; scripted inputs
  camera @7 :Camera;
  light @8 :Light;
}

# The first record.
struct Header {
  toolVersion @0 :Text;         # of the program that wrote the log, "0.1.0"
  toolBuild @1 :Text;           # compiler and its version; for people
  method @2 :Text;              # "thesis" or "layered"
  methodVersion @3 :UInt32;     # a build with another version may give other bits
  floatFormat @4 :Text;         # "binary64, little-endian"
  phases @5 :List(Text);        # names, in the order of the words of Chunk.phaseWords
  phaseRowsMax @6 :UInt32;      # rows of words of a step at most; later substeps share the last row
  scene @7 :Scene;
  sceneText @8 :Text;           # the TOML file, byte for byte; empty without one
  overrides @9 :List(Text);     # "world.dt=0.01", in the order given
  statesEvery @10 :UInt32;      # 1: all steps have states; n: multiples of n only; 0: none
  chunkStepsMax @11 :UInt32;    # steps at which the writer closes a chunk; for people
  chunkBytesMax @12 :UInt64;    # bytes of states at which the writer closes a chunk; for people
  transform @13 :Transform;     # applied to the scene of the file before the session began
  goesOn @14 :GoesOn;           # null: the session begins with step 1 of its scene
  union {                       # no field: Tumble computed the steps; else methodVersion is 0 and replay is refused
    engine @15 :Engine;
    imported @18 :Imported;     # begins like Engine, so that a reader without this member reads the engine
  }
  recovered @16 :Recovered;     # null: the log was not recovered
  phaseHashVersion @17 :UInt32 = 1;  # version of phase words and of `contacts`; 1 for another engine
  phaseHashesEvery @19 :UInt32 = 1;  # 1: all steps have phase words; n: multiples of n only; 0: none
  declared @20 :Extras.Declared;     # null: the engine declares nothing beyond states
}

# The physics engine that computed the steps. Such steps can be compared, measured and drawn, but not computed again.
struct Engine {
  name @0 :Text;                # not empty
  version @1 :Text;             # empty if unknown
  precisionBits @2 :UInt8 = 53; # of the engine's numbers: 24 (binary32) or 53 (binary64)
}

# The engine of an imported table, and the facts about the table that the states do not show.
struct Imported {
  name @0 :Text;                # as in Engine
  version @1 :Text;
  precisionBits @2 :UInt8 = 53;
  up @3 :UInt8 = 2;             # the table's axis that points up: 0 x, 1 y, 2 z; states are stored with z up
  leftHanded @4 :Bool;
  metres @5 :Float64 = 1;       # per unit of length of the table; states are stored in m
  passedOver @6 :List(Text);    # names of the columns that the import did not read
}

# The losses of a log that was recovered from a damaged one.
struct Recovered {
  log @0 :Text;                 # path of the damaged log, as the user gave it; for people
  headerLost @1 :Bool;          # the header was rebuilt from a keyframe: no names, looks, camera, scene text
  gaps @2 :List(Gap);           # missing steps; ascending, apart; chunks stand before and after each

  struct Gap {
    firstStep @0 :UInt64;       # 1 ..
    stepCount @1 :UInt64;       # 1 ..
  }
}

# The origin of a continued session: a state of another session.
struct GoesOn {
  step @0 :UInt64;              # number of that state; the log begins with the step after
  log @1 :Text;                 # path of the other log, as the user gave it; for people
  continuationLow @2 :UInt64;   # the continuation hash of that state
  continuationHigh @3 :UInt64;
}

# A symmetry of the simulation, applied to the scene in this order. Header.scene is the result.
struct Transform {
  mirrorX @0 :Bool;
  mirrorY @1 :Bool;
  swapXy @2 :Bool;              # a mirror in the plane x = y
  shift @3 :Vec3;               # m
  permuted @4 :Bool;            # the bodies have new names
  permuteSeed @5 :UInt64;       # seed of the new names; ignored unless permuted
}

# Steps firstStep .. firstStep + stepCount - 1 and the state before the first of them.
struct Chunk {
  firstStep @0 :UInt64;         # 1 ..
  stepCount @1 :UInt32;         # 0 only in a log without steps, whose one chunk holds state 0
  keyframe @2 :Keyframe;
  inputs @3 :List(Input);       # of these steps, in the order applied
  dt @4 :Data;                  # stepCount x Float64, s
  stateHash @5 :Data;           # stepCount x 16 bytes: low, high
  phaseWordCount @6 :Data;      # stepCount x UInt32: substep rows x phases
  phaseWords @7 :Data;          # UInt64: word 0 of all steps that have one, then word 1, ...
  pairs @8 :Data;               # stepCount x UInt32
  contacts @9 :Data;            # stepCount x UInt32
  substeps @10 :Data;           # stepCount x UInt32
  kinetic @11 :Data;            # stepCount x Float64, J, after the step
  potential @12 :Data;          # stepCount x Float64, J, after the step
  inputEnergy @13 :Data;        # stepCount x Float64, J, put in by the inputs before the step
  removedEnergy @14 :Data;      # stepCount x Float64, J, dissipated in the step
  hasStates @15 :Data;          # stepCount x UInt8, 0 or 1
  states @16 :States;           # of the steps that have them
  extras @17 :Extras.Extras;         # null: none of the steps has any. A chunk with it has format version 2.0
}

# The visible states of the bodies of the keyframe, changed by throw and remove inputs.
struct States {
  codec @0 :UInt16;             # 1: docs/log_format.md, "Codec 1"
  flags @1 :Data;               # one byte per body and step: bit 0 frozen; bits 1-2: 0 unchanged, 1 flew freely, 2 stored
  columns @2 :List(Column);     # velocity x y z, spin x y z, position x y z, orientation: three components, the largest
}

struct Column {
  onGrid @0 :Bool;              # true: integers of grid steps; false: ordered bit patterns
  residuals @1 :Data;           # planes of UInt64, zigzag; one per body and step with flag stored
}

# A complete sim::WorldState. Columns have one row per body, in ascending id.
struct Keyframe {
  step @0 :UInt64;              # steps taken
  world @1 :WorldDef;           # with the current dt and gravity
  continuationLow @2 :UInt64;   # the continuation hash of this state
  continuationHigh @3 :UInt64;
  id @4 :Data;                  # UInt64, differences to the row before, planes
  doubles @5 :List(Data);       # planes of Float64; the order is in docs/log_format.md, "Keyframe"
  frozen @6 :Data;              # UInt8, 0 or 1
  isStatic @7 :Data;            # UInt8, 0 or 1
  pairA @8 :Data;               # UInt32 row, differences, planes
  pairB @9 :Data;               # UInt32 row, differences, planes
  pairPlanes @10 :Data;         # UInt16, planes
  contactBody @11 :Data;        # UInt32 row, differences, planes
  contactObject @12 :Data;      # UInt32 row or 0xffffffff for the ground, differences, planes
  # Method layered: the contacts that warm start the next step.
  memoryA @13 :Data;            # UInt32 row or 0xffffffff for the ground, differences, planes; reference body
  memoryB @14 :Data;            # UInt32 row, differences, planes; incident body
  memoryCount @15 :Data;        # UInt32, planes; points of the contact
  memoryDoubles @16 :List(Data);  # planes of Float64: friction x y z (N s), twist (N m s); one per contact
  memoryFeature @17 :Data;      # UInt32, planes; one per point
  memoryImpulse @18 :Data;      # planes of Float64, N s; one per point
}

# The record before the footer: the places of the chunks.
struct Index {
  chunks @0 :List(Entry);

  struct Entry {
    offset @0 :UInt64;          # of the record's first byte in the file
    length @1 :UInt64;          # of the record, prelude included
    firstStep @2 :UInt64;
    stepCount @3 :UInt32;
    chainAfterLow @4 :UInt64;   # the chain after the chunk's last step
    chainAfterHigh @5 :UInt64;
    hashLow @6 :UInt64;         # XXH3-128 of the record's stored bytes
    hashHigh @7 :UInt64;
  }
}
