"""The program `tumble`: found, run, and its JSON read."""

import difflib
import functools
import json
import os
import pathlib
import shutil
import signal
import subprocess

from . import _tumble
from ._errors import BY_EXIT_CODE, BadInput, CannotFinish

_HERE = pathlib.Path(__file__).resolve().parent


def program():
    """The path of the program `tumble` that belongs to this package: that of TUMBLE_PROGRAM, the one inside the
    package, the one of the same installation, or the first in PATH. Raises CannotFinish where there is none, and where
    it is of another version than the package."""
    given = os.environ.get("TUMBLE_PROGRAM")
    found = given or _first_program()
    if found is None:
        raise CannotFinish(
            "the program tumble is not installed: install the package tumble, or name it in TUMBLE_PROGRAM"
        )
    _check_version(found)
    return found


def _first_program():
    places = [_HERE / "_program" / "bin" / "tumble"]
    try:
        from ._place import PROGRAM  # in a build folder

        places.append(pathlib.Path(PROGRAM))
    except ImportError:
        pass
    places += [folder / "bin" / "tumble" for folder in list(_HERE.parents)[1:5]]
    for place in places:
        if os.access(place, os.X_OK) and place.is_file():
            return str(place)
    return shutil.which("tumble")


@functools.lru_cache(maxsize=8)
def _check_version(path):
    try:
        said = subprocess.run([path, "--version"], capture_output=True, text=True, check=False, timeout=60).stdout
    except (OSError, subprocess.SubprocessError) as error:
        raise CannotFinish(f"{path}: cannot be run: {error}") from None
    if said.split() != ["tumble", _tumble.version]:
        raise CannotFinish(f"{path}: found {said.strip()!r}, wanted version {_tumble.version}, that of the package")


class Answer:
    """What the program said: exit status, standard output and standard error."""

    def __init__(self, code, out, err):
        self.code = code
        self.out = out
        self.err = err

    def __repr__(self):
        first = next(iter((self.out or self.err).splitlines()), "")
        return f"<tumble.Answer, exit status {self.code}: {first!r}>"


def run(*words, cwd=None):
    """Runs the program with these arguments and returns its `Answer`. Raises an `Error` with the program's text for
    exit status 2, 3 and 4. Ctrl-C interrupts the program too, which then completes the log that it writes."""
    answer = _run([os.fsdecode(word) if isinstance(word, (str, bytes, os.PathLike)) else str(word) for word in words],
                  cwd)
    if answer.code in (0, 1):
        return answer
    raise _error_of(answer)


def _run(words, cwd=None):
    if any("\0" in word for word in words):
        raise BadInput("found a zero byte in an argument, wanted text")
    with subprocess.Popen([program(), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, cwd=cwd, start_new_session=True) as child:
        try:
            out, err = child.communicate()
        except BaseException:
            _end(child)
            raise
    return Answer(child.returncode, out.decode("utf-8", "replace"), err.decode("utf-8", "replace"))


def _end(child):
    """Asks the program to complete what it writes and end, and makes it end after ten seconds. Not by SIGINT, which a
    program in the background of a shell ignores."""
    child.send_signal(signal.SIGTERM)
    try:
        child.communicate(timeout=10)
    except subprocess.TimeoutExpired:
        child.kill()
        child.communicate()


def _error_of(answer):
    lines = [line for line in answer.err.strip().splitlines() if line]
    who = "tumble "
    text = "\n".join(lines) or "the program said nothing"
    if text.startswith(who) and ": " in text:
        text = text.split(": ", 1)[1]
    if answer.code < 0:
        return CannotFinish(f"the program was ended by signal {-answer.code}: {text}")
    return BY_EXIT_CODE.get(answer.code, CannotFinish)(text)


def ask(*words):
    """The JSON that a command prints, and its `Answer`. A report of a damaged or torn log is the attribute ``report`` of
    the DamagedLog that is raised."""
    answer = _run([*words, "--json"])
    report = None
    if answer.code in (0, 1) or (answer.code == 3 and answer.out.lstrip().startswith(("{", "["))):
        try:
            report = json.loads(answer.out)
        except ValueError as error:
            raise CannotFinish(f"{words[0]}: the program's JSON cannot be read: {error}") from None
    if answer.code in (0, 1):
        return report, answer
    error = _error_of(answer)
    error.report = report
    raise error


def path_text(path, what):
    """A path as an argument that no option is mistaken for."""
    try:
        text = os.fsdecode(path)
    except TypeError:
        raise BadInput(f"{what}: found {path!r}, wanted a path") from None
    return os.path.join(".", text) if text.startswith("-") else text


def scene_file(scene):
    """The file of a scene: a path, or the name of a golden case."""
    text = path_text(scene, "scene")
    if os.path.isfile(text) or "/" in text or text.endswith(".toml"):
        return text
    cases = _cases(os.getcwd())
    if text in cases:
        return cases[text]
    near = difflib.get_close_matches(text, cases, 1)
    hint = f'; did you mean "{near[0]}"?' if near else ""
    raise BadInput(f'no scene "{text}": neither a file nor a golden case{hint}')


@functools.lru_cache(maxsize=8)
def _cases(folder):
    """The files of the golden cases that the program finds from this folder, by name."""
    return {row["name"]: os.path.join(folder, row["file"]) for row in ask("scenes")[0]}
