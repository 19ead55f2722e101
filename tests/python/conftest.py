"""What the tests of the package share: sessions recorded once."""

import pathlib

import pytest

import tumble

TREE = pathlib.Path(__file__).resolve().parents[2]
CASES = TREE / "golden" / "cases"


@pytest.fixture(scope="session")
def session_folder(tmp_path_factory):
    return tmp_path_factory.mktemp("sessions")


@pytest.fixture(scope="session")
def wall(session_folder):
    """A short session with inputs: the path of its log."""
    path = session_folder / "wall.tumble"
    tumble.record(CASES / "layered_inputs" / "scene.toml", path, steps=80)
    return path


@pytest.fixture(scope="session")
def engine_log(session_folder):
    """A log of an engine in Python with channels of every type and scope, contacts and notes."""
    path = session_folder / "engine.tumble"
    with tumble.Recorder(path, engine="two balls", version="1.5", dt=0.01, bodies=TWO_BALLS, channels=CHANNELS) as log:
        for k in range(1, 131):
            log.step(**step_of_two_balls(k))
    return path


TWO_BALLS = [
    {"name": "left", "shape": tumble.sphere(0.25), "mass": 2, "position": (0, 0, 1)},
    {"name": "right", "size": (1, 2, 3), "position": (3, 0, 1)},
]
CHANNELS = {
    "energy": "J",
    "count": {"type": "int64"},
    "seed": {"type": "uint64"},
    "ratio": {"type": "float32"},
    "raw": {"type": "bytes"},
    "label": {"type": "text"},
    "force": {"scope": "body", "unit": "N"},
    "pull": {"scope": "pair"},
}


def step_of_two_balls(k):
    return {
        "position": [(0, 0, 1 / k), (3, 0.1 * k, 1)],
        "velocity": [(0, 0, -0.1 * k), (0, 10, 0)],
        "spin": [(0, 0, 1 / 3), (0, 0, 0)],
        "channels": {
            "energy": k / 7,
            "count": -k,
            "seed": 2**64 - k,
            "ratio": k / 4,
            "raw": bytes([k % 256, 0, 0]),
            "label": f"step {k} \N{SNOWMAN}",
            "force": {1: k * 0.1, 2: -k * 0.1},
            "pull": {(1, 2): 1 / k},
        },
        "contacts": [(2, None, (3, 0, 0), (0, 0, 1), 0.001 * k, 0.5), (1, 2, (1, 0, 1), (1, 0, 0), 0, 0.25)],
        "notes": [f"note {k}"],
        "snapshot": b"state\0" + bytes([k % 256]),
    }
