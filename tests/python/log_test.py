"""Reading logs: arrays, slices, inputs, hashes, channels."""

import gc
import json
import pickle

import numpy
import pytest

import tumble
from conftest import step_of_two_balls


def dumped(path, step):
    """The bodies of a step as `tumble dump --json` prints them."""
    return json.loads(tumble.run("dump", path, "--step", step, "--json").out)


def bits(array):
    return numpy.ascontiguousarray(array, dtype="f8").view("u8").tolist()


def test_a_step_has_the_bits_of_dump(wall):
    log = tumble.Log(wall)
    for number in (0, 1, 37, log.last_step):
        step = log.steps[number]
        rows = dumped(wall, number)["bodies"]
        assert step.ids.tolist() == [row["id"] for row in rows]
        for column in ("position", "orientation", "velocity", "spin"):
            assert bits(getattr(step, column)) == bits([row[column] for row in rows]), (number, column)
        assert step.frozen.tolist() == [row["frozen"] for row in rows]


def test_arrays_are_views_that_nobody_can_write(wall):
    step = tumble.Log(wall).steps[10]
    for name in ("ids", "position", "orientation", "velocity", "spin", "frozen"):
        array = getattr(step, name)
        assert not array.flags.writeable and not array.flags.owndata
        with pytest.raises(ValueError):
            array.flags.writeable = True
        with pytest.raises(ValueError):
            array[...] = 0
    assert numpy.shares_memory(step.position, step.position), "two looks at a step copied its memory"
    assert step.position.dtype == numpy.float64 and step.position.flags.c_contiguous


def test_arrays_outlive_step_log_and_file(wall, tmp_path):
    copy = tmp_path / "gone.tumble"
    copy.write_bytes(wall.read_bytes())
    log = tumble.Log(copy)
    position = log.steps[5].position
    before = position.copy()
    log.close()
    copy.unlink()
    del log
    gc.collect()
    assert numpy.array_equal(position, before)


def test_slices_are_the_steps_one_by_one(wall):
    log = tumble.Log(wall)
    run = [k for k in range(0, 10) if len(log.steps[k].ids) == len(log.steps[0].ids)]
    for column in ("position", "orientation", "velocity", "spin"):
        many = getattr(log, column)[0 : len(run)]
        assert many.shape[0] == len(run) and not many.flags.writeable
        for k in run:
            assert bits(many[k]) == bits(getattr(log.steps[k], column))
            assert bits(getattr(log, column)[k]) == bits(many[k])
    assert bits(log.position[6:0:-2]) == bits([log.steps[k].position for k in (6, 4, 2)])
    assert log.position[5:5].shape == (0, len(log.steps[0].ids), 3)
    assert bits(log.position[-1]) == bits(log.steps[log.last_step].position)


def test_bodies_that_come_and_go(wall):
    log = tumble.Log(wall)
    counts = [len(step.ids) for step in log]
    assert len(set(counts)) > 1, "the session has no body that comes or goes, so the test proves nothing"
    with pytest.raises(tumble.BadInput, match="has other bodies than step 0; name the bodies"):
        log.position[:]
    some = sorted(log.bodies)
    over = log.position.of(some)[:]
    assert over.shape == (len(log), len(some), 3)
    for k in range(len(log)):
        step = log.steps[k]
        for row, number in enumerate(some):
            at = numpy.flatnonzero(step.ids == number)
            if len(at):
                assert bits(over[k, row]) == bits(step.position[at[0]])
            else:
                assert numpy.isnan(over[k, row]).all()


def test_steps_are_a_sequence(wall):
    log = tumble.Log(wall)
    assert len(log) == len(log.steps) == 81 and log.first_step == 0
    assert [step.step for step in log.steps[10:20:3]] == [10, 13, 16, 19]
    assert log.steps[-1].step == 80
    run = log.steps[10:20:3]
    assert (run[-1].step, run[-4].step, run[13].step, log.steps[::-1][-1].step) == (19, 10, 13, 0)
    for elsewhere in (-5, 11):
        with pytest.raises(IndexError, match="not in this run of steps"):
            run[elsewhere]
    for wrong in (81, -82):
        with pytest.raises(IndexError, match="has the steps 0 to 80"):
            log.steps[wrong]
    with pytest.raises(TypeError):
        log.steps["3"]


def test_inputs(wall):
    log = tumble.Log(wall)
    assert {given.kind for given in log.inputs} >= {"throw", "push"}
    assert log.inputs == tuple(given for step in log for given in step.inputs)
    push = next(given for given in log.inputs if given.kind == "push")
    assert len(push.impulse) == 3 and push.id in log.bodies
    with pytest.raises(AttributeError):
        push.mass
    assert pickle.loads(pickle.dumps(push)) == push


def test_hashes_counters_and_times(wall):
    log = tumble.Log(wall)
    assert log.hashes == tuple(step.hash for step in log)
    table = log.counters
    assert table["step"].tolist() == list(range(1, 81))
    step = log.steps[40]
    for name, value in step.counters.items():
        assert table[39][name] == value, name
    assert log.steps[0].counters is None
    with pytest.raises(KeyError, match="no counter: found 'knetic', wanted 'step', 'time', .*'kinetic'"):
        table["knetic"]
    with pytest.raises(KeyError, match="no counter of step 40: found 'knetic', wanted .*'kinetic'"):
        step.counters["knetic"]
    assert type(table["kinetic"]) is numpy.ndarray and table[["step", "dt"]][3]["step"] == 4
    assert log.time.shape == (81,) and log.time[0] == 0
    assert log.time[60] == 60 * log.world["dt"]  # multiplied and not added up, as the program counts
    assert log.chain() == log.chain(80) != log.chain(79)
    assert step.phase_hashes.shape[1] == len(log.phases) > 5


