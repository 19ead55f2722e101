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
        ({"position": numpy.zeros(6)}, r"position: found shape \(6,\)"),
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
        ({"bodies": [{"shape": tumble.sphere(3), "size": (1, 2, 3)}]}, "size: found 1, 2, 3 m, wanted 6, 6, 6 m"),
        ({"channels": {"a": {"typ": "float64"}}}, "channel 'a': found 'typ'"),
        ({"channels": {"a": {"type": "float16"}}}, "float16"),
        ({"channels": {"a=b": "N"}}, "a=b"),
        ({"precision": "float16"}, "precision: found 'float16'"),
        ({"gravity": (0, 0)}, r"gravity: found \(0, 0\), wanted 3 numbers"),
        ({"engine": ""}, "name"),
        ({"engine": 7}, "engine: found 7"),
        ({"phases": "abc"}, "phases: found 'abc'"),
        ({"phases": ["solve", "move", "solve"]}, 'phase "solve": found twice, wanted names that differ'),
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
    assert not tumble.Log(path).whole and tumble.Log(path).last_step == 1
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


ODD = ["a,b", " lead", "trail ", "new\nline", 'q"uote', "100%", "%", "%2c", "ünï", ""]


@pytest.mark.parametrize("ending", ["csv", "npz"])
def test_odd_names_and_texts_survive_a_table(tmp_path, ending):
    path, again = tmp_path / "odd.tumble", tmp_path / "again.tumble"
    names = [name for name in ODD if "\n" not in name]
    channels = {name: {"type": "text"} for name in names if name}
    channels |= {"of bodies": {"type": "text", "scope": "body"}, "of pairs": {"type": "text", "scope": "pair"}}
    with tumble.Recorder(path, engine="test", bodies=[{"name": name} for name in names], channels=channels) as log:
        still = {"position": numpy.zeros((len(names), 3)), "velocity": numpy.zeros((len(names), 3))}
        for text in ODD:
            values = {name: text for name in names if name}
            values |= {"of bodies": {1: text}, "of pairs": {(1, 2): text}}
            log.step(**still, channels=values)
        log.step(**still)
    table = tmp_path / f"odd.{ending}"
    tumble.run("export", path, "-o", table)
    tumble.run("import", table, "-o", again)
    assert tumble.diff(path, again).identical
    old, new = tumble.Log(path), tumble.Log(again)
    assert [body.name for body in new.bodies.values()] == names
    for step in range(len(ODD) + 2):
        assert new.steps[step].channels == old.steps[step].channels, step
    tumble.run("export", path, "-o", tmp_path / "one.csv", "--bodies", "a,b")
    assert len((tmp_path / "one.csv").read_text().split("\nstep,")[1].splitlines()) == 1 + len(ODD) + 2


def test_zero_bytes_in_texts(tmp_path):
    path, again = tmp_path / "zero.tumble", tmp_path / "again.tumble"

    def record(text):
        with recorder(path, channels={"w": {"type": "text"}}) as log:
            log.step(**zeros(), channels={"w": text})

    record("a\0b")
    for ending in ("csv", "npz"):
        tumble.run("export", path, "-o", tmp_path / f"zero.{ending}")
        tumble.run("import", tmp_path / f"zero.{ending}", "-o", again)
        assert tumble.diff(path, again).identical
    record("a\0")
    tumble.run("export", path, "-o", tmp_path / "end.csv")
    with pytest.raises(tumble.BadInput, match="world.w of step 1: found a text that ends with a zero byte"):
        tumble.run("export", path, "-o", tmp_path / "end.npz")


def test_velocities_that_are_no_numbers_have_no_place_in_a_scene(tmp_path):
    path = tmp_path / "fast.tumble"
    with recorder(path) as log:
        log.step(position=numpy.zeros((2, 3)), velocity=numpy.full((2, 3), numpy.inf))
        log.step(position=numpy.full((2, 3), numpy.nan), velocity=numpy.zeros((2, 3)))
    tumble.run("export", path, "-o", tmp_path / "fast.glb", "--steps", "0:1")
    with pytest.raises(tumble.BadInput, match="body 1 at step 2: position.x is nan, which glTF cannot hold"):
        tumble.run("export", path, "-o", tmp_path / "fast.glb")


def test_messages_name_what_was_found(tmp_path):
    with recorder(tmp_path / "x.tumble") as log:
        with pytest.raises(tumble.BadInput, match="found a dt of 0 s, wanted 1e-07 … 1 s"):
            log.step(**zeros(), dt=0)
    with pytest.raises(tumble.BadInput, match='found "idd", wanted name, shape, id, size(?!.*origin)'):
        tumble.Recorder(tmp_path / "y.tumble", engine="test", bodies=[{"idd": 1}])
    with pytest.raises(tumble.BadInput, match="wanted text of whole characters"):
        recorder(tmp_path / "y.tumble", channels={"\ud800": "m"})
    log = tumble.Log(tmp_path / "x.tumble")
    with pytest.raises(KeyError, match="body of .*x.tumble: found 7, wanted 1, 2, 3"):
        log.bodies[7]
    with pytest.raises(KeyError, match="channel of .*x.tumble: found 'a', wanted none"):
        log.channels["a"]


@pytest.mark.parametrize("bad", [{"dt": 0}, {"notes": ["x" * 10**6]}, {"orientation": numpy.zeros((2, 4))},
                                 {"contacts": [(0, None, (0, 0, 0), (0, 0, 1), 0, 0)]}, {"phases": [1]}])
def test_a_refused_step_ends_a_whole_log(tmp_path, bad):
    path = tmp_path / "refused.tumble"
    with pytest.raises(tumble.BadInput, match="step 101: "):
        with recorder(path, channels={"w": {"scope": "body"}}) as log:
            for _ in range(100):
                log.step(**zeros(), channels={"w": {1: 1.0}})
            log.throw(id=9)
            log.step(position=numpy.zeros((3, 3)), velocity=numpy.zeros((3, 3)), channels={"w": {1: 1.0}}, **{
                key: numpy.zeros((3, 4)) if key == "orientation" else value for key, value in bad.items()})
    read = tumble.Log(path)
    assert read.condition.startswith("its session may have gone on: ") and not read.whole
    assert read.last_step == 100 and len(read.bodies) == 3
    assert tumble.run("info", path).code == 0


@pytest.mark.parametrize("unread", [{"position": [(1, 2)]}, {"velocity": None}, {"channels": {"nope": 1}},
                                    {"notes": "abc"}, {"position": [(2**53 + 1, 0, 0)] * 2}, {"snapshot": 3}])
def test_a_step_that_cannot_be_read_is_no_step(tmp_path, unread):
    with recorder(tmp_path / "on.tumble") as log:
        log.step(**zeros())
        with pytest.raises(tumble.BadInput, match="^(?!step )"):
            log.step(**{**zeros(), **unread})
        log.step(**zeros())
    assert tumble.Log(tmp_path / "on.tumble").last_step == 2
