"""Plots with matplotlib, where it is installed: ``import tumble.plot``.

Each function draws into ``axes`` (new ones if not given) and returns them; `matplotlib.pyplot.show()` or
``axes.figure.savefig(...)`` is left to the caller.
"""

import numpy

from ._errors import BadInput, CannotFinish
from ._log import Log
from ._reports import DiffReport, diff


def _axes(axes):
    if axes is not None:
        return axes
    try:
        import matplotlib.pyplot
    except ImportError as error:
        raise CannotFinish(f"plots need matplotlib, which cannot be loaded ({error}): install it") from None
    return matplotlib.pyplot.figure(layout="constrained").add_subplot()


def _log(log):
    return log if isinstance(log, Log) else Log(log)


def energy(log, axes=None):
    """Kinetic energy, potential energy and their sum over time, J over s."""
    log = _log(log)
    axes = _axes(axes)
    table = log.counters
    axes.plot(table["time"], table["kinetic"], label="kinetic")
    axes.plot(table["time"], table["potential"], label="potential")
    axes.plot(table["time"], table["kinetic"] + table["potential"], label="sum")
    axes.set(xlabel="time, s", ylabel="energy, J", title=log.scene)
    axes.legend()
    return axes


def heights(log, bodies=None, axes=None):
    """The height of bodies over time, m over s; of all bodies that the log begins with if none are named."""
    log = _log(log)
    ids = log.steps[log.first_step].ids if bodies is None else numpy.atleast_1d(bodies)
    axes = _axes(axes)
    z = log.position.of(ids)[:][:, :, 2]
    for row, number in enumerate(ids):
        axes.plot(log.time, z[:, row], label=f"body {number}", linewidth=1)
    axes.set(xlabel="time, s", ylabel="height, m", title=log.scene)
    if 1 < len(ids) <= 10:
        axes.legend()
    return axes


def _largest_distance(one, other, step):
    """Between the two places of a body that both logs have in a step, m; infinite where a place is no finite number,
    NaN where a log lost the step."""
    if not (one._file.holds(step) and other._file.holds(step)):
        return numpy.nan
    a, b = one.steps[step], other.steps[step]
    _, rows_a, rows_b = numpy.intersect1d(a.ids, b.ids, assume_unique=True, return_indices=True)
    places_a, places_b = a.position[rows_a], b.position[rows_b]
    if not (numpy.isfinite(places_a).all() and numpy.isfinite(places_b).all()):
        return numpy.inf
    x, y, z = (places_a - places_b).T
    return numpy.hypot(numpy.hypot(x, y), z).max(initial=0.0)  # hypot: a square of 1e-200 m would vanish


def separation(a, b, axes=None, report=None):
    """How far each step of two logs is apart: the largest distance between the two places of a body that both have in
    the step, m, over the steps, on a logarithmic scale, with the first different step marked. A body that one log alone
    has in a step has no distance there. report: what `diff` said of the two, if it was asked."""
    one, other = _log(a), _log(b)
    report = diff(one, other) if report is None else report
    if not isinstance(report, DiffReport):
        raise BadInput(f"report: found {report!r}, wanted a DiffReport")
    first = max(one.first_step, other.first_step)
    last = min(one.last_step, other.last_step)
    steps = numpy.arange(first, last + 1)
    distance = numpy.array([_largest_distance(one, other, step) for step in range(first, last + 1)])
    axes = _axes(axes)
    apart = (distance > 0) | numpy.isnan(distance)  # a step that was lost leaves a gap in the line
    axes.plot(steps[apart], distance[apart])
    axes.set(xlabel="step", ylabel="largest distance, m", title=f"{one.scene}: where two logs part")
    if (distance > 0).any():
        axes.set_yscale("log")
    if report.first is not None:
        axes.axvline(report.first.step, linestyle="--", linewidth=1, label=f"first difference: step {report.first.step}")
        axes.legend()
    return axes
