"""Logs, read."""

import os
from types import MappingProxyType

import numpy

from . import _tumble
from ._columns import Channel, Column, Steps, step_number
from ._errors import BadInput
from ._values import Body, Named, input_of, path_bytes


class _Counters(numpy.ndarray):
    """A structured array whose missing fields are told from those there are."""

    def __getitem__(self, index):
        names = self.dtype.names
        if not isinstance(index, str) or names is None:
            return super().__getitem__(index)
        if index not in names:
            raise KeyError(f"no counter: found {index!r}, wanted {', '.join(map(repr, names))}")
        return super().__getitem__(index).view(numpy.ndarray)


class Log:
    """A recorded session. ``Log(path)`` opens it; damage behind the header shows only where it is read.

    ``log.steps[120]`` is step 120; ``log.position[100:200]`` is an array over steps 100 to 199. Indices are the numbers
    of steps, from ``first_step`` to ``last_step``; negative ones count from the end, so -1 is the last step. Steps are
    read when asked for, one chunk of the file at a time. Any number of threads may read one Log.
    """

    def __init__(self, path):
        self._file = _tumble.LogFile(path_bytes(path, "path"))
        self._header = MappingProxyType(self._file.header())
        self._scan = None
        self._bodies = None
        self._inputs = None

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.close()

    def close(self):
        """Closes the file. Steps and arrays that were read stay valid."""
        self._file.close()

    def __repr__(self):
        state = "closed" if self.closed else f"steps {self.first_step} to {self.last_step}"
        return f"<tumble.Log {self.path!r}, {state}>"

    def __reduce__(self):
        if self.closed:
            raise BadInput(f"{self.path}: a closed log cannot be pickled")
        return (Log, (os.path.abspath(self.path),))

    def __len__(self):
        """The number of states: one more than the number of steps."""
        return self.last_step - self.first_step + 1

    def __iter__(self):
        return iter(self.steps)

    @property
    def path(self):
        return os.fsdecode(self._file.path)

    @property
    def closed(self):
        return self._file.closed

    @property
    def first_step(self):
        """The number of the state that the log begins with: 0, or that of the state from which it continues another
        session."""
        return self._file.first

    @property
    def last_step(self):
        """The number of the last step."""
        return self._file.last

    @property
    def header(self):
        """What holds for the whole log: versions, scene, world, engine, and where the session came from."""
        return self._header

    @property
    def scene(self):
        """The name of the scene."""
        return self._header["scene"]

    @property
    def scene_text(self):
        """The scene's TOML as it was recorded; empty without one."""
        return self._header["scene_text"]

    @property
    def world(self):
        """The parameters of the world at the start: dt (s), gravity (m/s^2), method, and the rest."""
        return MappingProxyType(self._header["world"])

    @property
    def engine(self):
        """Name, version and precision of the engine that computed the steps; None for Tumble's own."""
        return self._header["engine"]

    @property
    def phases(self):
        """Names of the phases of a step."""
        return tuple(self._header["phases"])

    @property
    def whole(self):
        """Whether opening found the log complete, without damage, and of a session that came to its end; `tumble info`
        checks every byte."""
        return self._file.condition()[0]

    @property
    def condition(self):
        """The same in words: "whole", "torn: complete up to byte 8123 ...", "its session may have gone on: ..." (why:
        ``log.header["cut_short"]``)."""
        return self._file.condition()[1]

    @property
    def bodies(self):
        """All bodies by id, those thrown in later among them."""
        if self._bodies is None:
            bodies = ((number, Body(**fields)) for number, fields in self._file.bodies().items())
            self._bodies = Named(f"body of {self.path}", bodies)
        return MappingProxyType(self._bodies)

    @property
    def steps(self):
        """The steps, by number: ``log.steps[120]``, ``for step in log.steps[100:200:5]``."""
        return Steps(self, range(self.first_step, self.last_step + 1))

    @property
    def position(self):
        """Positions over steps: ``log.position[100:200]`` is (steps, n, 3), ``log.position[120]`` (n, 3); m."""
        return Column(self, "position")

    @property
    def orientation(self):
        """Orientations over steps, (steps, n, 4), quaternions (w, x, y, z)."""
        return Column(self, "orientation")

    @property
    def velocity(self):
        """Velocities over steps, (steps, n, 3), m/s."""
        return Column(self, "velocity")

    @property
    def spin(self):
        """Angular velocities over steps, (steps, n, 3), rad/s."""
        return Column(self, "spin")

    def _columns(self):
        if self._scan is None:
            self._scan = self._file.scan()
        return self._scan

    @property
    def counters(self):
        """Counts and energies of all steps, one row each from ``first_step + 1`` on: a structured array with step,
        time (s since the log's first state), dt (s), pairs, contacts, substeps, kinetic, potential, inputs, removed
        (J). contacts: of method layered the contact points of a step, of thesis the collisions resolved in all its
        substeps. A log of another engine has no pairs, contacts, substeps and removed."""
        columns = {name: column for name, column in self._columns().items() if name != "hash"}
        table = numpy.empty(len(columns["step"]), [(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            table[name] = column
        table.flags.writeable = False
        return table.view(_Counters)

    @property
    def time(self):
        """The time of every state of the log, s since its first one, (len(log),)."""
        times = numpy.concatenate([[0.0], self._columns()["time"]])
        times.flags.writeable = False
        return times

    @property
    def hashes(self):
        """The hash of every state of the log, (len(log),) texts of 32 digits."""
        return (self.steps[self.first_step].hash, *self._columns()["hash"])

    def chain(self, step=-1):
        """The hash over the whole session up to a step: equal exactly if two sessions are equal up to there."""
        return self._file.chain(step_number(self, step))

    @property
    def inputs(self):
        """All inputs of the session, in order."""
        if self._inputs is None:
            self._inputs = tuple(input_of(fields["step"], fields) for fields in self._file.inputs())
        return self._inputs

    @property
    def channels(self):
        """The channels that the engine declared, by name: "qpos[2]" before "qpos[10]"."""
        named = ((row[1], Channel(self, *row)) for row in self._header["channels"])
        return Named(f"channel of {self.path}", named)
