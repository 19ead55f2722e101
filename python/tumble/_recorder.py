"""Logs of an engine that is written in Python."""

import collections.abc
import os
import warnings

from . import _tumble
from ._errors import BadInput, Error
from ._values import path_bytes, utf8

_PRECISIONS = {"float32": 24, "float64": 53}
_TEXT_MOST = 1000  # characters of an exception that a log keeps


class Recorder:
    """Writes the session of another engine as a log, which `diff`, `measure`, `render` and all other commands read::

        with tumble.Recorder("ball.tumble", engine="my engine", dt=0.01, bodies=[dict(id=1, mass=2.0)]) as log:
            for k in range(300):
                position, velocity = advance(position, velocity)
                log.step(position=position, velocity=velocity)

    SI units, z up, orientations (w, x, y, z), angular velocities about the world's axes.

    bodies: a dictionary each, with id (1, 2, ... in order where it is left out), size (m), mass (kg), position,
    orientation, velocity, spin, static, friction, friction_dynamic, restitution, frozen, texture, name, and shape, as
    `sphere()` makes one, which gives the size; all optional. channels: names of values that the engine logs beside the states, each with its
    unit, or with a dictionary of type ("float64", "float32", "int64", "uint64", "bytes", "text"), scope ("world",
    "body", "pair") and unit. phases: names of the phases that `step(phases=...)` gives a hash for, each once. precision:
    the engine's numbers. One thread at a time.
    """

    def __init__(self, path, *, engine, version="", bodies=(), dt=1 / 60, gravity=(0, 0, -9.81), ground=True,
                 channels=None, phases=(), precision="float64", scene="python", title="", planned_steps=0):
        if precision not in _PRECISIONS:
            raise BadInput(f"precision: found {precision!r}, wanted float64 or float32")
        if isinstance(phases, str):
            raise BadInput(f"phases: found {phases!r}, wanted a list of names")
        place = path_bytes(path, "path")
        self._path = os.fsdecode(place)
        self._dt = dt
        about = {
            "engine": engine, "version": version, "precision_bits": _PRECISIONS[precision], "phases": list(phases),
            "scene": scene, "title": title, "planned_steps": planned_steps, "dt": dt, "gravity": gravity,
            "ground": bool(ground), "bodies": _numbered(bodies), "channels": _declared(channels or {}),
        }
        self._log = _tumble.EngineRecorder(place, about)

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        try:
            self._close(_reason(kind, error))
        except Error as lost:
            if error is None:
                raise
            _add_to(error, str(lost))

    def __repr__(self):
        return f"<tumble.Recorder {self._path!r}>"

    def __reduce__(self):
        raise TypeError("a recorder cannot be pickled")

    @property
    def path(self):
        """Of the log."""
        return self._path

    @property
    def ids(self):
        """Ids of the bodies whose states a step tells, ascending: all that are not static."""
        return self._log.ids()

    @property
    def coming_step(self):
        """The number of the step that is recorded next, 1 at first."""
        return self._log.coming_step

    def step(self, *, position, velocity, orientation=None, spin=None, frozen=None, ids=None, dt=None, channels=None,
             contacts=None, notes=None, snapshot=None, phases=None):
        """Records a step: the state that each body has after it.

        position, velocity, spin: (n, 3); orientation: (n, 4); frozen: (n,). Rows as ``ids``, by default all bodies that
        are not static, ascending. Any array of numbers that float64 holds exactly will do. Without orientation or spin
        the bodies keep theirs. dt: s, by default the recorder's, until one is given.

        channels: values by name; a dictionary by id, or by pair of ids of two bodies, for a channel of bodies or pairs. contacts:
        rows of (a, b, position, normal, depth, impulse), b None for the world. notes: texts. snapshot: bytes of the
        engine's own state, or a dictionary of such bytes by name. phases: a hash, 0 to 2^64 - 1, for each phase.
        """
        length = self._dt if dt is None else dt
        self._log.step({
            "position": position, "velocity": velocity, "orientation": orientation, "spin": spin, "frozen": frozen,
            "ids": ids, "dt": length, "channels": channels, "contacts": contacts, "notes": notes,
            "snapshot": snapshot, "phases": phases,
        })
        self._dt = length

    def _input(self, kind, **fields):
        self._log.input({"kind": kind, **{key: value for key, value in fields.items() if value is not None}})

    def throw(self, *, id, **body):
        """A body that appears before the coming step, with the keys of `bodies`."""
        self._input("throw", id=id, **body)

    def push(self, id, impulse, at=None):
        """An impulse, N s, at a point of the world, m, or through the centre of mass, before the coming step."""
        self._input("push", id=id, impulse=impulse, at=at, at_centre=at is None)

    def remove(self, id):
        """A body that is gone before the coming step."""
        self._input("remove", id=id)

    def wake(self, id):
        """A body that is woken before the coming step."""
        self._input("wake", id=id)

    def set_velocity(self, id, velocity, spin=(0, 0, 0)):
        """A velocity, m/s, and a spin, rad/s, that a body gets before the coming step."""
        self._input("set_velocity", id=id, velocity=velocity, spin=spin)

    def set_gravity(self, gravity):
        """Gravity, m/s^2, from the coming step on."""
        self._input("set_gravity", gravity=gravity)

    def close(self):
        """Completes the log. A step that was refused ends it: the log then has the steps before, and why it ends."""
        self._close("")

    def _close(self, why):
        log, self._log = self._log, _Finished(self._path)  # which lets go of the file
        if not log.finished:
            log.finish(why)


