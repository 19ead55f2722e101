"""Damaged and forged logs give exceptions, and no crash; threads share a log."""

import os
import random
import signal
import subprocess
import sys
import threading
import time

import numpy
import pytest

import tumble

# Reads all that a log has, in a process of its own: a crash is then a failure of the test and no end of it.
READ_ALL = """
import sys, tumble
for path in sys.argv[1:]:
    try:
        with tumble.Log(path) as log:
            for look in (lambda: log.counters, lambda: log.bodies, lambda: log.inputs, lambda: log.hashes,
                         lambda: log.position[-3:], lambda: log.chain(),
                         lambda: [channel[:] for channel in log.channels.values()],
                         lambda: [(s.position, s.channels, s.notes, s.snapshots, s.inputs, s.contacts, s.phase_hashes)
                                  for s in log.steps[::7]]):
                try:
                    look()
                except tumble.Error:
                    pass
    except tumble.Error:
        pass
print("read")
"""


def read_all(paths):
    return subprocess.run([sys.executable, "-c", READ_ALL, *map(str, paths)], capture_output=True, text=True)


def mutated(good, seed):
    rng = random.Random(seed)
    bytes_ = bytearray(good)
    how = rng.randrange(4)
    if how == 0:
        return bytes(bytes_[: rng.randrange(len(bytes_))])
    if how == 1:
        at, size = rng.randrange(len(bytes_)), rng.randrange(1, 200)
        return bytes(bytes_[:at] + bytes_[at + size :])
    for _ in range(rng.randrange(1, 12)):
        bytes_[rng.randrange(len(bytes_))] = rng.randrange(256)
    return bytes(bytes_) + bytes(rng.randrange(3) * 50 if how == 2 else 0)


@pytest.mark.parametrize("which", ["wall", "engine_log"])
def test_mutated_logs_give_exceptions(which, request, tmp_path):
    good = request.getfixturevalue(which).read_bytes()
    paths = []
    for seed in range(150):
        paths.append(tmp_path / f"{seed}.tumble")
        paths[-1].write_bytes(mutated(good, seed))
    done = read_all(paths)
    assert done.returncode == 0 and done.stdout == "read\n", done.stderr[-2000:]


def test_things_that_are_no_logs(tmp_path):
    empty = tmp_path / "empty.tumble"
    empty.write_bytes(b"")
    with pytest.raises(tumble.DamagedLog):
        tumble.Log(empty)
    for path in (tmp_path, tmp_path / "none.tumble", os.fsencode(tmp_path) + b"/\xff\xfe.tumble"):
        with pytest.raises(tumble.BadInput):
            tumble.Log(path)
    for wrong in (7, None, "zero\0byte.tumble"):
        with pytest.raises(tumble.BadInput):
            tumble.Log(wrong)


def test_names_of_any_bytes(tmp_path, engine_log):
    path = os.fsencode(tmp_path) + b"/\xff\xfe \n.tumble"
    with open(path, "wb") as file:
        file.write(engine_log.read_bytes())
    log = tumble.Log(path)
    assert os.fsencode(log.path) == path and log.last_step == 130
    assert tumble.diff(log, engine_log).identical


def test_a_log_that_shrinks_under_its_reader(engine_log, tmp_path):
    copy = tmp_path / "shrinks.tumble"
    copy.write_bytes(engine_log.read_bytes())
    log = tumble.Log(copy)
    os.truncate(copy, 2000)
    with pytest.raises(tumble.Error):
        log.counters
        log.position[:]


