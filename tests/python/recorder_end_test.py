"""Logs whose session ended early keep why."""

import numpy
import pytest

import tumble


def recorder(path):
    return tumble.Recorder(path, engine="test", bodies=[{}, {}])


def zeros():
    return {"position": numpy.zeros((2, 3)), "velocity": numpy.zeros((2, 3))}


def test_a_log_keeps_why_it_ends(tmp_path):
    path = tmp_path / "x.tumble"

    def reason():
        with tumble.Log(path) as log:
            assert log.last_step == 1
            return tumble.diff(path, path).notes

    with pytest.raises(ZeroDivisionError), recorder(path) as log:
        log.step(**zeros())
        log.push(1, (1, 0, 0))
        print(1 / 0)
    assert any("the program ended it with ZeroDivisionError: division by zero" in note for note in reason())
    with recorder(path) as log:
        log.step(**zeros())
        with pytest.raises(tumble.BadInput):
            log.step(**zeros(), dt=0)
    assert any("a call was refused: step 2: found a dt of 0 s" in note for note in reason())
    with recorder(path) as log:
        log.step(**zeros())
    assert not reason()
