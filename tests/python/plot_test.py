"""Plots, where matplotlib is installed; each is drawn and has lines in it."""

import pytest

import tumble
import tumble.plot
from conftest import CASES

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed (python3-matplotlib)")
matplotlib.use("Agg")


def test_plots(wall, session_folder, tmp_path):
    other = session_folder / "other.tumble"
    tumble.record(CASES / "layered_inputs" / "scene.toml", other, steps=80, set={"world.gravity": (0, 0, -9.8)})
    for axes in (tumble.plot.energy(wall), tumble.plot.heights(tumble.Log(wall), [1, 2]),
                 tumble.plot.separation(wall, other)):
        assert len(axes.get_lines()[0].get_xdata()) > 10, "nothing is drawn"
        assert axes.get_xlabel() and axes.get_ylabel()
        axes.figure.savefig(tmp_path / "plot.png")
        assert (tmp_path / "plot.png").stat().st_size > 5000
    given = tumble.plot.energy(wall, axes=axes)
    assert given is axes


def with_a_late_body(path, offset):
    """Two bodies rest; a third comes in step 4, goes in step 8, and moves by `offset` more each step."""
    bodies = [dict(id=1, position=(0, 0, 1)), dict(id=2, position=(5, 0, 1))]
    with tumble.Recorder(path, engine="late", dt=0.01, bodies=bodies) as log:
        for k in range(1, 11):
            if k == 4:
                log.throw(id=9, position=(0, 3, 1))
            if k == 8:
                log.remove(9)
            places = [(0, 0, 1), (5, 0, 1)] + [(offset * k, 3, 1)] * (4 <= k < 8)
            log.step(position=places, velocity=[(0, 0, 0)] * len(places))


def test_separation_is_that_of_all_bodies_of_a_step(tmp_path):
    one, other = tmp_path / "one.tumble", tmp_path / "other.tumble"
    with_a_late_body(one, 0.0)
    with_a_late_body(other, 0.25)
    line = tumble.plot.separation(one, other).get_lines()[0]
    assert list(line.get_xdata()) == [4, 5, 6, 7]
    assert list(line.get_ydata()) == [1.0, 1.25, 1.5, 1.75], "as `diff` measures it"
    rows = tumble.diff(one, other).aftermath.steps
    assert [row.gap for row in rows if row.gap] == list(line.get_ydata())
