"""One step of a log."""

from types import MappingProxyType

from ._values import Contact, Named, input_of


class Step:
    """The state after one step of a log, and what led to it.

    Arrays are read-only views of memory that the step holds: they stay valid when log and step are gone. Row i of each
    belongs to body ``ids[i]``, ascending. Axes are the world's: right-handed, z up, SI units; orientations are unit
    quaternions (w, x, y, z) from the body's axes to the world's.
    """

    def __init__(self, log, data):
        self._log = log
        self._data = data
        self._block = data.states

    def __repr__(self):
        return f"<tumble.Step {self.step} of {self._log.path!r}>"

    def __reduce__(self):
        return (_step_again, (self._log, self.step))

    @property
    def step(self):
        """Its number: state 0 is the start, step k takes state k - 1 to state k."""
        return self._data.step

    @property
    def dt(self):
        """The length of the step, s."""
        return self._data.dt

    @property
    def hash(self):
        """XXH3-128 of the visible state, 32 hexadecimal digits."""
        return self._data.hash

    @property
    def held(self):
        """Whether the log holds the states of this step. States that it does not hold are computed when asked for."""
        return self._data.states is not None

    def _states(self):
        if self._block is None:
            self._block = self._log._file.states(self.step)
        return self._block

    @property
    def ids(self):
        """Ids of the bodies, (n,) uint64, ascending."""
        return self._states().ids

    @property
    def position(self):
        """Centres of mass, (n, 3), m."""
        return self._states().position

    @property
    def orientation(self):
        """Unit quaternions (w, x, y, z), (n, 4)."""
        return self._states().orientation

    @property
    def velocity(self):
        """Velocities of the centres of mass, (n, 3), m/s."""
        return self._states().velocity

    @property
    def spin(self):
        """Angular velocities about the world's axes, (n, 3), rad/s."""
        return self._states().spin

    @property
    def frozen(self):
        """Whether each body is asleep, (n,) bool."""
        return self._states().frozen

    @property
    def inputs(self):
        """The inputs applied before the step, in order."""
        return tuple(input_of(self.step, fields) for fields in self._data.inputs())

    @property
    def counters(self):
        """Counts and energies (J): pairs, contacts (of method layered its contact points, of thesis the collisions
        resolved in all substeps), substeps, kinetic, potential, inputs, removed; of another engine kinetic, potential
        and inputs. None for the first state of a log, which no step made."""
        if self.step == self._log.first_step:
            return None
        counters = Named(f"counter of step {self.step}", self._data.counters(self._log._file))
        return MappingProxyType(counters)

    @property
    def phase_hashes(self):
        """The hash after each phase of each substep, (substeps, phases) uint64; columns as ``log.phases``."""
        return self._data.phase_words(len(self._log.phases))

    @property
    def contacts(self):
        """The contact points of the step: those that an engine logged, as it logged them. A log of Tumble's own engine
        holds none; they are computed again."""
        if self._log.engine is not None:
            return tuple(Contact(*row) for row in self._data.contacts())
        return tuple(Contact(*row) for row in self._log._file.contacts(self.step))

    @property
    def channels(self):
        """The values that the engine logged in this step, by name of channel: one value where the channel is of the
        world, else a dictionary by id of body or by pair of ids. Channels without a value are left out."""
        values = {}
        for channel in self._log.channels.values():
            rows = self._data.channel(channel._index, self._log._file)
            if not rows:
                continue
            if channel.scope == "world":
                values[channel.name] = rows[0][2]
            elif channel.scope == "body":
                values[channel.name] = {a: value for a, _, value in rows}
            else:
                values[channel.name] = {(a, b): value for a, b, value in rows}
        return values

    @property
    def notes(self):
        """Texts that the engine left with the step."""
        return tuple(self._data.notes())

    @property
    def snapshots(self):
        """The engine's own state after the step, in its own bytes."""
        return tuple(self._data.snapshots())

    @property
    def snapshot_names(self):
        """Their names, in the same order; "" for one without."""
        return tuple(self._data.snapshot_names())

    @property
    def superseded(self):
        """One (same_inputs, difference) for each earlier record of the step that a rollback took back."""
        return tuple(self._data.superseded())


def _step_again(log, number):
    return log.steps[number]
