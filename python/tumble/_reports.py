"""What the commands report, as objects: the numbers are those of ``--json``."""

import collections.abc
import os
import re
import struct

from ._errors import BadInput
from ._log import Log
from ._program import ask, path_text, scene_file
from ._values import Scene, named_values, setting_texts, utf8

_NO_NUMBER = re.compile(r"-?(?:nan|inf)\(0x([0-9a-f]{16})\)")


class Report(collections.abc.Mapping):
    """A report: the members of the program's JSON as attributes, in depth: ``report.first.step``.

    Lists are tuples. Numbers that JSON does not have (infinities, NaN) are floats with all their bits. ``report.json``
    is the JSON as it came.
    """

    def __init__(self, json):
        self._json = json

    @property
    def json(self):
        """The program's JSON, a dictionary."""
        return self._json

    def __getattr__(self, name):
        if name.startswith("__") or name == "_json":
            raise AttributeError(name)
        try:
            return _value(self._json[name])
        except KeyError:
            known = ", ".join(self._json)
            raise AttributeError(f"found no {name!r} in this report, which has {known}") from None

    def __getitem__(self, key):
        return _value(self._json[key])

    def __iter__(self):
        return iter(self._json)

    def __len__(self):
        return len(self._json)

    def __dir__(self):
        return [*super().__dir__(), *(key for key in self._json if key.isidentifier())]

    def __repr__(self):
        members = ", ".join(f"{key}={_brief(value)}" for key, value in self._json.items())
        return f"{type(self).__name__}({members})"


def _brief(value):
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _value(json):
    if isinstance(json, dict):
        return Report(json)
    if isinstance(json, list):
        return tuple(_value(item) for item in json)
    found = _NO_NUMBER.fullmatch(json) if isinstance(json, str) else None
    return struct.unpack("<d", struct.pack("<Q", int(found[1], 16)))[0] if found else json


class RecordReport(Report):
    """A recorded session: log, scene, bodies, steps, simulated (s), elapsed (s), bytes, final_hash, warnings."""

    def open(self):
        """The log."""
        return Log(self._json["log"])


class ReplayReport(Report):
    """A log beside this build's replay of it: identical, steps, first (None, or the first difference), notes."""


class DiffReport(Report):
    """Two logs compared: identical, steps, first (None, or the first difference: step, phase, body, field, expected,
    actual, ...), cause, aftermath, headers, notes."""


class MetricsReport(Report):
    """The metrics of a session, by the names of docs/metrics.md."""


class CheckReport(Report):
    """A suite's results: passed, failed, cases, canaries, and the rest of report.json."""


def _log_path(log, what):
    return path_text(log.path if isinstance(log, Log) else log, what)


def _option(words, name, value):
    if value is not None:
        words += [name, str(value)]


def record(scene, out=None, *, seconds=None, steps=None, set=None, threads=None, states="all", hashes="all",
           mirror=None, shift=None, permute=None):
    """Runs a scene with Tumble's own engine and writes every input and step to a log.

    scene: a path, the name of a golden case, or a `Scene`. out: the log; ``<scene>.tumble`` in the current folder if not
    given. seconds or steps: how long; as the scene plans if not given. set: values of the scene by key, as in
    ``{"grid.rows": 7}``. threads: they change no bit. mirror ("x", "y", "diagonal"), shift (x, y in m) and permute (a
    seed) transform the scene. Returns a `RecordReport`. Ctrl-C ends the session and completes the log.
    """
    words = ["record"]
    if out is not None:
        words += ["-o", path_text(out, "out")]
    _option(words, "--seconds", seconds)
    _option(words, "--steps", steps)
    _option(words, "--threads", threads)
    _option(words, "--states", states)
    _option(words, "--hashes", hashes)
    _option(words, "--mirror", mirror)
    if shift is not None:
        words += ["--shift", ",".join(repr(float(metres)) for metres in shift)]
    _option(words, "--permute", permute)
    for text in setting_texts(set):
        words += ["--set", text]
    if isinstance(scene, Scene):
        return _record_text(scene, out, words)
    path = scene_file(scene)
    if out is None and path != path_text(scene, "scene"):
        words += ["-o", f"{scene}.tumble"]  # a case is named by its folder, and its log by the case
    return RecordReport(ask(*words, path)[0])


def _record_text(scene, out, words):
    import tempfile

    if out is None:
        raise BadInput("record: a scene of text needs a path for its log")
    with tempfile.TemporaryDirectory() as folder:
        name = "".join(c if c.isalnum() or c in "-_." else "_" for c in scene.name) or "scene"
        path = os.path.join(folder, name + ".toml")
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(utf8(scene.text, "scene"))
        return RecordReport(ask(*words, path)[0])


def replay(log, *, threads=None, brief=False):
    """Runs a log's inputs through this build's physics and compares every step. brief: stops at the first difference.
    Returns a `ReplayReport`."""
    words = ["replay", _log_path(log, "log")]
    _option(words, "--threads", threads)
    if brief:
        words.append("--brief")
    return ReplayReport(ask(*words)[0])


def diff(a, b, *, tolerance=None, until=None, apart=None, brief=False):
    """Finds the first difference between two logs, the one with the expected values first.

    tolerance: by field, as in ``{"position": 1e-9}``; states then decide, not hashes. until: s, only the steps that end
    by then. apart: m, asks when a body is first that far from its place in the other log. brief: by hashes alone, so
    that damage in states is not seen. Returns a `DiffReport`.
    """
    words = ["diff", _log_path(a, "a"), _log_path(b, "b")]
    for field, value in named_values(tolerance, "tolerance").items():
        words += ["--tolerance", f"{field}={_number(value, 'tolerance')}"]
    _option(words, "--until", until)
    _option(words, "--apart", apart)
    if brief:
        words.append("--brief")
    return DiffReport(ask(*words)[0])


def _number(value, what):
    try:
        return repr(float(value))
    except (TypeError, ValueError):
        raise BadInput(f"{what}: found {value!r}, wanted a number") from None


def measure(log, *, bodies=None, from_step=None, other=None):
    """Measures symmetry, energy and stacking of a session. bodies: which, as `--bodies` takes them. other: the log of
    the transformed scene, for the errors of the pair. Returns a `MetricsReport`."""
    words = ["measure", _log_path(log, "log")]
    _option(words, "--bodies", bodies)
    _option(words, "--from-step", from_step)
    if other is not None:
        words += ["--with", _log_path(other, "other")]
    return MetricsReport(ask(*words)[0])


def check(*cases, suite=None, report=None, require=(), category=None, jobs=None, timeout=None, shard=None):
    """Runs golden cases, all if none is named, and compares them with their expected results.

    suite: a folder with cases/ in it. report: a folder for index.html, junit.xml, report.json and the logs of failed
    cases; a folder that is removed afterwards if not given. require: verdicts that decide: "exact", "behaviour",
    "image". Returns a `CheckReport`. Raises CannotFinish where a canary was not caught.
    """
    import tempfile

    words = ["check", *(path_text(case, "case") for case in cases)]
    if suite is not None:
        words += ["--suite", path_text(suite, "suite")]
    for verdict in (require,) if isinstance(require, str) else require:
        words += ["--require", verdict]
    _option(words, "--category", category)
    _option(words, "--jobs", jobs)
    _option(words, "--timeout", timeout)
    _option(words, "--shard", shard)
    if report is not None:
        return CheckReport(ask(*words, "--report", path_text(report, "report"))[0])
    with tempfile.TemporaryDirectory() as folder:
        return CheckReport(ask(*words, "--report", folder)[0])
