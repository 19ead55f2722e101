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
