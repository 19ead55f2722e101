"""Validates what the commands print with --json against the schemas of schema/json, success and difference alike.

Usage: tests/outputs/json_schemas.py [--samples FOLDER] [TUMBLE]

TUMBLE: the program, build/release/tools/tumble unless said. --samples: keeps what the commands printed there. Every
command whose help names --json must have a schema and a sample, and every output name its schema. Further keys are allowed by a schema, so that readers of
an older one go on; here they are errors, so that no schema lags behind. Status 1: something does not fit; 77: skipped,
python3-jsonschema is missing (tools/setup.sh --with export).
"""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

try:
    import jsonschema
except ImportError:
    print("json_schemas: SKIPPED, python3-jsonschema is missing; run tools/setup.sh --with export", file=sys.stderr)
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "schema" / "json"
# Commands whose samples need what not every machine has: a display, other engines, minutes. Their schemas are judged
# where they can run; the reason is printed.
MAY_FAIL = {"render": "OpenGL", "bench": "a program of bench/peers"}

SMALL = """title = "three boxes"
category = "session"
[world]
method = "thesis"
dt = 0.016666666666666666
steps = 40
[[box]]
position = [0.0, 0.0, 0.7]
[[box]]
position = [0.1, 0.2, 2.0]
[[input]]
step = 5
kind = "throw"
position = [0.0, -3.0, 1.0]
velocity = [0.0, 6.0, 0.0]
"""
HEAD = "position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z"


def scene(case):
    return str(ROOT / "golden" / "cases" / case / "scene.toml")


def table(knee="0.5", at="1.5", engine="robot", step_12=""):
    lines = [f"# engine: {engine}", "# dt: 0.01", "# up: y", f"step,id,{HEAD},channel.knee,channel.word,world.seed,world.gait,_note"]
    for step in range(20):
        for body in ("hip", "shin"):
            x = step_12 if step_12 and step == 12 and body == "shin" else "0"
            angle = knee if step == 12 else f"0.{step + 10}"
            lines.append(f"{step},{body},{x},{at},{3 if body == 'hip' else 0},1,0,0,0,{angle},up,7,walk,x")
    return "\n".join(lines) + "\n"


