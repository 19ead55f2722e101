"""Every golden case, through Python and back: World, Log and `tumble dump` have the same bits, and a log that Python
writes from what it read holds the same states."""

import json

import numpy
import pytest

import tumble
from conftest import CASES

STEPS = 10  # the suite itself runs each case to its end
NAMES = sorted(path.parent.name for path in CASES.glob("*/scene.toml"))
COLUMNS = ("position", "orientation", "velocity", "spin", "frozen")


@pytest.mark.parametrize("name", NAMES)
def test_round_trip(name, tmp_path):
    path, copy = tmp_path / "case.tumble", tmp_path / "copy.tumble"
    with tumble.World.from_scene(CASES / name / "scene.toml", steps=STEPS, record=path) as world:
        states = [world.state]
        for _ in range(STEPS):
            world.step()
            states.append(world.state)
    log = tumble.Log(path)
    assert log.hashes[-1] == world.hash
    for step, state in zip(log, states, strict=True):
        assert step.ids.tolist() == state.ids.tolist()
        for column in COLUMNS:
            assert getattr(step, column).tobytes() == getattr(state, column).tobytes(), (step.step, column)
    rows = json.loads(tumble.run("dump", path, "--step", STEPS, "--json").out)["bodies"]
    assert log.steps[STEPS].ids.tolist() == [row["id"] for row in rows]
    for column in COLUMNS[:4]:
        assert getattr(log.steps[STEPS], column).tobytes() == numpy.array([row[column] for row in rows]).tobytes()
    write_again(log, copy)
    for step, again in zip(log, tumble.Log(copy), strict=True):
        assert step.ids.tolist() == again.ids.tolist()
        for column in COLUMNS:
            assert getattr(step, column).tobytes() == getattr(again, column).tobytes(), (step.step, column)
        assert step.hash == again.hash


def write_again(log, path):
    """The same session as a log of another engine."""
    start = log.steps[0]
    bodies = []
    for row, number in enumerate(start.ids.tolist()):
        body = log.bodies[number]
        bodies.append({
            "id": number, "size": body.size, "mass": body.mass, "static": body.static, "frozen": bool(start.frozen[row]),
            **{column: getattr(start, column)[row] for column in COLUMNS[:4]},
        })
    world = log.world
    with tumble.Recorder(path, engine="copy", bodies=bodies, dt=world["dt"], gravity=world["gravity"],
                         ground=world["ground"]) as copy:
        for step in log.steps[1:]:
            for given in step.inputs:
                copy._log.input({"kind": given.kind, **given.fields})
            told = numpy.isin(step.ids, copy.ids)
            copy.step(ids=step.ids[told], dt=step.dt, **{column: getattr(step, column)[told] for column in COLUMNS})
