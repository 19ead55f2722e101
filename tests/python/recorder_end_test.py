"""Logs whose session ended early keep why."""

import warnings

import numpy
import pytest

import tumble
from conftest import CASES


def recorder(path):
    return tumble.Recorder(path, engine="test", bodies=[{}, {}])


def zeros():
    return {"position": numpy.zeros((2, 3)), "velocity": numpy.zeros((2, 3))}


def test_a_log_keeps_why_it_ends(tmp_path):
    path = tmp_path / "x.tumble"

    def reason():
        with tumble.Log(path) as log:
            assert log.last_step == 1
            notes = tumble.diff(path, path).notes
            assert log.whole == (not notes), "as the reports say"
            assert log.condition == (notes[0].removeprefix(f"{path}: ") if notes else "whole")
            assert log.condition.removeprefix("its session may have gone on: ") == (log.header["cut_short"] or "whole")
            return notes

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


class Mute(Exception):
    def __str__(self):
        raise RuntimeError("no text")


@pytest.mark.parametrize("error, text", [
    (Mute(), "the program ended it with Mute"),
    (KeyboardInterrupt(), "the program ended it with KeyboardInterrupt"),
    (ValueError("a" * 100_000), "the program ended it with ValueError: " + "a" * 1000 + "..."),
    (ValueError("b\udc80\0c"), "the program ended it with ValueError: b\\udc80\\x00c"),
], ids=["mute", "empty", "long", "no character"])
def test_the_text_of_an_exception_may_be_any(tmp_path, error, text):
    path = tmp_path / "x.tumble"
    with pytest.raises(type(error)), recorder(path) as log:
        log.step(**zeros())
        raise error
    assert [note for note in tumble.diff(path, path).notes if note.endswith(": " + text)]


@pytest.mark.parametrize("error", [ValueError("of the body"), SystemExit(3)], ids=["shown", "not shown"])
def test_what_closing_says_is_not_lost_beside_an_exception(tmp_path, error):
    """The log cannot keep why it ends: another one has its name by then."""
    path = tmp_path / "x.tumble"
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        with pytest.raises(type(error)) as raised, recorder(path) as log:
            log.step(**zeros())
            with pytest.raises(tumble.BadInput):
                log.step(**zeros(), dt=0)
            path.rename(tmp_path / "moved.tumble")
            raise error
    said = getattr(raised.value, "__notes__", []) + [str(one.message) for one in warned]
    assert raised.value is error
    assert len(said) == 1 and "cannot keep why it ends" in said[0]


def test_a_recovered_log_without_its_end_is_not_whole(tmp_path):
    torn, saved = tmp_path / "torn.tumble", tmp_path / "saved.tumble"
    tumble.record(CASES / "layered_inputs" / "scene.toml", torn, steps=600, set={"world.freezing": False})
    torn.write_bytes(torn.read_bytes()[:torn.stat().st_size * 3 // 4])
    with pytest.raises(tumble.DamagedLog):
        tumble.run("recover", torn, "-o", saved)
    with tumble.Log(saved) as log:
        assert not log.whole
        assert log.condition.startswith("its session may have gone on: ")