def prepare(run, folder):
    def write(name, text):
        (folder / name).write_text(text, encoding="utf-8")

    write("small.toml", SMALL)
    write("other.toml", SMALL.replace("6.0", "6.5"))
    write("none.toml", SMALL.partition("[[input]]")[0])
    write("robot.csv", table())
    write("changed.csv", table(knee="0.75", step_12="0.001"))
    write("lost.csv", table(step_12="nan"))
    write("knee.csv", table(knee="0.75"))
    write("own.csv", table(engine="copy"))
    run("record", "small.toml", "-o", "a.tumble")
    run("record", "small.toml", "-o", "b.tumble")
    run("record", "other.toml", "-o", "c.tumble")
    run("record", "none.toml", "-o", "none.tumble")
    write("long.toml", SMALL.replace("steps = 40", "steps = 400"))
    run("record", scene("tilted_grid"), "-o", "grid.tumble", "--steps", "20")
    run("record", scene("tilted_grid"), "-o", "mirrored.tumble", "--steps", "20", "--mirror", "x")
    write("bounds.toml", "[[metric]]\nname = \"drift_max\"\nmax = 1\nwhy = \"near\"\n")
    run("record", scene("layered_brick_wall"), "-o", "wall.tumble", "--steps", "60")
    run("record", scene("layered_inputs"), "-o", "inputs.tumble", "--steps", "60")
    run("record", "long.toml", "-o", "long.tumble")
    run("record", "long.toml", "-o", "long2.tumble", "--set", "box.1.mass=1.5")
    for name in ("robot", "changed", "lost", "knee", "own"):
        run("import", f"{name}.csv", "-o", f"{name}.tumble")
    whole = (folder / "long.tumble").read_bytes()
    (folder / "torn.tumble").write_bytes(whole[: len(whole) * 3 // 4])
    damaged = bytearray(whole)
    damaged[len(whole) // 2] ^= 0x55
    (folder / "damaged.tumble").write_bytes(bytes(damaged))
    write("tumble.toml", "[engine]\nrun = \"cp own.csv {log}\"\n")
    # A suite of two cases, one of which fails.
    suite = folder / "golden"
    for case in ("tower", "bounce"):
        target = suite / "cases" / case
        target.mkdir(parents=True)
        for file in (ROOT / "golden" / "cases" / case).iterdir():
            (target / file.name).write_bytes(file.read_bytes())
        (suite / "cases" / "new").mkdir(exist_ok=True)
        if case == "tower":
            for file in ("scene.toml", "metrics.toml"):
                (suite / "cases" / "new" / file).write_bytes((target / file).read_bytes())
    text = suite / "cases" / "bounce" / "scene.toml"
    text.write_text(text.read_text(encoding="utf-8").replace("steps = ", "steps = 1"), encoding="utf-8")


# Each: the words of a command line; --json is added.
SAMPLES = {
    "record": [["small.toml", "-o", "r.tumble"], [scene("layered_tower_5"), "-o", "r.tumble", "--steps", "9"],
               [scene("layered_inputs"), "-o", "r.tumble", "--steps", "9", "--states", "every:4"]],
    "replay": [["a.tumble"], ["wall.tumble"], ["torn.tumble"], ["own.tumble"],
               [str(ROOT / "tests" / "data" / "format_1.0_thesis.tumble")],
               [str(ROOT / "tests" / "data" / "format_1.1_layered.tumble")]],
    "recover": [["torn.tumble", "-o", "whole.tumble"], ["damaged.tumble", "-o", "whole2.tumble"]],
    "diff": [["a.tumble", "b.tumble"], ["a.tumble", "c.tumble"], ["a.tumble", "c.tumble", "--step", "20"],
             ["a.tumble", "b.tumble", "c.tumble"], ["robot.tumble", "changed.tumble"], ["robot.tumble", "lost.tumble"],
             ["robot.tumble", "robot.tumble"], ["robot.tumble", "knee.tumble"],
             ["robot.tumble", "robot.tumble", "knee.tumble"], ["robot.tumble", "changed.tumble", "--step", "12"],
             ["robot.tumble", "lost.tumble", "--step", "12"], ["a.tumble", "none.tumble", "--step", "10"],
             ["a.tumble", "robot.tumble"], ["long.tumble", "torn.tumble"], ["a.tumble", "c.tumble", "--brief"],
             ["a.tumble", "c.tumble", "--tolerance", "position=100", "--tolerance", "velocity=100"]],
    "blame": [["wall.tumble", "--body", "1", "--field", "position.x"], ["wall.tumble", "--body", "5", "--field", "velocity.z",
              "--back", "4"], ["a.tumble", "--body", "3", "--field", "velocity.y", "--back", "5"],
              ["a.tumble", "--body", "1", "--contacts", "--step", "30"], ["wall.tumble", "--body", "30", "--contacts"]],
    "info": [["a.tumble"], ["torn.tumble"], ["damaged.tumble"], ["robot.tumble"], ["lost.tumble"], ["inputs.tumble"]],
    "measure": [["a.tumble"], ["wall.tumble"], ["robot.tumble"], ["lost.tumble"], ["inputs.tumble", "--bodies", "1-3"],
                ["grid.tumble", "--with", "mirrored.tumble"], ["robot.tumble", "changed.tumble", "lost.tumble"],
                ["robot.tumble", "changed.tumble", "--bounds", "bounds.toml"]],
    "dump": [["a.tumble", "--step", "7"], ["a.tumble", "--steps", "0:3"], ["robot.tumble", "--step", "12"],
             ["lost.tumble", "--step", "12"], ["a.tumble", "--steps", "3:4", "--body", "1"]],
    "render": [["a.tumble", "-o", "a.png", "--size", "64x48"], ["a.tumble", "-o", "pictures", "--every", "20", "--size", "64x48"]],
    "check": [["tower", "--report", "report"], ["--report", "report2", "--suite", "golden"], ["tower", "--require", "exact",
              "--report", "report3"], ["tower", "--heavy", "--report", "report4"],
              ["tower", "--shard", "2/200", "--report", "report5"]],
    "bisect": [["a.tumble", "c.tumble"], ["a.tumble", "b.tumble"]],
    "bless": [["--dry-run", "--suite", "golden", "--reason", "none", "new"], ["--dry-run", "--suite", "golden", "--reason",
              "none", "tower"]],
    "import": [["robot.csv", "-o", "i.tumble"], ["a.npz", "-o", "i.tumble"], ["lost.csv", "-o", "i.tumble"]],
    "bench": [["scaling", "--budget", "1"], ["table1", "--budget", "1"], ["memory", "--scene", "tower"],
              ["export", "--scene", "grid_3"]],
    "scenes": [[]],
    "hunt": [["--count", "2", "--relation", "energy", "--folder", "hunt"], ["--relations"],
             ["--judge", str(ROOT / "tests" / "data" / "hunt_known"), "--relation", "energy"],
             ["--count", "1", "--relation", "repeat"],
             ["--corpus", "sum", "--merge", str(ROOT / "tests" / "data" / "hunt_known")]],
    # The second is closed by Ctrl-C, as a person does; the first closes itself.
    "live": [["small.toml", "-o", "live.tumble", "--size", "160x120", "--measure", "2"],
             ["small.toml", "-o", "by_hand.tumble", "--size", "160x120"], ["--from", "a.tumble:20", "--size", "160x120"]],
    "export": [["a.tumble", "-o", "a.npz"], ["robot.tumble", "-o", "robot.csv.csv", "--every", "3"], ["a.tumble", "-o", "a.glb"]],
}


def commands_with_json(tumble):
    overview = subprocess.run([tumble, "help"], capture_output=True, text=True, check=True).stdout
    names = [line.split()[0] for line in overview.split("Commands:")[1].split("\n\n")[0].strip().splitlines()]
    return [name for name in names if "--json" in subprocess.run([tumble, name, "--help"], capture_output=True, text=True,
                                                                  check=True).stdout]


@contextlib.contextmanager
def display(tumble):
    """Gives windows a display of their own. Yields why there can be none; empty: there is one."""
    if not os.access(tumble + "-live", os.X_OK):
        yield "this build has no window (tools/setup.sh --only live)"
    elif shutil.which("Xvfb") is None:
        yield "Xvfb is missing (tools/setup.sh --only live)"
    else:
        server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "320x240x24", "-nolisten", "tcp", "-noreset"],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            number = server.stdout.readline().strip()
            os.environ["DISPLAY"] = ":" + number
            yield "" if number else f"Xvfb gives no display: {server.stderr.read().strip()}"
        finally:
            server.terminate()
            server.communicate()


def play(words, folder, log):
    """Plays until the log has steps, then closes the window as Ctrl-C does."""
    with subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as window:
        while window.poll() is None and not (log.exists() and log.stat().st_size > 0):
            time.sleep(0.05)
        time.sleep(0.5)
        window.send_signal(signal.SIGINT)
        out, err = window.communicate()
        return subprocess.CompletedProcess(words, window.returncode, out, err)


def strict(schema):
    """The schema with every object closed."""
    if isinstance(schema, list):
        return [strict(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    closed = {key: strict(value) for key, value in schema.items()}
    if "properties" in schema and "additionalProperties" not in schema:
        closed["additionalProperties"] = False
    return closed


def unspecific(schema, place=""):
    """The places of a schema that any value, any list or any object fits, and that do not say why."""
    if isinstance(schema, list):
        return [found for number, part in enumerate(schema) for found in unspecific(part, f"{place}/{number}")]
    if not isinstance(schema, dict):
        return []
    lacks = {"array": "items", "object": "properties"}
    kinds = schema.get("type", [])
    kinds = [kinds] if isinstance(kinds, str) else kinds
    is_any = schema == {} or any(kind in lacks and lacks[kind] not in schema and "additionalProperties" not in schema
                                 for kind in kinds)
    found = [place] if is_any and "description" not in schema else []
    return found + [one for key, part in schema.items() if key != "const" for one in unspecific(part, f"{place}/{key}")]


def named_by(value):
    """The names of schemas that an output gives: its own, or those of its items."""
    items = value if isinstance(value, list) else [value]
    return {item.get("schema") if isinstance(item, dict) else None for item in items}


def main(words):
    kept = None
    if words[:1] == ["--samples"]:
        kept, words = pathlib.Path(words[1]).resolve(), words[2:]
        kept.mkdir(parents=True, exist_ok=True)
    tumble = os.path.realpath(words[0] if words else ROOT / "build" / "release" / "tools" / "tumble")
    wrong = []
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()))

        def run(*arguments):
            return subprocess.run([tumble, *arguments], cwd=folder, capture_output=True, text=True, check=False)

        prepare(run, folder)
        def run_live(arguments):
            if "--measure" in arguments:
                return run("live", *arguments, "--json")
            log = folder / (arguments[arguments.index("-o") + 1] if "-o" in arguments else "a_from_20.tumble")
            return play([tumble, "live", *arguments, "--json"], folder, log)

        why_no_window = stack.enter_context(display(tumble))
        if why_no_window:
            print(f"json_schemas: SKIPPED the samples of live: {why_no_window}", file=sys.stderr)
        # The archive that import reads is what export writes first.
        order = ["export"] + [command for command in SAMPLES if command != "export"]
        seen = {}
        for command in order:
            if command == "live" and why_no_window:
                continue
            for number, arguments in enumerate(SAMPLES[command]):
                done = run_live(arguments) if command == "live" else run(command, *arguments, "--json")
                about = f"tumble {command} {' '.join(arguments)} --json"
                if done.returncode not in (0, 1, 3) or not done.stdout.strip():
                    if command in MAY_FAIL:
                        print(f"json_schemas: left out, needs {MAY_FAIL[command]}: {about}", file=sys.stderr)
                    else:
                        wrong.append(f"{about}: status {done.returncode}: {done.stderr.strip()}")
                    continue
                seen.setdefault(command, []).append((about, json.loads(done.stdout)))
                if kept:
                    (kept / f"{command}.{number}.json").write_text(done.stdout, encoding="utf-8")
    with_json = commands_with_json(tumble)
    for command in with_json:
        path = SCHEMAS / f"{command}.schema.json"
        if not path.exists():
            wrong.append(f"tumble {command}: found no {path.relative_to(ROOT)}, wanted one, for it has --json")
            continue
        schema = json.loads(path.read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)
        wrong += [f"{path.relative_to(ROOT)}: {place}: anything fits, wanted what the command prints"
                  for place in unspecific(schema)]
        judge = jsonschema.Draft202012Validator(strict(schema))
        for about, value in seen.get(command, []):
            if named_by(value) != {schema["$id"]}:
                wrong.append(f"{about}: found the schema {named_by(value)}, wanted {schema['$id']}")
            for error in judge.iter_errors(value):
                place = "/".join(str(part) for part in error.absolute_path)
                wrong.append(f"{about}: at {place or 'the top'}: {error.message[:300]}")
        if command not in seen and command not in MAY_FAIL and not (command == "live" and why_no_window):
            wrong.append(f"tumble {command}: no sample")
    for path in SCHEMAS.glob("*.schema.json"):
        if path.name.removesuffix(".schema.json") not in with_json:
            wrong.append(f"{path.relative_to(ROOT)}: no command of this name has --json")
    print("\n".join(wrong) if wrong else f"json_schemas: {sum(map(len, seen.values()))} outputs of {len(seen)} commands fit")
    return 1 if wrong else 0


sys.exit(main(sys.argv[1:]))
