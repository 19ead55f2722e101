"""Worlds of Tumble's own engine, stepped from Python."""

import os

from . import _tumble
from ._columns import step_number
from ._errors import BadInput
from ._log import Log
from ._program import scene_file
from ._values import Contact, Scene, path_bytes, setting_text, setting_texts, utf8, whole


class World:
    """A running session of Tumble's own engine. ``World.from_scene("brick_wall")`` begins one.

    Arrays are read-only and show the world as it was when they were taken. Row i belongs to body ``ids[i]``. Axes are
    the world's: right-handed, z up, SI units. Any thread may call; one steps at a time.
    """

    def __init__(self, live, log):
        self._live = live
        self._log = log
        self._began = live.now()["step"]

    @classmethod
    def from_scene(cls, scene, *, set=None, seconds=None, steps=None, threads=1, record=None, states="all",
                   hashes="all"):
        """Begins a session of a scene: a path, the name of a golden case, or a `Scene`.

        set: values of the scene by key, as in ``{"grid.rows": 7, "world.dt": 0.01}``. seconds or steps: its planned
        length. threads: they change no bit. record: the path of a log to write. states: "all", "every:N" or "hashes",
        the states that the log holds; hashes: "all", "every:N" or "states".
        """
        log = _recording(record, states, hashes)
        if isinstance(scene, Scene):
            text, name = scene.text, scene.name
        else:
            name = scene_file(scene)
            text = Scene.read(name).text
        utf8(text, "scene")
        utf8(name, "name of the scene")
        settings = setting_texts(set)
        if seconds is not None and steps is not None:
            raise BadInput("found both seconds and steps, wanted one of them")
        if steps is not None:
            settings.append(setting_text("world.steps", steps))
        if seconds is not None:
            settings.append(setting_text("world.seconds", seconds))
        threads = whole(threads, "threads", 1, 1024)
        live = _tumble.LiveWorld(text, name, settings, log, states, hashes, threads)
        return cls(live, os.fsdecode(log) if log else None)

    @classmethod
    def from_log(cls, log, step=-1, *, inputs=True, steps=None, threads=1, record=None, states="all", hashes="all"):
        """Goes on from a state of a log of Tumble's own engine, to the bit as if that session had not stopped.

        log: a `Log` or a path. step: the number of the state. inputs: whether to apply those that the log has after it;
        without them another future can be tried. steps: planned after that state. The rest is as in `from_scene()`.
        """
        log = log if isinstance(log, Log) else Log(log)
        number = step_number(log, step)
        out = _recording(record, states, hashes)
        if steps is not None:
            steps = whole(steps, "steps", 1, 100_000_000)
        threads = whole(threads, "threads", 1, 1024)
        live = _tumble.LiveWorld.go_on(log._file, number, bool(inputs), steps, out, states, hashes, threads)
        return cls(live, os.fsdecode(out) if out else None)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.close()

    def __repr__(self):
        return f"<tumble.World {self.scene!r}, step {self.step_count}>"

    def __reduce__(self):
        raise TypeError("a world cannot be pickled; record it and open the log in the other process")

    def close(self):
        """Completes the log, if the session has one. The world takes no more steps. Returns the log's path."""
        self._live.finish()
        return self._log

    def step(self, count=1):
        """Takes ``count`` steps, applying before each the scene's inputs and then those added by `push()` and so on.

        Ctrl-C ends it between two steps. Raises CannotFinish where a step fails; the session is then over.
        """
        self._live.step(whole(count, "step", 0, 2**63 - 1))

    def run(self):
        """Takes the planned steps that are left."""
        self._live.step(max(0, self.planned_steps - self.step_count))

    @property
    def scene(self):
        """The name of the scene."""
        return self._live.scene

    @property
    def planned_steps(self):
        """The number of steps that the scene plans."""
        return self._live.planned_steps

    def _now(self, name):
        return self._live.now()[name]

    @property
    def step_count(self):
        """The number of steps taken."""
        return self._now("step")

    @property
    def dt(self):
        """The length of the coming step, s."""
        return self._now("dt")

    @property
    def gravity(self):
        """(x, y, z), m/s^2."""
        return self._now("gravity")

    @property
    def hash(self):
        """XXH3-128 of the visible state, as a log has it."""
        return self._now("hash")

    @property
    def kinetic_energy(self):
        """Of all moving bodies, J."""
        return self._now("kinetic")

    @property
    def potential_energy(self):
        """Of all bodies that are not static, J."""
        return self._now("potential")

    @property
    def state(self):
        """All columns at once, of one moment: has ids, position, orientation, velocity, spin and frozen."""
        return self._live.states()

    @property
    def ids(self):
        """Ids of the bodies, (n,) uint64, ascending."""
        return self.state.ids

    @property
    def position(self):
        """Centres of mass, (n, 3), m."""
        return self.state.position

    @property
    def orientation(self):
        """Unit quaternions (w, x, y, z), (n, 4)."""
        return self.state.orientation

    @property
    def velocity(self):
        """Velocities of the centres of mass, (n, 3), m/s."""
        return self.state.velocity

    @property
    def spin(self):
        """Angular velocities about the world's axes, (n, 3), rad/s."""
        return self.state.spin

    @property
    def frozen(self):
        """Whether each body is asleep, (n,) bool."""
        return self.state.frozen

    @property
    def size(self):
        """Edge lengths, (n, 3), m."""
        return self._live.constants()["size"]

    @property
    def mass(self):
        """Masses, (n,), kg."""
        return self._live.constants()["mass"]

    @property
    def static(self):
        """Whether each body is immovable, (n,) bool."""
        return self._live.constants()["is_static"]

    @property
    def contacts(self):
        """The contact points of the last step that this world took; none before its first."""
        if self.step_count == self._began:
            return ()
        return tuple(Contact(*row) for row in self._live.contacts())

    def _add(self, kind, **fields):
        self._live.add_input({"kind": kind, **{key: value for key, value in fields.items() if value is not None}})

    def throw(self, *, size=(1, 1, 1), mass=1.0, position=(0, 0, 0), velocity=(0, 0, 0), spin=(0, 0, 0),
              orientation=(1, 0, 0, 0), friction=None, friction_dynamic=None, restitution=None, texture=None,
              static=False, frozen=False, id=None):
        """Adds a box before the coming step and returns its id: by default one more than the highest so far."""
        if id is None:
            id = self._live.next_id()
        self._add("throw", id=id, size=size, mass=mass, position=position, velocity=velocity, spin=spin,
                  orientation=orientation, friction=friction, friction_dynamic=friction_dynamic,
                  restitution=restitution, texture=texture, static=static, frozen=frozen)
        return id

    def push(self, id, impulse, at=None):
        """Gives a body an impulse, N s, at a point of the world, m, or through its centre of mass."""
        self._add("push", id=id, impulse=impulse, at=at, at_centre=at is None)

    def remove(self, id):
        """Removes a body and wakes those that rested on it."""
        self._add("remove", id=id)

    def wake(self, id):
        """Wakes a frozen body."""
        self._add("wake", id=id)

    def set_velocity(self, id, velocity, spin=(0, 0, 0)):
        """Replaces velocity, m/s, and spin, rad/s, and wakes the body."""
        self._add("set_velocity", id=id, velocity=velocity, spin=spin)

    def set_gravity(self, gravity):
        """Replaces gravity, (x, y, z) in m/s^2, and wakes every body."""
        self._add("set_gravity", gravity=gravity)

    def set_dt(self, dt):
        """Replaces the length of a step, s, from the coming step on."""
        self._add("set_dt", dt=dt)

    def apply(self, input):
        """Applies an `Input`, such as one of another session, before the coming step."""
        self._live.add_input({"kind": input.kind, **input.fields})


def _recording(record, states, hashes):
    """The path of a log, b"" for none."""
    for name, words in (("states", states), ("hashes", hashes)):
        if not isinstance(words, str):
            raise BadInput(f'{name}: found {words!r}, wanted text such as "all" or "every:10"')
    return b"" if record is None else path_bytes(record, "record")
