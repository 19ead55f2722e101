"""Writing logs: what is refused, and that nothing is rounded."""

import pickle
import threading

import numpy
import pytest

import tumble


def recorder(path, **more):
    return tumble.Recorder(path, engine="test", bodies=[{}, {"static": True}, {}], **more)


def zeros():
    return {"position": numpy.zeros((2, 3)), "velocity": numpy.zeros((2, 3))}


def test_every_kind_of_array_that_a_double_holds(tmp_path):
    path = tmp_path / "arrays.tumble"
    rng = numpy.random.default_rng(7)
    wide = rng.normal(size=(6, 8))
    with recorder(path) as log:
        assert log.ids.tolist() == [1, 3] and log.coming_step == 1
        log.step(position=wide[::3, 1:7:2], velocity=numpy.asfortranarray(wide[:2, :3]))
        log.step(position=wide[:2, :3].astype("f4"), velocity=[[1, 2, 3], [4, 5, 6]])
        log.step(position=wide[1::-1, ::-1][:, :3], velocity=wide[:2, :3].astype(">f8"))
    read = tumble.Log(path)
    assert numpy.array_equal(read.position.of([1, 3])[1], wide[::3, 1:7:2])
    assert numpy.array_equal(read.position.of([1, 3])[2], wide[:2, :3].astype("f4").astype("f8"))
    assert read.velocity.of([3])[2].tolist() == [[4, 5, 6]]
    assert numpy.array_equal(read.position.of([1, 3])[3], wide[1::-1, ::-1][:, :3])
    assert numpy.array_equal(read.velocity.of([1, 3])[3], wide[:2, :3])


def test_values_that_are_no_numbers_keep_their_bits(tmp_path):
    path = tmp_path / "nan.tumble"
    odd = numpy.array([0x7FF8000000000001, 0xFFF0000000000000, 0x8000000000000000], dtype="u8").view("f8")
    with recorder(path) as log:
        log.step(position=[odd, odd], velocity=[odd, odd])
    read = tumble.Log(path).steps[1]
    assert read.position[0].view("u8").tolist() == odd.view("u8").tolist()


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"position": numpy.zeros((3, 3))}, r"position: found shape \(3, 3\), wanted shape \(2, 3\)"),
        ({"position": numpy.zeros(6)}, r"position: found shape \(6\)"),
        ({"position": numpy.zeros((2, 3), dtype=complex)}, "position: found values of type complex128"),
        ({"position": [["a", "b", "c"], ["d", "e", "f"]]}, "position: found values of type"),
        ({"position": [[1, 2], [3]]}, "position: found"),
        ({"position": None}, "position: is missing"),
        ({"position": numpy.ma.masked_array(numpy.zeros((2, 3)), True)}, "position: found a masked array"),
        ({"velocity": numpy.full((2, 3), 2**60)}, "velocity: found an integer beyond"),
        ({"velocity": numpy.zeros((2, 3), dtype=numpy.longdouble)}, "velocity: found values of type"),
        ({"ids": [1, 3, 5]}, r"position: found shape \(2, 3\), wanted shape \(3, 3\)"),
        ({"ids": [-1, 3]}, "ids: found an id below 0"),
        ({"ids": [1.5, 3]}, "ids: found"),
        ({"channels": {"nope": 1.0}}, 'channels: found "nope", wanted "?f'),
        ({"channels": {"f": "text"}}, 'channel "f"'),
        ({"channels": {"small": 0.1}}, "a value of float32; round it"),
        ({"channels": {"whole": 0.5}}, "a value of int64"),
        ({"channels": {"of body": 0.5}}, "a dictionary of values by body"),
        ({"contacts": [(1, 2)]}, "contacts: wanted rows"),
        ({"frozen": [True]}, "frozen: wanted 2 flags"),
        ({"dt": "1"}, "dt: found"),
        ({"notes": "one"}, "notes: found one text"),
        ({"snapshot": "text"}, "snapshot: wanted bytes"),
        ({"phases": [-1]}, "phases: found"),
        ({"orientation": numpy.zeros((2, 4))}, "orientation"),
    ],
)
def test_wrong_steps_are_refused_with_a_text(tmp_path, change, text):
    channels = {"f": "N", "small": {"type": "float32"}, "whole": {"type": "int64"}, "of body": {"scope": "body"}}
    with recorder(tmp_path / "x.tumble", channels=channels) as log:
        with pytest.raises(tumble.BadInput, match=text):
            log.step(**{**zeros(), **change})
        if "orientation" not in change:  # the log itself refused that one
            log.step(**zeros())
            assert log.coming_step == 2