def test_threads_share_a_log(wall):
    log = tumble.Log(wall)
    expected = [log.steps[k].position.copy() for k in range(81)]
    failures = []

    def read(seed):
        rng = random.Random(seed)
        for _ in range(200):
            k = rng.randrange(81)
            if not numpy.array_equal(log.steps[k].position, expected[k]):
                failures.append(k)

    threads = [threading.Thread(target=read, args=(seed,)) for seed in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_closing_while_others_read(wall):
    for _ in range(20):
        log = tumble.Log(wall)
        errors = []

        def read(log=log, errors=errors):
            try:
                for step in log:
                    step.position.sum()
            except tumble.BadInput:
                pass
            except BaseException as error:
                errors.append(error)

        threads = [threading.Thread(target=read) for _ in range(3)]
        for thread in threads:
            thread.start()
        log.close()
        for thread in threads:
            thread.join()
        assert not errors


def test_two_threads_step_one_world_one_after_the_other():
    world = tumble.World.from_scene(tumble.Scene("[[box]]\nsize = [1, 1, 1]\nposition = [0, 0, 2]\n", "x"))
    alone = tumble.World.from_scene(tumble.Scene("[[box]]\nsize = [1, 1, 1]\nposition = [0, 0, 2]\n", "x"))
    threads = [threading.Thread(target=lambda: [world.step() for _ in range(50)]) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    alone.step(200)
    assert world.step_count == 200 and world.hash == alone.hash


def test_the_module_shows_nothing_but_its_name():
    """Another module's copy of an inline function may have other bits, and must not replace ours."""
    from tumble import _tumble

    shown = subprocess.run(["nm", "-D", "--defined-only", _tumble.__file__], capture_output=True, text=True, check=True)
    assert [line.split()[-1] for line in shown.stdout.splitlines()] == ["PyInit__tumble"]


# A daemon thread is in a long call when Python ends.
ENDS = """
import threading, tumble
world = tumble.World.from_scene(tumble.Scene("[[box]]\\nposition = [0, 0, 2]\\n", "x"), record="ends.tumble")
threading.Thread(target=world.step, args=(10**9,), daemon=True).start()
print("ends", flush=True)
"""

# A child that was forked while a session records.
FORKS = """
import os, sys, tumble
world = tumble.World.from_scene(tumble.Scene("[[box]]\\nposition = [0, 0, 2]\\n", "x"), record="forks.tumble", threads=3)
world.step(10)
child = os.fork()
if child == 0:
    del world
    sys.exit(7)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
world.step(10)
world.close()
print(tumble.Log("forks.tumble").whole, tumble.Log("forks.tumble").last_step)
"""


def python(script, folder):
    return subprocess.run([sys.executable, "-c", script], cwd=folder, capture_output=True, text=True)


def test_python_ends_while_a_thread_steps(tmp_path):
    done = python(ENDS, tmp_path)
    assert done.returncode == 0 and done.stdout == "ends\n", done.stderr


def test_a_forked_child_leaves_the_session_alone(tmp_path):
    done = python(FORKS, tmp_path)
    assert done.stdout == "True 20\n", done.stderr


def test_ctrl_c_while_the_program_records(tmp_path):
    path = tmp_path / "long.tumble"

    def interrupt():
        while not path.exists() or path.stat().st_size < 5000:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        tumble.record(tumble.Scene("[[box]]\nposition = [0, 0, 2]\n", "x"), path, steps=100_000_000)
    thread.join()
    assert tumble.Log(path).whole and tumble.Log(path).last_step > 0


@pytest.mark.parametrize(("argument", "call"), [
    ("path", lambda: tumble.Recorder("", engine="test")),
    ("path", lambda: tumble.Recorder(b"", engine="test")),
    ("path", lambda: tumble.Log("")),
    ("path", lambda: tumble.Scene.read("")),
    ("record", lambda: tumble.World.from_scene("brick_wall", record="")),
])
def test_a_path_without_a_name_is_named(argument, call):
    with pytest.raises(tumble.BadInput, match=f"^{argument}: found an empty name, wanted the path of a file$"):
        call()


@pytest.mark.parametrize(("pair", "text"), [
    ((1, 77), "of body 77, wanted the id of a body that exists"),
    ((77, 1), "of body 77, wanted the id of a body that exists"),
    ((2, 2), "found a pair of body 2 with itself, wanted two bodies"),
])
def test_a_value_of_a_pair_is_of_two_bodies(tmp_path, pair, text):
    path = tmp_path / "x.tumble"
    here = [(0, 0, 1), (3, 0, 1)]
    with tumble.Recorder(path, engine="test", bodies=[{}, {}], channels={"pull": {"scope": "pair"}}) as log:
        with pytest.raises(tumble.BadInput, match=f'channel "pull": .*{text}'):
            log.step(position=here, velocity=here, channels={"pull": {pair: 1.0}})
        assert log.coming_step == 1, "the log goes on"
        log.step(position=here, velocity=here, channels={"pull": {(2, 1): 1.0}})
        log.remove(2)
        log.step(position=here[:1], velocity=here[:1], channels={"pull": {(1, 2): 0.0}})
        with pytest.raises(tumble.BadInput, match="of body 2, wanted"):
            log.step(position=here[:1], velocity=here[:1], channels={"pull": {(1, 2): 0.0}})
    assert tumble.Log(path).last_step == 2
