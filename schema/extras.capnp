@0xb7e29c41d05f8a36;
# What a .tumble log holds beyond states: channels, names and shapes of bodies, contacts of other engines, notes,
# snapshots, views. Part of log.capnp, whose rules hold here too.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("tumble::replay::schema");

# What an engine declares beyond states, for the whole log. A header with it has format version 2.0.
struct Declared {
  channels @0 :List(Channel);   # ascending names
  shapes @1 :List(Shape);
  bodies @2 :List(BodyInfo);    # names and shapes of bodies that the log begins with; ascending id
  start @3 :Extras;             # of the state that the log begins with, as of one step
  velocityDerived @4 :Bool;     # computed from positions by the import, not by the engine
  spinDerived @5 :Bool;         # likewise from orientations
  cutShort @6 :Text;            # for people: why steps may be missing behind the last one; empty: the recorder was closed
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
  bodyB @3 :Data;               # likewise; 0 in contacts: the ground
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
  name @2 :Text;                # at most 200 bytes; empty: none
}

# What was shown at one moment of a live session.
struct View {
  step @0 :UInt64;              # the step that was shown last, or is shown in part
  part @1 :Float64;             # 0 .. 1: of the way from the state before that step to the state after it
  wallTime @2 :Float64;         # s since the session began, on the clock of the user
  camera @3 :List(Float64);     # position x y z, target x y z (m), fov (degrees), focus (m), blur
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
