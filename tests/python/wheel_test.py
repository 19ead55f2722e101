"""`pip wheel ./python` makes a wheel that works where nothing else of the tree is."""

import importlib.util
import os
import subprocess
import sys

import pytest

from conftest import TREE

BUILD = os.environ.get("TUMBLE_BUILD")


def run(*words, **more):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, **more)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout


@pytest.mark.skipif(not BUILD, reason="TUMBLE_BUILD names no build folder")
def test_wheel(tmp_path):
    for module in ("pip", "setuptools", "wheel", "venv"):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"python3-{module} is not installed")
    offline = {**os.environ, "PIP_NO_INDEX": "1", "PIP_CONFIG_FILE": os.devnull, "TUMBLE_BUILD": BUILD}
    offline.pop("PYTHONPATH", None)
    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv")
    python = tmp_path / "venv" / "bin" / "python"
    run(python, "-m", "pip", "wheel", TREE / "python", "--no-build-isolation", "--no-deps", "-w", tmp_path, env=offline)
    wheels = list(tmp_path.glob("tumble-*.whl"))
    assert len(wheels) == 1 and "none-any" not in wheels[0].name
    run(python, "-m", "pip", "install", "--no-deps", wheels[0], env=offline)
    script = (
        "import tumble, os; print(tumble.program());"
        "r = tumble.record('layered_bounce', 'x.tumble', steps=5); print(r.final_hash, tumble.replay('x.tumble').identical);"
        "print(tumble.Log('x.tumble').position[:].shape)"
    )
    said = run(python, "-c", script, cwd=tmp_path, env={**offline, "PATH": "/usr/bin:/bin"}).split("\n")
    assert said[0].startswith(str(tmp_path / "venv")) and said[1].endswith("True") and said[2].startswith("(6, ")
