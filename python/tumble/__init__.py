"""Tumble: rigid-body sessions recorded, replayed, compared and measured, bit for bit.

    import tumble

    tumble.record("brick_wall", "wall.tumble", seconds=2)
    log = tumble.Log("wall.tumble")
    log.steps[120].position            # (n, 3), m, read-only
    log.position[100:200]              # (100, n, 3)
    tumble.diff("wall.tumble", "other.tumble").first

Units are SI, axes right-handed with z up, orientations unit quaternions (w, x, y, z). docs/python.md has more.
"""

try:
    import numpy as _numpy
except ModuleNotFoundError as _missing:
    raise ModuleNotFoundError(
        "tumble needs numpy: apt-get install python3-numpy, or pip install numpy", name="numpy"
    ) from _missing

from ._columns import Channel, Column, Steps
from ._errors import BadInput, CannotFinish, DamagedLog, Error
from ._log import Log
from ._program import Answer, program, run
from ._recorder import Recorder
from ._reports import (
    CheckReport,
    DiffReport,
    MetricsReport,
    RecordReport,
    ReplayReport,
    Report,
    check,
    diff,
    measure,
    record,
    replay,
)
from ._step import Step
from ._tumble import version as __version__
from ._values import Body, Contact, Input, Scene, capsule, cylinder, hull, mesh, sphere
from ._world import World

__all__ = [
    "Answer",
    "BadInput",
    "Body",
    "CannotFinish",
    "Channel",
    "CheckReport",
    "Column",
    "Contact",
    "DamagedLog",
    "DiffReport",
    "Error",
    "Input",
    "Log",
    "MetricsReport",
    "RecordReport",
    "Recorder",
    "ReplayReport",
    "Report",
    "Scene",
    "Step",
    "Steps",
    "World",
    "capsule",
    "check",
    "cylinder",
    "diff",
    "hull",
    "measure",
    "mesh",
    "program",
    "record",
    "replay",
    "run",
    "sphere",
]
