"""Reports: the numbers are those of --json; errors have the program's texts."""

import json
import math

import pytest

import tumble
from conftest import CASES

CASE = CASES / "layered_bounce" / "scene.toml"


@pytest.fixture(scope="module")
def pair(session_folder):
    """Two sessions that part."""
    paths = session_folder / "a.tumble", session_folder / "b.tumble"
    tumble.record(CASE, paths[0], steps=60)
    tumble.record(CASE, paths[1], steps=60, set={"world.gravity": (0, 0, -9.8)})
    return paths


def said(*words):
    return json.loads(tumble.run(*words, "--json").out)


def test_record_tells_what_it_recorded(tmp_path):
    report = tumble.record(CASE, tmp_path / "x.tumble", steps=12, threads=2)
    assert report.steps == 12 and report.log == str(tmp_path / "x.tumble")
    assert report.open().hashes[-1] == report.final_hash
    by_name = tumble.record("layered_bounce", tmp_path / "y.tumble", steps=12)
    assert by_name.final_hash == report.final_hash


def test_diff_is_the_programs(pair):
    report = tumble.diff(*pair)
    assert report.json == said("diff", *pair)
    assert not report.identical and report.first.step == 1
    assert report.first.expected != report.first.actual
    assert tumble.diff(pair[0], tumble.Log(pair[0])).identical
    assert tumble.diff(*pair, tolerance={"position": 1e3, "velocity": 1e3, "spin": 1e3, "orientation": 7}).identical
    assert tumble.diff(*pair, brief=True).first.step == report.first.step


def test_measure_and_replay_are_the_programs(pair):
    report = tumble.measure(pair[0])
    assert report.json == said("measure", pair[0])
    assert set(report) == set(report.json) and len(report) > 3
    replayed = tumble.replay(pair[0])
    assert replayed.identical and replayed.steps == 60 and replayed.first is None


def test_check_runs_cases(tmp_path):
    report = tumble.check("layered_bounce", suite=CASES.parent, report=tmp_path / "report", jobs=1)
    assert report.json["cases"][0]["name"] == "layered_bounce"
    assert (tmp_path / "report" / "index.html").is_file()
    assert report.passed
    with pytest.raises(tumble.BadInput, match="no_such_case"):
        tumble.check("no_such_case", suite=CASES.parent)


def test_members_of_a_report():
    report = tumble.Report({"a": {"b": [1, {"c": "nan(0x7ff8000000000001)"}]}, "e": "-inf(0xfff0000000000000)"})
    assert report.a.b[0] == 1 and math.isnan(report.a.b[1].c) and report["e"] == -math.inf
    assert "a" in dir(report) and "Report(a=" in repr(report)
    with pytest.raises(AttributeError, match="no 'x' in this report, which has a, e"):
        report.x


def test_errors_have_the_programs_texts(tmp_path, wall):
    with pytest.raises(tumble.BadInput) as caught:
        tumble.diff(tmp_path / "none.tumble", wall)
    assert "none.tumble" in caught.value.message and not caught.value.message.startswith("tumble ")
    assert isinstance(caught.value, ValueError) and caught.value.exit_code == 2
    for wrong in (
        lambda: tumble.record(CASE, tmp_path / "x.tumble", seconds=-1),
        lambda: tumble.record(CASE, tmp_path / "x.tumble", set={"world.dtt": 1}),
        lambda: tumble.record("--help", tmp_path / "x.tumble"),
        lambda: tumble.record(CASE, tmp_path / "x\0.tumble"),
        lambda: tumble.record(7, tmp_path / "x.tumble"),
        lambda: tumble.diff(wall, wall, tolerance={"position": "x"}),
        lambda: tumble.record(CASE, tmp_path / "x.tumble", set={"world.dt": {}}),
        lambda: tumble.Log(tmp_path),
        lambda: tumble.Log(CASE),
    ):
        with pytest.raises(tumble.BadInput):
            wrong()


def test_a_torn_log_is_an_error_that_holds_the_report(wall, tmp_path):
    torn = tmp_path / "torn.tumble"
    torn.write_bytes(wall.read_bytes()[:-300])
    log = tumble.Log(torn)
    assert not log.whole and "torn" in log.condition
    with pytest.raises(tumble.DamagedLog) as caught:
        tumble.replay(torn)
    assert "torn" in caught.value.message and caught.value.exit_code == 3
    assert caught.value.report["identical"] and caught.value.report["steps"] == log.last_step


def test_the_program_must_be_of_the_same_version(monkeypatch, tmp_path):
    other = tmp_path / "tumble"
    other.write_text("#!/bin/sh\necho tumble 0.0.1\n")
    other.chmod(0o755)
    monkeypatch.setenv("TUMBLE_PROGRAM", str(other))
    with pytest.raises(tumble.CannotFinish, match=f"wanted version {tumble.__version__}"):
        tumble.measure("x.tumble")
    monkeypatch.setenv("TUMBLE_PROGRAM", str(tmp_path / "none"))
    with pytest.raises(tumble.CannotFinish, match="cannot be run"):
        tumble.measure("x.tumble")


def test_a_log_without_a_path_is_named_after_the_case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert tumble.record("tower", steps=2).log == "tower.tumble"
    (tmp_path / "mine.toml").write_text("[[box]]\nposition = [0, 0, 2]\n")
    assert tumble.record("mine.toml", steps=2).log == "mine.tumble"
    assert repr(tumble.run("info", "mine.tumble")).startswith("<tumble.Answer, exit status 0: 'log ")


def test_what_is_no_dictionary_is_named(wall):
    with pytest.raises(tumble.BadInput, match="tolerance: found 'x', wanted a dictionary"):
        tumble.diff(wall, wall, tolerance="x")
    with pytest.raises(tumble.BadInput, match="set: found 7, wanted a dictionary"):
        tumble.record("tower", "t.tumble", set=7)
    for world in (lambda: tumble.World.from_scene("tower", set={"\ud800": 1}),
                  lambda: tumble.World.from_scene(tumble.Scene("\ud800"))):
        with pytest.raises(tumble.BadInput, match="wanted text of whole characters"):
            world()
