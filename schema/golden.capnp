@0xa3c8e55d0b7f4e29;
# What a golden case expects, the message inside expected.tumble. docs/goldens.md says how it is framed and used.
#
# Rules of evolution and columns as in log.capnp: fields are only added, "planes" means bytes regrouped by significance.

using Cxx = import "/capnp/c++.capnp";
using Extras = import "extras.capnp";
$Cxx.namespace("tumble::golden::schema");

struct Expected {
  toolVersion @0 :Text;         # of the program that blessed it; for people
  method @1 :Text;              # "thesis" or "layered"
  methodVersion @2 :UInt32;
  sceneLow @3 :UInt64;          # hash of the resolved scene: another scene.toml makes the golden stale
  sceneHigh @4 :UInt64;
  stepCount @5 :UInt64;         # N, at least 1
  stateHash @6 :Data;           # (N + 1) x 16 bytes: low, high; states 0 .. N
  stepWord @7 :Data;            # N x UInt32, planes: of dt, inputs, phase words and counters of steps 1 .. N
  phases @8 :List(Text);        # names, in the order of the words
  phaseDetail @9 :UInt8;        # 0 no words; 1 a row of words a step; 2 a row of words a sub-step
  phaseWordCount @10 :Data;     # N x UInt32, planes
  phaseWords @11 :Data;         # UInt16, planes: the low bits of each phase's hash, step by step
  continuationLow @12 :UInt64;  # everything the future depends on after step N; 0 and 0 where it was not known
  continuationHigh @13 :UInt64;
  bodyHashes @14 :List(BodyHashes);
  states @15 :List(State);
  track @16 :List(TrackPoint);
  phaseHashVersion @17 :UInt32 = 1;  # as in the header of a log
  sceneText @18 :Text;          # scene.toml when it was blessed, for people: names the lines that change
  provenance @19 :Provenance;   # null: blessed before goldens had one
  keepsExtras @20 :Bool;        # channels and contactHash are those of the session, and stepWord leaves them out
  channels @21 :List(Channel);  # ascending names
  contactHash @22 :Data;        # (N + 1) x UInt32, planes: of the engine's contacts in states 0 .. N; empty: none
  keepsShapes @23 :Bool;        # shapes are those of the session
  shapes @24 :List(BodyShape);  # ascending ids: of another engine's bodies that are no boxes
  setup @25 :Data;              # of another engine's session: the header of a log (log.capnp, Header) without motions;
                                # scene.inputs: before each step with another dt or an input, a set_dt, then the inputs;
                                # scene.steps: up to this step they are kept. Empty: not kept
}

struct BodyShape {
  id @0 :UInt64;
  low @1 :UInt64;               # hash of the shape, as in a log
  high @2 :UInt64;
  text @3 :Text;                # for people
}

# A channel of another engine's session.
struct Channel {
  name @0 :Text;
  kind @1 :UInt8;               # as in extras.capnp
  scope @2 :UInt8;
  unit @3 :Text;
  hash @4 :Data;                # (N + 1) x UInt32, planes: of the values in states 0 .. N; 0: no value
  valueSteps @5 :Data;          # UInt64, differences, planes: ascending states whose values are kept
  values @6 :Extras.ChannelValues;  # of these, one after the other
}

# Where a golden comes from: for people, decides nothing. Empty texts are not known.
struct Provenance {
  commit @0 :Text;
  tree @1 :Text;                # "clean" or "changed"
  compiler @2 :Text;
  flags @3 :Text;
  machine @4 :Text;
  date @5 :Text;                # UTC, ISO 8601
  seconds @6 :Float64;          # that the session took
}

# Which bodies differ at a step: a hash of the visible state of each.
struct BodyHashes {
  step @0 :UInt64;
  id @1 :Data;                  # UInt64, differences to the row before, planes
  hash @2 :Data;                # UInt32, planes
}

# All that is visible of all bodies at a step, to the bit.
struct State {
  step @0 :UInt64;
  id @1 :Data;                  # UInt64, differences to the row before, planes
  columns @2 :List(Data);       # planes of Float64: velocity x y z, spin x y z, position x y z, orientation w x y z
  frozen @3 :Data;              # UInt8
}

# Where the bodies were, to the millimetre: for reports, decides nothing.
struct TrackPoint {
  step @0 :UInt64;
  id @1 :Data;                  # UInt64, differences to the row before, planes
  x @2 :Data;                   # Int32 as UInt32, mm, planes
  y @3 :Data;
  z @4 :Data;
}
