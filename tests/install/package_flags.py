"""No command that compiles a package holds the folder of the build but where it names a file, so that two builds of one
commit in two folders give the same bytes. tools/scripts/packages/reproduce.sh shows that in full, and takes two builds.

Usage: tests/install/package_flags.py CMAKE SOURCE        status 1: a flag that holds the folder
"""
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

# Flags behind which a file or folder stands, and those that take folders out of the result.
PLACES = ("-I", "-isystem", "-include", "-iquote", "-o", "-c", "-MF", "-MT", "-MD")
MAPS = ("-ffile-prefix-map=", "-fmacro-prefix-map=")


def holding(words, folders):
    """The flags of a command that hold a folder and name no file."""
    found, is_place = [], False
    for word in words:
        if not is_place and not word.startswith((*PLACES, *MAPS)) and any(folder in word for folder in folders):
            found.append(word)
        is_place = word in PLACES
    return found


def main(cmake, source):
    with tempfile.TemporaryDirectory() as name:
        build = str(pathlib.Path(name).resolve())
        done = subprocess.run([cmake, "--preset", "package", "-B", build], cwd=source, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"package_flags: cmake --preset package: {done.stderr}")
        commands = json.loads(pathlib.Path(build, "compile_commands.json").read_text(encoding="utf-8"))
    wrong = set()
    for command in commands:
        words = shlex.split(command["command"])
        wrong |= {f"{pathlib.Path(command['file']).name}: {flag}" for flag in holding(words, (source, build))}
        if not any(word.startswith(MAPS) for word in words):
            wrong.add(f"{pathlib.Path(command['file']).name}: no flag that takes the folder out of __FILE__")
    print("\n".join(sorted(wrong)) or f"package_flags: {len(commands)} commands hold no folder")
    return 1 if wrong or not commands else 0


sys.exit(main(sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve())))
