"""Builds the wheel: CMake makes program, module and data, and setuptools packs them.

TUMBLE_BUILD: a folder where CMake has configured the tree already; it is then built there and not anew.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
TREE = HERE.parent


def version():
    return re.search(r"project\(tumble VERSION ([0-9.]+)", (TREE / "CMakeLists.txt").read_text())[1]


class BuildWithCMake(build_py):
    """Takes the package from `cmake --install` instead of from the source folder."""

    def run(self):
        given = os.environ.get("TUMBLE_BUILD")
        build = pathlib.Path(given or self.get_finalized_command("build").build_temp).resolve()
        if not given:
            options = ["-DCMAKE_BUILD_TYPE=Release", "-DTUMBLE_TESTS=OFF", "-DTUMBLE_LIVE=OFF",
                       f"-DPython_EXECUTABLE={sys.executable}"]
            subprocess.check_call(["cmake", "-S", TREE, "-B", build, "-G", "Ninja", *options])
        jobs = str(os.cpu_count() or 1)
        subprocess.check_call(["cmake", "--build", build, "--parallel", jobs, "--target", "tumble", "tumble_python"])
        package = pathlib.Path(self.build_lib).resolve() / "tumble"
        stage = build / "python" / "wheel"
        shutil.rmtree(stage, ignore_errors=True)
        subprocess.check_call(["cmake", "--install", build, "--component", "python", "--prefix", stage])
        self.copy_tree(str(self.only_package(stage)), str(package))
        # The program, with the scenes and golden cases that it finds beside itself.
        subprocess.check_call(
            ["cmake", "--install", build, "--component", "program", "--prefix", package / "_program"]
        )

    @staticmethod
    def only_package(stage):
        found = sorted(stage.rglob("tumble/__init__.py"))
        if len(found) != 1:
            raise SystemExit(f"setup.py: found {len(found)} packages below {stage}, wanted one; is pybind11 installed?")
        return found[0].parent


class WithModule(Distribution):
    """The wheel holds compiled code, so it is for one machine and one Python."""

    def has_ext_modules(self):
        return True


# Beside the build and not in the source folder.
WORK = pathlib.Path(os.environ.get("TUMBLE_BUILD") or TREE / "build").resolve() / "wheel"
WORK.mkdir(parents=True, exist_ok=True)
setup(
    version=version(),
    options={"build": {"build_base": str(WORK)}, "egg_info": {"egg_base": str(WORK)}},
    packages=["tumble"],
    package_dir={"": "."},
    distclass=WithModule,
    cmdclass={"build_py": BuildWithCMake},
)
