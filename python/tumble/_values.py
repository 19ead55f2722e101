"""Plain values: inputs, bodies, contacts, shapes, scenes."""

import collections.abc
import dataclasses
import operator
import os
from types import MappingProxyType

from ._errors import BadInput


@dataclasses.dataclass(frozen=True)
class Input:
    """An input: what was done to the bodies before step ``step``.

    ``kind`` is "throw", "push", "remove", "wake", "set_velocity", "set_gravity" or "set_dt". ``fields`` holds the
    values by name: "id", "impulse" (N s), "velocity" (m/s), "spin" (rad/s), "gravity" (m/s^2), "dt" (s), and for a
    throw those of the body. They are attributes too: ``input.impulse``.
    """

    step: int
    kind: str
    fields: MappingProxyType

    def __getattr__(self, name):
        try:
            return object.__getattribute__(self, "fields")[name]
        except (KeyError, AttributeError):
            raise AttributeError(f"an input of this kind has no {name!r}") from None

    def __reduce__(self):
        return (_input_again, (self.step, self.kind, dict(self.fields)))


def _input_again(step, kind, fields):
    return Input(step, kind, MappingProxyType(fields))


def input_of(step, fields):
    """An Input of the module's dictionary."""
    fields = dict(fields)
    fields.pop("step", None)
    kind = fields.pop("kind")
    return Input(step, kind, MappingProxyType(fields))


@dataclasses.dataclass(frozen=True)
class Body:
    """What a log says of a body beside its states.

    ``size``: edge lengths of its box, m. ``mass``: kg. ``shape``: a dictionary as `sphere()` makes one, None for a box.
    ``origin``: the table of the scene that made it, with table number, row and column. ``position`` and so on are those
    it began with.
    """

    id: int
    name: str
    size: tuple
    mass: float
    static: bool
    position: tuple
    orientation: tuple
    velocity: tuple
    spin: tuple
    friction: float
    friction_dynamic: float
    restitution: float
    texture: str
    frozen: bool
    origin: tuple
    shape: object


@dataclasses.dataclass(frozen=True)
class Contact:
    """A contact point. ``a`` and ``b``: ids of bodies, ``b`` None for the ground or the world.

    ``position``: m, in the world. ``normal``: from a to b, and of the ground of Tumble's own engine: up. ``depth``: m, negative before the bodies
    touch. ``impulse``: N s along the normal in this step.
    """

    a: int
    b: object
    position: tuple
    normal: tuple
    depth: float
    impulse: float


@dataclasses.dataclass(frozen=True)
class Scene:
    """A scene as text, where a path or a name will not do: ``Scene('[[box]]\\nsize = [1, 1, 1]\\n...')``.

    ``text`` is TOML (docs/scenes.md); ``name`` is the scene's name where the text gives none.
    """

    text: str
    name: str = "scene"

    @classmethod
    def read(cls, path):
        """The scene of a file."""
        path_bytes(path, "path")
        try:
            with open(path, encoding="utf-8") as file:
                return cls(file.read(), os.path.splitext(os.path.basename(path))[0])
        except (OSError, UnicodeDecodeError) as error:
            raise BadInput(f"{os.fspath(path)}: cannot be read: {error}") from None


def sphere(radius):
    """The shape of a ball, radius in m."""
    return {"kind": "sphere", "radius": radius}


def capsule(radius, half_length, axis="z"):
    """The shape of a capsule along an axis of the body; half_length without the caps; m."""
    return {"kind": "capsule", "radius": radius, "half_length": half_length, "axis": axis}


def cylinder(radius, half_length, axis="z"):
    """The shape of a cylinder along an axis of the body; m."""
    return {"kind": "cylinder", "radius": radius, "half_length": half_length, "axis": axis}


def hull(points):
    """The convex hull of points, (n, 3), m, around the body's centre of mass."""
    return {"kind": "hull", "points": points}


def mesh(points, triangles):
    """A mesh: points (n, 3), m, and triangles (m, 3), indices of points."""
    return {"kind": "mesh", "points": points, "triangles": triangles}


def path_bytes(path, name):
    """A path as the system takes it, whatever its bytes are."""
    try:
        text = os.fsencode(path)
    except TypeError:
        raise BadInput(f"{name}: found {path!r}, wanted a path") from None
    if not text:
        raise BadInput(f"{name}: found an empty name, wanted the path of a file")
    if b"\0" in text:
        raise BadInput(f"{name}: found a zero byte in the path {path!r}")
    return text


def whole(value, name, least, most):
    """A whole number of any kind of Python's or numpy's."""
    try:
        number = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        number = None
    if number is None or not least <= number <= most:
        raise BadInput(f"{name}: found {value!r}, wanted a whole number from {least} to {most}")
    return number


def setting_texts(settings):
    """ "key=value" for each, as `--set` takes it."""
    return [setting_text(key, value) for key, value in named_values(settings, "set").items()]


def setting_text(key, value):
    """ "key=value", as `--set` takes it."""
    if not isinstance(key, str) or not key:
        raise BadInput(f"set: found the key {key!r}, wanted text such as 'world.dt'")
    return utf8(f"{key}={_toml(value)}", "set")


def utf8(text, what):
    """The text, if every character can be written."""
    try:
        text.encode()
    except UnicodeEncodeError:
        raise BadInput(f"{what}: found {text!r}, wanted text of whole characters") from None
    return text


def named_values(given, what):
    """A dictionary, empty for None."""
    if given is None:
        return {}
    if not isinstance(given, collections.abc.Mapping):
        raise BadInput(f"{what}: found {given!r}, wanted a dictionary of values by name")
    return given


class Named(dict):
    """A dictionary whose missing keys are told from those there are. of: "channel of wall.tumble"."""

    def __init__(self, of, *items):
        super().__init__(*items)
        self._of = of

    def __missing__(self, key):
        names = [repr(name) for name in self]
        known = ", ".join(names[:8]) + (", …" if len(names) > 8 else "") if names else "none, for there is none"
        raise KeyError(f"no {self._of}: found {key!r}, wanted {known}")


def _toml(value):
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    raise BadInput(f"set: found {value!r}, wanted a number, text, True, False or a list of them")
