import os
from typing import Any

from numpy.typing import ArrayLike

from . import DiffReport, Log

_Log = Log | str | bytes | os.PathLike[str]

def energy(log: _Log, axes: Any = ...) -> Any: ...
def heights(log: _Log, bodies: ArrayLike | None = ..., axes: Any = ...) -> Any: ...
def separation(a: _Log, b: _Log, axes: Any = ..., report: DiffReport | None = ...) -> Any: ...