@pytest.mark.parametrize(
    ("about", "text"),
    [
        ({"bodies": [{"mas": 1}]}, 'body: found "mas", .*did you mean mass'),
        ({"bodies": [{"mass": -1}]}, "mass"),
        ({"bodies": [{"id": 1}, {"id": 1}]}, "id"),
        ({"bodies": [7]}, "bodies: found 7"),
        ({"bodies": [{"texture": "gold"}]}, "texture: found"),
        ({"bodies": [{"shape": {"kind": "cone"}}]}, "shape: kind: found"),
        ({"bodies": [{"shape": tumble.sphere(-1)}]}, "radius"),
        ({"channels": {"a": {"typ": "float64"}}}, "channel 'a': found 'typ'"),
        ({"channels": {"a": {"type": "float16"}}}, "float16"),
        ({"channels": {"a=b": "N"}}, "a=b"),
        ({"precision": "float16"}, "precision: found 'float16'"),
        ({"gravity": (0, 0)}, "gravity: found shape"),
        ({"engine": ""}, "name"),
        ({"engine": 7}, "engine: found 7"),
        ({"phases": "abc"}, "phases: found 'abc'"),
        ({"channels": ["a"]}, "channels: found"),
        ({"channels": {"a": 7}}, "channel 'a': found 7"),
        ({"planned_steps": -1}, "planned_steps: found -1"),
        ({"dt": -1.0}, "dt"),
    ],
)
def test_wrong_declarations_are_refused_with_a_text(tmp_path, about, text):
    path = tmp_path / "x.tumble"
    with pytest.raises(tumble.BadInput, match=text):
        tumble.Recorder(path, **{"engine": "test", **about})
    assert not path.exists()


def test_inputs_of_an_engine(tmp_path):
    path = tmp_path / "inputs.tumble"
    with recorder(path) as log:
        log.throw(id=9, position=(0, 0, 5), name="thrown", shape=tumble.sphere(0.5))
        log.push(1, (1, 0, 0), at=(0, 0, 1))
        assert log.ids.tolist() == [1, 3, 9]
        log.step(position=numpy.zeros((3, 3)), velocity=numpy.zeros((3, 3)))
        log.remove(9)
        log.step(**zeros())
    read = tumble.Log(path)
    assert [given.kind for given in read.inputs] == ["throw", "push", "remove"]
    assert read.steps[1].inputs[1].at == (0, 0, 1) and not read.steps[1].inputs[1].at_centre
    assert read.bodies[9].name == "thrown" and read.bodies[9].shape == tumble.sphere(0.5)


def test_snapshots_with_names(tmp_path):
    path = tmp_path / "snapshots.tumble"
    with recorder(path) as log:
        log.step(**zeros(), snapshot={"random": b"\0\1", "cache": b""})
        log.step(**zeros(), snapshot=b"whole")
        with pytest.raises(tumble.BadInput, match="dictionary of bytes by name"):
            log.step(**zeros(), snapshot={"random": "text"})
        with pytest.raises(tumble.BadInput, match="found a name of 300 bytes"):
            log.step(**zeros(), snapshot={"x" * 300: b""})
    first, second = tumble.Log(path).steps[1:]
    assert dict(zip(first.snapshot_names, first.snapshots)) == {"random": b"\0\1", "cache": b""}
    assert (second.snapshot_names, second.snapshots) == (("",), (b"whole",))


def test_an_error_of_the_engine_leaves_a_whole_log(tmp_path):
    path = tmp_path / "engine_failed.tumble"
    with pytest.raises(ZeroDivisionError):
        with recorder(path) as log:
            log.step(**zeros())
            1 / 0
    assert tumble.Log(path).whole and tumble.Log(path).last_step == 1
    with pytest.raises(ZeroDivisionError):
        with recorder(path) as log:
            log.push(1, (0, 0, 1))  # a log with an input and no step after it cannot be completed
            1 / 0


def test_a_closed_recorder_says_so(tmp_path):
    log = recorder(tmp_path / "x.tumble")
    log.close()
    log.close()
    with pytest.raises(tumble.BadInput, match="takes no more steps"):
        log.step(**zeros())


def test_what_cannot_be_pickled_says_so(tmp_path):
    with recorder(tmp_path / "x.tumble") as log, pytest.raises(TypeError, match="cannot be pickled"):
        pickle.dumps(log)
    world = tumble.World.from_scene(tumble.Scene("[[box]]\nposition = [0, 0, 2]\n"))
    with pytest.raises(TypeError, match="cannot be pickled"):
        pickle.dumps(world)


def test_two_threads_in_one_recorder(tmp_path):
    """Steps of one thread, or an error for the other: never a crash, never a mixture."""
    path = tmp_path / "threads.tumble"
    log = recorder(path)
    refused = []

    def write():
        for _ in range(200):
            try:
                log.step(**zeros())
            except tumble.BadInput as error:
                refused.append(str(error))

    threads = [threading.Thread(target=write) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    log.close()
    assert all("another thread" in text for text in refused)
    assert tumble.Log(path).last_step == 800 - len(refused)
