"""The recorder from Python, through ctypes: all of the glue. Make the library once, beside this file:

    cc -std=c99 -O2 -shared -fPIC replay/recorder/tumble_recorder.c -o libtumble_recorder.so
"""

import ctypes as c
import pathlib

Vec3, Quat = c.c_double * 3, c.c_double * 4
FLOAT64, INT64, TEXT = 1, 3, 7
WORLD, BODY, PAIR = 0, 1, 2


class State(c.Structure):
    _fields_ = [("position", Vec3), ("orientation", Quat), ("velocity", Vec3), ("spin", Vec3), ("asleep", c.c_int)]


class Body(c.Structure):
    _fields_ = [("id", c.c_uint64), ("name", c.c_char_p), ("shape", c.c_int), ("size", Vec3), ("mesh_hash", c.c_uint64),
                ("mass", c.c_double), ("is_static", c.c_int), ("friction", c.c_double), ("restitution", c.c_double),
                ("state", State)]


class Def(c.Structure):
    _fields_ = [("engine", c.c_char_p), ("version", c.c_char_p), ("scene", c.c_char_p), ("precision_bits", c.c_int),
                ("up", c.c_char), ("left_handed", c.c_int), ("metres", c.c_double), ("gravity", Vec3),
                ("ground", c.c_int), ("phases", c.c_char_p), ("path", c.c_char_p), ("write", c.c_void_p),
                ("write_user", c.c_void_p), ("ring_s", c.c_double), ("hashes_only", c.c_int),
                ("rollback_steps", c.c_uint32), ("verify", c.c_char_p), ("on_difference", c.c_void_p),
                ("difference_user", c.c_void_p), ("steps_a_write", c.c_uint32)]


class Recorder:
    def __init__(self, path=None, engine="Python", gravity=(0, 0, -9.81), verify=None, library=None):
        folder = pathlib.Path(__file__).parent
        self._lib = c.CDLL(str(library or folder / "libtumble_recorder.so"))
        self._lib.tumble_rec_create.restype = c.c_void_p
        self._lib.tumble_rec_message.restype = c.c_char_p
        definition = Def(engine=engine.encode(), precision_bits=53, gravity=Vec3(*gravity), ground=1,
                         path=path and path.encode(), verify=verify and verify.encode())
        self._rec = c.c_void_p(self._lib.tumble_rec_create(c.byref(definition)))

    def _call(self, name, *arguments):
        if getattr(self._lib, "tumble_rec_" + name)(self._rec, *arguments) > 1:  # 1: verify found a difference
            raise RuntimeError(self._lib.tumble_rec_message(self._rec).decode())

    def body(self, id, state, size=(1, 1, 1), mass=1, name=None, friction=0.5):
        self._call("body", c.byref(Body(id=id, name=name and name.encode(), size=Vec3(*size), mass=mass,
                                        friction=friction, state=state)))

    def channel(self, name, scope=WORLD, type=FLOAT64):
        number = c.c_uint32()
        self._call("channel", name.encode(), scope, type, c.byref(number))
        return number

    def step_begin(self, dt):
        self._call("step_begin", c.c_double(dt))

    def state(self, id, state):
        self._call("state", c.c_uint64(id), c.byref(state))

    def value(self, channel, value, body=0):
        self._call("f64", channel, c.c_uint64(body), c.c_double(value))

    def step_end(self):
        self._call("step_end")

    def close(self):
        """1: verify found a difference."""
        return self._lib.tumble_rec_close(self._rec)
