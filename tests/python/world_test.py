"""Worlds stepped from Python have the bits of the program."""

import ctypes
import platform
import signal
import threading
import time

import numpy
import pytest

import tumble
from conftest import CASES

SCENE = tumble.Scene(
    """
    [world]
    method = "layered"
    dt = 0.01
    steps = 40
    [[box]]
    size = [1, 1, 1]
    position = [0, 0, 3]
    """,
    "one_box",
)


def scene(name):
    return CASES / name / "scene.toml"


def test_a_stepped_world_has_the_hashes_of_a_recorded_one(wall):
    log = tumble.Log(wall)
    world = tumble.World.from_scene(scene("layered_inputs"))
    assert world.step_count == 0 and world.hash == log.steps[0].hash
    for number in range(1, 81):
        world.step()
        assert world.hash == log.steps[number].hash
    assert numpy.array_equal(world.position, log.steps[80].position)
    assert world.kinetic_energy == log.steps[80].counters["kinetic"]


def test_a_world_with_a_recorder_writes_the_log_of_the_program(wall, tmp_path):
    path = tmp_path / "own.tumble"
    with tumble.World.from_scene(scene("layered_inputs"), steps=80, record=path, threads=2) as world:
        world.run()
    assert tumble.Log(path).chain() == tumble.Log(wall).chain()
    assert tumble.replay(path).identical


def test_live_inputs_are_recorded_and_replay(tmp_path):
    path = tmp_path / "live.tumble"
    with tumble.World.from_scene(SCENE, record=path) as world:
        world.step(5)
        thrown = world.throw(size=(0.5, 0.5, 0.5), mass=3, position=(0, 0, 6), velocity=(0, 0, -2))
        assert thrown == 2 and world.ids.tolist() == [1]
        world.push(1, (0.5, 0, 0))
        world.push(thrown, (0, 1, 0), at=(0, 0, 6.1))
        world.step()
        assert world.ids.tolist() == [1, 2] and world.mass.tolist() == [1, 3]
        world.set_velocity(1, (1, 2, 3), spin=(0, 0, 1))
        world.set_gravity((0, 0, -1))
        world.set_dt(0.005)
        world.wake(1)
        world.step()
        assert world.gravity == (0, 0, -1) and world.dt == 0.005
        world.remove(thrown)
        world.step(10)
        assert world.throw(position=(9, 9, 9)) == 3
    log = tumble.Log(path)
    assert [given.kind for given in log.steps[6].inputs] == ["throw", "push", "push"]
    centre, aside = log.steps[6].inputs[1:]
    assert centre.at_centre and not aside.at_centre and aside.at == (0, 0, 6.1) and aside.impulse == (0, 1, 0)
    assert log.last_step == 17 and tumble.replay(path).identical
    again = tumble.World.from_scene(SCENE)
    for step in log.steps[1:]:
        for given in step.inputs:
            again.apply(given)
        again.step()
    assert again.hash == log.hashes[-1]


def test_a_session_goes_on_from_a_log(wall, engine_log, tmp_path):
    log = tumble.Log(wall)
    world = tumble.World.from_log(wall, 40)
    assert world.step_count == 40 and world.hash == log.steps[40].hash
    assert world.contacts == ()
    world.step(20)
    assert world.contacts == log.steps[60].contacts != ()
    world.step(20)
    assert world.hash == log.hashes[-1]
    with tumble.World.from_log(log, 50, inputs=False, steps=20, record=tmp_path / "other.tumble") as other:
        other.push(int(other.ids[0]), (1, 2, 3))
        other.run()
    again = tumble.Log(tmp_path / "other.tumble")
    assert (again.first_step, again.last_step) == (50, 70) and again.header["goes_on"]["step"] == 50
    assert [step.step for step in again.steps[:53]] == [50, 51, 52] and again.position.of([1])[50:].shape == (21, 1, 3)
    assert again.time.shape == (21,) and again.counters["step"][0] == 51
    with pytest.raises(IndexError):
        again.steps[49]
    assert tumble.replay(again).identical
    with pytest.raises(tumble.Error):
        tumble.World.from_log(engine_log, 5)
    before = wall.read_bytes()
    with pytest.raises(tumble.BadInput, match="the log to continue"):
        tumble.World.from_log(wall, 40, record=wall)
    assert wall.read_bytes() == before