def test_states_that_a_log_does_not_hold_are_computed(wall, session_folder):
    thin = session_folder / "thin.tumble"
    scene = tumble.Log(wall).scene_text
    tumble.record(tumble.Scene(scene, "layered_inputs"), thin, steps=80, states="hashes")
    log, whole = tumble.Log(thin), tumble.Log(wall)
    assert not log.steps[33].held and whole.steps[33].held
    assert bits(log.steps[33].position) == bits(whole.steps[33].position)
    assert log.hashes == whole.hashes


def test_contacts_of_our_own_engine(wall):
    contacts = tumble.Log(wall).steps[60].contacts
    assert contacts and all(contact.normal is not None and contact.a in tumble.Log(wall).bodies for contact in contacts)


def test_header(wall, engine_log):
    log = tumble.Log(wall)
    assert log.whole and log.condition.startswith("whole") and log.engine is None
    assert log.world["dt"] > 0 and log.header["tool_version"] == tumble.__version__
    assert log.scene_text and log.header["overrides"] == ["world.steps=80"]
    other = tumble.Log(engine_log)
    assert other.engine == {"name": "two balls", "version": "1.5", "precision_bits": 53}
    body = other.bodies[1]
    assert (body.name, body.mass, body.shape, body.size) == ("left", 2, tumble.sphere(0.25), (0.5, 0.5, 0.5))


def test_what_an_engine_wrote_is_read_to_the_bit(engine_log):
    log = tumble.Log(engine_log)
    for k in (1, 2, 77, 130):
        step, wrote = log.steps[k], step_of_two_balls(k)
        for column in ("position", "velocity", "spin"):
            assert bits(getattr(step, column)) == bits(wrote[column])
        assert step.channels == {name: value for name, value in sorted(wrote["channels"].items())}
        assert step.notes == tuple(wrote["notes"]) and step.snapshots == (wrote["snapshot"],)
        assert [(c.a, c.b, c.position, c.normal, c.depth, c.impulse) for c in step.contacts] == [
            (1, 2, (1, 0, 1), (1, 0, 0), 0, 0.25),
            (2, None, (3, 0, 0), (0, 0, 1), 0.001 * k, 0.5),
        ]


def test_counters_that_no_engine_tells_are_left_out(engine_log, wall):
    untold = {"pairs", "contacts", "substeps", "removed"}
    log = tumble.Log(engine_log)
    assert not untold & set(log.counters.dtype.names) and "kinetic" in log.counters.dtype.names
    assert not untold & set(log.steps[log.last_step].counters)
    assert untold <= set(tumble.Log(wall).counters.dtype.names)


def test_channels_over_steps(engine_log):
    channels = tumble.Log(engine_log).channels
    assert (channels["force"].scope, channels["force"].unit, channels["seed"].type) == ("body", "N", "uint64")
    energy = channels["energy"][1:131]
    assert energy["step"].tolist() == list(range(1, 131))
    assert bits(energy["value"]) == bits([k / 7 for k in range(1, 131)])
    assert channels["seed"][3]["value"].tolist() == [2**64 - 3]
    assert channels["ratio"][5]["value"].dtype == numpy.float32
    assert channels["raw"][9]["value"].tolist() == [bytes([9, 0, 0])]
    assert channels["label"][9]["value"].tolist() == ["step 9 \N{SNOWMAN}"]
    assert [tuple(row) for row in channels["force"][7]] == [(7, 1, 0, 7 * 0.1), (7, 2, 0, -7 * 0.1)]
    assert [tuple(row) for row in channels["pull"][4:6]] == [(4, 1, 2, 1 / 4), (5, 1, 2, 1 / 5)]


def test_pickled_logs_and_steps_read_the_same_file(wall):
    log = tumble.Log(wall)
    again = pickle.loads(pickle.dumps(log))
    assert bits(again.steps[9].position) == bits(log.steps[9].position)
    assert pickle.loads(pickle.dumps(log.steps[9])).hash == log.steps[9].hash


def test_a_closed_log_says_so(wall):
    with tumble.Log(wall) as log:
        step = log.steps[3]
    assert log.closed and step.position.shape[1] == 3
    for read in (lambda: log.steps[3], lambda: log.position[3], lambda: log.counters, lambda: log.bodies, log.chain):
        with pytest.raises(tumble.BadInput, match="the log is closed"):
            read()
    with pytest.raises(tumble.BadInput):
        pickle.dumps(log)
    log.close()


def test_channels_are_listed_with_numbers_in_the_order_of_their_values(tmp_path):
    path = tmp_path / "numbered.tumble"
    body = {"position": numpy.zeros((1, 3)), "velocity": numpy.zeros((1, 3))}
    with tumble.Recorder(path, engine="test", bodies=[{}], channels={"q[10]": "m", "q[2]": "m", "a": ""}) as log:
        log.step(**body, channels={"q[10]": 10.0, "q[2]": 2.0, "a": 1.0})
    read = tumble.Log(path)
    assert list(read.channels) == ["a", "q[2]", "q[10]"]
    assert read.steps[1].channels == {"a": 1, "q[2]": 2, "q[10]": 10}
    assert read.channels["q[10]"][1]["value"].tolist() == [10]
