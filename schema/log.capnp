@0xc4d1d5b0a9e3f217;
# The messages of a .tumble log. docs/log_format.md explains how messages are framed, hashed and found.
#
# Rules of evolution: new fields get the next ordinal. Type, ordinal and default of a field never change. A default means
# the behaviour of versions without the field. Units are SI; only Camera has angles in degrees. Columns are Data:
# little-endian elements, one per row, because lists of structs compress badly. "Planes": the bytes of a column are
# regrouped, byte 0 of all elements, then byte 1, and so on.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("tumble::replay::schema");

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
  declared @19 :Declared;       # null: the engine declares nothing beyond states
}

# What an engine declares beyond states, for the whole log. A header with it has format version 2.0.
struct Declared {
  channels @0 :List(Channel);   # ascending names
  shapes @1 :List(Shape);
  bodies @2 :List(BodyInfo);    # names and shapes of bodies that the log begins with; ascending id
  start @3 :Extras;             # of the state that the log begins with, as of one step
  velocityDerived @4 :Bool;     # computed from positions by the import, not by the engine
  spinDerived @5 :Bool;         # likewise from orientations
}

# A named value of an engine, of every step in which the engine gives it.
struct Channel {
  name @0 :Text;                # 1 .. 200 bytes of UTF-8, no '=', no control character
  kind @1 :UInt8;               # 0 float64, 1 float32, 2 int64, 3 uint64, 4 bytes, 5 text
  scope @2 :UInt8;              # 0 the step as a whole, 1 a body, 2 a pair of bodies
  unit @3 :Text;                # for people; empty without one
}

# A shape of a body, in the body's axes around its centre of mass. Each shape is stored once.
struct Shape {
  hashLow @0 :UInt64;           # XXH3-128 of the fields below (replay/format/shape.cc)
  hashHigh @1 :UInt64;
  kind @2 :UInt8;               # 1 sphere, 2 capsule, 3 cylinder, 4 convex hull of points, 5 mesh of triangles
  axis @3 :UInt8;               # of capsule and cylinder: 0 x, 1 y, 2 z
  radius @4 :Float64;           # m, of sphere, capsule, cylinder
  halfLength @5 :Float64;       # m, of capsule (without its caps) and cylinder
  points @6 :Data;              # planes of Float64, m: x y z of each point of hull and mesh
  triangles @7 :Data;           # planes of UInt32: three points of each triangle of a mesh
}

# The name and the shape of a body. A body without one has its id and a box.
struct BodyInfo {
  id @0 :UInt64;
  name @1 :Text;                # empty: none
  shapeLow @2 :UInt64;          # hash of its Shape; 0 and 0: a box
  shapeHigh @3 :UInt64;
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
  extras @17 :Extras;           # null: none of the steps has any. A chunk with it has format version 2.0
}

# What the steps of a chunk have beyond states. Values and contacts are in the chain; the rest is in no hash of a session.
struct Extras {
  channels @0 :List(ChannelValues);  # ascending channel; channels without a value in the chunk are left out
  contacts @1 :Contacts;
  notes @2 :List(Note);         # ascending step, like the lists below
  snapshots @3 :List(Snapshot);
  views @4 :List(View);
  superseded @5 :List(Superseded);
  bodies @6 :List(NewBody);
  shapes @7 :List(Shape);       # first used in this chunk
}

# Rows of steps, each with the bodies that it belongs to. Scope 1: bodyA. Scope 2: bodyA and bodyB.
struct Rows {
  counts @0 :Data;              # stepCount x UInt32: rows of each step
  sameBodies @1 :Data;          # stepCount x UInt8; 1: count and bodies are those of the step before
  bodyA @2 :Data;               # UInt64, differences, planes; of steps with sameBodies 0
  bodyB @3 :Data;               # likewise; 0 in contacts: the world
}

struct ChannelValues {
  channel @0 :UInt16;           # index in Declared.channels
  kind @1 :UInt8;               # repeats Channel.kind and Channel.scope, so that a chunk can be read alone
  scope @2 :UInt8;
  rows @3 :Rows;                # ascending bodies, each once
  numbers @4 :Data;             # planes of residuals: UInt32 of kind 1, else UInt64; kinds 4 and 5: planes of UInt32 lengths
  bytes @5 :Data;               # of kinds 4 and 5, one value after the other
}

# Contact points of an engine, in ascending pairs, as the engine orders the points of a pair.
struct Contacts {
  rows @0 :Rows;
  doubles @1 :List(Data);       # planes of residuals of UInt64: position x y z (m), normal x y z (from body A to body B),
                                # depth (m, above 0: overlapping), impulse (N s, along the normal)
}

struct Note {
  step @0 :UInt64;
  text @1 :Text;
}

# The engine's own state after a step, in its own bytes.
struct Snapshot {
  step @0 :UInt64;
  bytes @1 :Data;
}

# What was shown at one moment of a live session.
struct View {
  step @0 :UInt64;              # the step that was shown last, or is shown in part
  part @1 :Float64;             # 0 .. 1: of the way from the state before that step to the state after it
  wallTime @2 :Float64;         # s since the session began, on the clock of the user
  camera @3 :Camera;
  effects @4 :Text;             # a list as `render --effects` reads it; empty: the default
  follow @5 :UInt64;            # id of the body that the camera follows; 0: none
}

# A step that was recorded before, taken back by a rollback, and recorded again. The log holds the last record.
struct Superseded {
  step @0 :UInt64;
  sameInputs @1 :Bool;          # the records had equal inputs, and equal states before the step
  difference @2 :Text;          # the first difference between the two; empty: none
}

struct NewBody {
  step @0 :UInt64;              # in which the body appears
  body @1 :BodyInfo;
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