def _reason(kind, error):
    """Why an exception ends a session; empty where none does."""
    if kind is None or not issubclass(kind, (Exception, KeyboardInterrupt)):
        return ""
    try:
        text = str(error)
    except Exception:  # the log is closed all the same
        text = ""
    if len(text) > _TEXT_MOST:
        text = text[:_TEXT_MOST] + "..."
    why = f"the program ended it with {kind.__name__}" + (f": {text}" if text else "")
    return why.encode(errors="backslashreplace").decode().replace("\0", "\\x00")


def _add_to(error, text):
    """Tells what went wrong while an exception ended a session: beside the exception, where that is shown."""
    if hasattr(error, "add_note") and isinstance(error, (Exception, KeyboardInterrupt)):
        error.add_note(text)
    else:
        warnings.warn(text, RuntimeWarning, stacklevel=4)


class _Finished:
    """Stands for the log of a closed recorder."""

    finished = True

    def __init__(self, path):
        self._path = path

    def __getattr__(self, name):
        raise BadInput(f"{self._path}: the log is finished and takes no more steps")


def _numbered(bodies):
    rows = []
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, dict):
            raise BadInput(f"bodies: found {body!r}, wanted a dictionary of its values")
        rows.append({"id": number, **{key: value for key, value in body.items() if value is not None}})
    return rows


def _declared(channels):
    rows = []
    if not isinstance(channels, collections.abc.Mapping):
        raise BadInput(f"channels: found {channels!r}, wanted a dictionary of units by name")
    for name, about in channels.items():
        if not isinstance(about, (str, collections.abc.Mapping, type(None))):
            raise BadInput(f"channel {name!r}: found {about!r}, wanted a unit, or a dictionary of type, scope and unit")
        fields = {"unit": about} if isinstance(about, str) or about is None else dict(about)
        unknown = set(fields) - {"type", "scope", "unit"}
        if unknown:
            raise BadInput(f"channel {name!r}: found {sorted(unknown)[0]!r}, wanted type, scope or unit")
        row = (name, fields.get("type", "float64"), fields.get("scope", "world"), fields.get("unit") or "")
        if not all(isinstance(text, str) for text in row):
            raise BadInput(f"channel {name!r}: name, type, scope and unit are text")
        utf8("".join(row), f"channel {name!r}")
        rows.append(row)
    return rows
