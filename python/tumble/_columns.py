"""Steps, columns and channels of a log, by the numbers of steps."""

import operator

import numpy

from ._errors import BadInput
from ._step import Step

_DTYPES = {"float64": "f8", "float32": "f4", "int64": "i8", "uint64": "u8"}


def step_number(log, index):
    first, last = log.first_step, log.last_step
    try:
        number = operator.index(index)
    except TypeError:
        raise TypeError(f"found {index!r}, wanted the number of a step or a slice") from None
    if number < 0:
        number += last + 1
    if not first <= number <= last:
        raise IndexError(f"step {index}: the log {log.path} has the steps {first} to {last}")
    return number


def step_range(log, index):
    """The steps of a slice, which counts as Python's do but by the numbers of steps."""
    start, stop, stride = index.indices(log.last_step + 1)
    if stride > 0:
        start = max(start, log.first_step)
    else:
        stop = max(stop, log.first_step - 1)
    return range(start, stop, stride)


class Steps:
    """A run of steps: a sequence of `Step`, each read when asked for."""

    def __init__(self, log, numbers):
        self._log = log
        self._numbers = numbers

    def __repr__(self):
        return f"<tumble.Steps {self._numbers!r} of {self._log.path!r}>"

    def __len__(self):
        return len(self._numbers)

    def __iter__(self):
        for number in self._numbers:
            yield Step(self._log, self._log._file.step(number))

    def _number(self, index):
        number = step_number(self._log, index)
        from_end = operator.index(index)
        if from_end < 0 and len(self._numbers) + from_end >= 0:
            return self._numbers[from_end]
        if from_end < 0 or number not in self._numbers:
            raise IndexError(f"step {index} is not in this run of steps")
        return number

    def __getitem__(self, index):
        """Step number ``index``, counted from the end of the run where it is negative; or a shorter run."""
        if isinstance(index, slice):
            wanted = step_range(self._log, index)
            if self._numbers != range(self._log.first_step, self._log.last_step + 1):
                raise BadInput("a run of steps cannot be cut again; cut log.steps, whose indices are numbers of steps")
            return Steps(self._log, wanted)
        number = self._number(index)
        return Step(self._log, self._log._file.step(number))


class Column:
    """One column of the states over steps. An index or a slice of steps gives an array, read-only, in C order.

    A slice needs the same bodies in all its steps; ``column.of(ids)`` takes some bodies from any steps.
    """

    def __init__(self, log, name, ids=None):
        self._log = log
        self._name = name
        self._ids = ids

    def __repr__(self):
        return f"<tumble.Column {self._name} of {self._log.path!r}>"

    def __len__(self):
        return len(self._log)

    def of(self, ids):
        """The same column of these bodies alone, in this order. A step that lacks one of them has NaN in its row."""
        known = numpy.atleast_1d(numpy.asarray(ids))
        return Column(self._log, self._name, known)

    def __getitem__(self, index):
        if isinstance(index, slice):
            steps = step_range(self._log, index)
            if not steps:
                width = 4 if self._name == "orientation" else 3
                rows = len(self._log.steps[self._log.first_step].ids) if self._ids is None else len(self._ids)
                return numpy.empty((0, rows, width))
            return self._log._file.column(self._name, steps[0], len(steps), steps.step, self._ids)
        number = step_number(self._log, index)
        return self._log._file.column(self._name, number, 1, 1, self._ids)[0]

    def __array__(self, dtype=None, copy=None):
        return numpy.asarray(self[:], dtype=dtype)


class Channel:
    """A channel: named values that an engine logged. ``type``: float64, float32, int64, uint64, bytes or text.
    ``scope``: world, body or pair."""

    def __init__(self, log, index, name, type, scope, unit):
        self._log = log
        self._index = index
        self.name = name
        self.type = type
        self.scope = scope
        self.unit = unit

    def __repr__(self):
        return f"<tumble.Channel {self.name!r}: {self.type} of {self.scope}, unit {self.unit!r}>"

    def __getitem__(self, index):
        """The values of one step or of a slice of steps: a structured array with a row a value and the fields step, a
        and b (ids of bodies, 0 where the scope has none) and value."""
        if isinstance(index, slice):
            steps = step_range(self._log, index)
        else:
            number = step_number(self._log, index)
            steps = range(number, number + 1)
        rows = self._log._file.channel_rows(self._index, steps.start, len(steps), steps.step)
        dtype = _DTYPES.get(self.type, "O")
        table = numpy.empty(len(rows["step"]), [("step", "u8"), ("a", "u8"), ("b", "u8"), ("value", dtype)])
        for name in ("step", "a", "b"):
            table[name] = rows[name]
        if dtype == "O":
            for row, value in enumerate(rows["bytes"]):
                table["value"][row] = value if self.type == "bytes" else value.decode("utf-8", "backslashreplace")
        else:
            bits = rows["bits"].astype("u4") if self.type == "float32" else rows["bits"]
            table["value"] = bits.view(dtype)
        table.flags.writeable = False
        return table