def test_a_refused_input_harms_nothing():
    world, other = tumble.World.from_scene(SCENE), tumble.World.from_scene(SCENE)
    for wrong, text in [
        (lambda: world.push(7, (0, 0, 1)), "7"),
        (lambda: world.push(1, (0, 0, numpy.nan)), "impulse"),
        (lambda: world.push(1, (0, 0)), r"impulse: found \(0, 0\), wanted 3 numbers"),
        (lambda: world.push("1", (0, 0, 1)), "id: found"),
        (lambda: world.throw(id=1), "1"),
        (lambda: world.throw(mass=-1), "mass"),
        (lambda: world.throw(static=1), "static: found 1, wanted True or False"),
        (lambda: world.throw(size=(1, 1)), r"size: found \(1, 1\), wanted 3 numbers"),
        (lambda: world.set_dt(0), "dt"),
        (lambda: world.step(-1), "step: found -1"),
    ]:
        with pytest.raises(tumble.BadInput, match=text):
            wrong()
    world.step(10)
    other.step(10)
    assert world.hash == other.hash


def test_wrong_scenes_and_settings():
    with pytest.raises(tumble.BadInput, match="did you mean"):
        tumble.World.from_scene("brick_wal")
    with pytest.raises(tumble.BadInput, match="one_box:.*siz"):
        tumble.World.from_scene(tumble.Scene(SCENE.text.replace("size", "siz"), "one_box"))
    with pytest.raises(tumble.BadInput, match="--set world.dtt=1"):
        tumble.World.from_scene(SCENE, set={"world.dtt": 1})
    with pytest.raises(tumble.BadInput, match="one of them"):
        tumble.World.from_scene(SCENE, seconds=1, steps=1)
    with pytest.raises(tumble.BadInput, match="states: found"):
        tumble.World.from_scene(SCENE, record="never.tumble", states="some")
    with pytest.raises(tumble.BadInput, match="hashes: found 7"):
        tumble.World.from_scene(SCENE, hashes=7)
    with pytest.raises(tumble.BadInput, match="threads: found 0"):
        tumble.World.from_scene(SCENE, threads=0)
    with pytest.raises(tumble.BadInput, match="No such file"):
        tumble.World.from_scene("no/such/file.toml")


def test_arrays_show_the_moment_they_were_taken():
    world = tumble.World.from_scene(SCENE)
    state = world.state
    before = state.position.copy()
    world.step(20)
    assert numpy.array_equal(state.position, before) and not numpy.array_equal(world.position, before)
    with pytest.raises(ValueError):
        world.position[0, 0] = 1


def test_a_finished_world_takes_no_step(tmp_path):
    world = tumble.World.from_scene(SCENE, record=tmp_path / "x.tumble")
    assert world.close() == str(tmp_path / "x.tumble")
    world.close()
    with pytest.raises(tumble.BadInput, match="finished"):
        world.step()


def test_other_threads_go_on_while_a_world_steps():
    world = tumble.World.from_scene(scene("layered_pile"), steps=100_000)
    for _ in range(50):  # a busy machine may give this thread no turn in one of them
        marks = []

        def step(marks=marks):
            marks.append("begin")
            world.step(20)
            marks.append("end")

        stepper = threading.Thread(target=step)
        stepper.start()
        while stepper.is_alive():
            marks.append("tick")
            time.sleep(0.0001)
        stepper.join()
        if marks[marks.index("begin") : marks.index("end")].count("tick") >= 3:
            return
    raise AssertionError("no other thread ran while the world stepped")


def test_ctrl_c_ends_a_long_call():
    world = tumble.World.from_scene(SCENE, steps=100_000_000)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            world.step(100_000_000)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    reached = world.step_count
    assert 0 < reached < 100_000_000
    world.step()
    assert world.step_count == reached + 1


def test_a_changed_floating_point_environment_is_refused():
    libm = ctypes.CDLL("libm.so.6")
    world, other = tumble.World.from_scene(SCENE), tumble.World.from_scene(SCENE)
    upward = {"x86_64": 0x800, "aarch64": 0x400000}.get(platform.machine())
    if upward is None:
        pytest.skip("the number of the rounding mode is not known on this machine")
    before = libm.fegetround()
    libm.fesetround(upward)
    try:
        with pytest.raises(tumble.CannotFinish, match="round"):
            world.step()
    finally:
        libm.fesetround(before)
    world.step(5)
    other.step(5)
    assert world.hash == other.hash
