"""The examples run as they stand."""

import os
import subprocess
import sys

import pytest

import tumble
from conftest import TREE

EXAMPLES = TREE / "examples" / "python"


def run(name, *words, cwd):
    done = subprocess.run([sys.executable, EXAMPLES / name, *words], cwd=cwd, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_every_example_is_tested():
    assert {path.name for path in EXAMPLES.glob("*.py")} == {
        "parameter_sweep.py", "convergence.py", "tiny_engine.py", "plot_a_difference.py"}


def test_parameter_sweep(tmp_path):
    lines = run("parameter_sweep.py", cwd=tmp_path).splitlines()
    assert lines[0].split() == ["friction", "slid,", "m", "speed,", "m/s"] and len(lines) == 7
    slid = [float(line.split()[1]) for line in lines[1:]]
    assert slid == sorted(slid, reverse=True) and slid[0] == 6.0 and abs(slid[-1] - 9 / (2 * 0.8 * 9.81)) < 2e-3


def test_convergence(tmp_path):
    lines = run("convergence.py", cwd=tmp_path).splitlines()
    ratios = [float(line.split()[2]) for line in lines[2:]]
    assert len(ratios) == 4 and all(3.5 < ratio < 4.5 for ratio in ratios), "wanted second order"


def test_tiny_engine(tmp_path):
    run("tiny_engine.py", "ball.tumble", cwd=tmp_path)
    log = tumble.Log(tmp_path / "ball.tumble")
    assert log.last_step == 300 and log.whole and set(log.channels) == {"bounces", "energy"}
    assert log.channels["bounces"][300]["value"][0] > 1
    lines = (EXAMPLES / "tiny_engine.py").read_text().split("# The engine")[1].splitlines()
    assert len([line for line in lines[1:] if line.strip()]) <= 14


def test_plot_a_difference(tmp_path):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed (python3-matplotlib)")
    os.environ["MPLBACKEND"] = "Agg"
    said = run("plot_a_difference.py", cwd=tmp_path)
    assert "first different step" in said and (tmp_path / "difference.png").stat().st_size > 10_000
