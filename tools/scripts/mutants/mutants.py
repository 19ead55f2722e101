"""Random mutants of src: does `tumble check` or `tumble hunt` notice a change of one token?

  python3 mutants.py draw --seed S --count N        draws N places and writes the list; nothing is picked by hand
  python3 mutants.py run --tree DIR [--take K/N]    plants, builds and judges mutants that have no verdict yet
  python3 mutants.py table                          how many were caught, by what, and which were missed

`draw` takes each token of src that can change with equal chance, but no comments, texts and lines of the preprocessor.
A mutant that does not compile counts nowhere; one that changes nothing that anybody could see counts as missed.

`run` edits DIR, a checkout of this repository made for the purpose (git worktree add DIR), and puts each file back. It
builds target tumble in DIR/build/mutants and asks, until one notices: some short cases of `check`, the whole `check`,
`hunt`, but not for src/render, which no hunt runs. `hunt` notices where a scene breaks a relation or law that it does
not break without the mutant; --scenes is as many as two minutes of an idle machine judge. For a mutant that `check`
passes, 1,000 scenes of `hunt --against` the program without the mutant say whether it moves a bit; where it moves none,
100 scenes are hunted, for what threads, lanes and logs do. A mutant whose program is the same to the byte is missed.
Mutants are asked in the order drawn. --take K/N runs every N-th mutant, --missed those again that were missed,
--numbers N,N those alone. Ctrl-C ends it at any time. The list and the verdicts are tests/mutants/mutants.jsonl, by
number; --list FILE, before the command, is another.
"""
import argparse
import hashlib
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
list_file = ROOT / "tests/mutants/mutants.jsonl"
CANNOT_BUILD = "does not compile"
# A hunt draws no picture: only check can notice these.
NO_HUNT = ("src/render/",)
# Short cases of both methods that between them run every phase: most mutants fail one of them within seconds.
SHORT = ["bounce", "freeze_and_wake", "size_ratio", "stacks", "thesis_free_spin", "thesis_inputs", "tower",
         "layered_bounce", "layered_bullets", "layered_free_hits", "layered_inputs", "layered_leaning",
         "layered_mass_graded", "layered_sleep", "layered_slide", "layered_table", "layered_tower_5"]

SWAPS = {
    "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["/"], "<": ["<=", ">"], "<=": ["<", ">"], ">": [">=", "<"],
    ">=": [">", "<"], "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"], "+=": ["-="], "-=": ["+="],
    "*=": ["/="], "/=": ["*="], "++": ["--"], "--": ["++"], "!": [""], "|=": ["&="], "&=": ["|="], "<<": [">>"],
    ">>": ["<<"], "true": ["false"], "false": ["true"], "min": ["max"], "max": ["min"], "x": ["y"], "y": ["z"],
    "z": ["x"], "break": ["continue"], "continue": ["break"],
}
TOKEN = re.compile(r"""(?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"
    |'(?:\\.|[^'\\\n])+')|(?P<number>(?<![\w.])(?:0x[0-9a-fA-F']+|\d[\d']*(?:\.\d*)?(?:[eE][+-]?\d+)?)[uUlLfF]*)
    |(?P<word>[A-Za-z_]\w*)|(?P<sign><=>|->|::|<<=|>>=|<<|>>|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|\|=|&=|\+\+|--|[-+*/%<>!])""",
                   re.VERBOSE | re.DOTALL | re.MULTILINE)
BINARY = {"+", "-", "*", "/", "%", "<", ">", "<=", ">=", "==", "!=", "&&", "||", "<<", ">>"}


def numbers_near(token):
    digits = token.rstrip("uUlLfF")
    tail = token[len(digits):]
    if re.fullmatch(r"\d+", digits):
        value = int(digits)
        return [str(value + 1) + tail] + ([str(value - 1) + tail] if value > 0 else [])
    if re.search(r"[.eE]", digits) and not digits.startswith("0x"):
        value = float(digits.replace("'", ""))
        return [repr(value * 2) + tail, repr(value / 2) + tail] if value != 0 else ["1.0" + tail]
    return []


def places_in(file):
    text = file.read_text()
    for match in TOKEN.finditer(text):
        kind, token, at = match.lastgroup, match.group(), match.start()
        before, after = text[at - 1:at], text[match.end():match.end() + 1]
        if kind == "number":
            choices = numbers_near(token)
        elif kind == "sign":
            # The layout of clang-format tells operators from templates, pointers and references.
            spaced = before.isspace() and after.isspace()
            choices = SWAPS.get(token, []) if spaced or token not in BINARY else []
            choices = [] if token == "!" and after in " =" else choices
        elif kind == "word":
            choices = SWAPS.get(token, [])
            no_axis = token in "xyz" and before not in "."
            if no_axis or (token in ("min", "max") and after not in "(<"):
                choices = []
        else:
            continue
        if choices:
            line = text.count("\n", 0, at) + 1
            start = text.rfind("\n", 0, at) + 1
            yield line, at - start + 1, token, choices, text[start:text.find("\n", at)].strip()


def read_list():
    head, *rows = (json.loads(line) for line in list_file.read_text().splitlines())
    return head, rows  # what the list is, and its mutants


def write_list(head, rows):
    list_file.parent.mkdir(parents=True, exist_ok=True)
    list_file.with_suffix(".new").write_text("".join(json.dumps(row) + "\n" for row in [head, *rows]))
    list_file.with_suffix(".new").replace(list_file)


def commit():
    return subprocess.check_output(["git", "-C", str(ROOT), "rev-parse", "--short=12", "HEAD"], text=True).strip()


def draw(options):
    files = sorted(p for p in (ROOT / "src").rglob("*") if p.suffix in (".cc", ".h"))
    places = [(file, *place) for file in files for place in places_in(file)]
    chance = random.Random(options.seed)
    rows = []
    for number, (file, line, column, was, choices, text) in enumerate(chance.sample(places, options.count)):
        rows.append({"number": number, "file": str(file.relative_to(ROOT)), "line": line, "column": column, "was": was,
                     "is": chance.choice(choices), "text": text, "verdict": None, "by": None, "moves_bits": None})
    write_list({"seed": options.seed, "count": options.count, "places": len(places), "commit": commit()}, rows)
    print(f"{len(rows)} mutants of {len(places)} places: {list_file.relative_to(ROOT)}")


def quiet(words, log, cwd, limit):
    """Exit status of a command. subprocess.TimeoutExpired: it took longer than the limit, in s."""
    with open(log, "w") as out:
        child = subprocess.Popen(words, stdout=out, stderr=subprocess.STDOUT, cwd=cwd, start_new_session=True)
        try:
            return child.wait(limit)
        finally:
            if child.poll() is None:
                os.killpg(child.pid, signal.SIGKILL)
                child.wait()


class Judge:
    def __init__(self, options):
        self.tree = pathlib.Path(options.tree).resolve()
        self.options = options
        self.build = self.tree / "build/mutants"
        self.program = self.build / "tools/tumble"
        self.work = self.tree / "build/mutants-work"
        self.work.mkdir(parents=True, exist_ok=True)
        self.good = self.work / "tumble"

    def make(self):
        return quiet(["cmake", "--build", str(self.build), "--target", "tumble", "--parallel", str(self.options.jobs)],
                     self.work / "build.log", self.tree, 3600) == 0

    def findings(self, program, scenes, log):
        """Scenes and relations that break; None where the hunt did not end."""
        words = [str(program), "hunt", "--count", str(scenes), "--unshrunk", "--json", "--threads", str(self.options.jobs)]
        status = quiet(words, log, self.tree, 3600)
        try:
            found = json.loads(log.read_text())["findings"]
        except (ValueError, KeyError):
            return None
        return {(one["number"], one["relation"]) for one in found} if status in (0, 1) else None

    def prepare(self):
        if not (self.build / "CMakeCache.txt").exists():
            words = ["-DCMAKE_BUILD_TYPE=Release", "-DTUMBLE_TESTS=OFF"]
            status = quiet(["cmake", "-S", str(self.tree), "-B", str(self.build), "-G", "Ninja", *words],
                           self.work / "configure.log", self.tree, 600)
            if status != 0:
                sys.exit(f"mutants: {self.tree} cannot be configured: {self.work / 'configure.log'}")
        if not self.make():
            sys.exit(f"mutants: {self.tree} does not build without a mutant: {self.work / 'build.log'}")
        self.good.write_bytes(self.program.read_bytes())
        self.good.chmod(0o755)
        if self.check(SHORT) != 0:
            sys.exit(f"mutants: check fails without a mutant: {self.work / 'check.log'}")
        self.mark = hashlib.sha256(self.good.read_bytes()).hexdigest()[:16]

    def stages(self):
        return sorted({min(n, self.options.scenes) for n in (100, 1000, self.options.scenes)})

    def known(self, scenes):
        """What the program without a mutant breaks; kept from run to run."""
        kept = self.work / f"known-{self.mark}-{scenes}.json"
        if not kept.exists():
            new = kept.with_suffix(".new")
            if self.findings(self.good, scenes, new) is None:
                sys.exit(f"mutants: the hunt does not end without a mutant: {new}")
            new.replace(kept)
        return {(one["number"], one["relation"]) for one in json.loads(kept.read_text())["findings"]}

    def check(self, cases):
        return quiet([str(self.program), "check", *cases, "--jobs", str(self.options.jobs)], self.work / "check.log",
                     self.tree, 1800)

    def moves_bits(self):
        """Whether 1,000 scenes have other bits than without the mutant."""
        status = quiet([str(self.program), "hunt", "--count", "1000", "--unshrunk", "--relation", "repeat", "--against",
                        str(self.good), "--json", "--threads", str(self.options.jobs)], self.work / "against.json",
                       self.tree, 1800)
        return status != 0

    def judge(self, row):
        """verdict, by, bits."""
        if not self.make():
            return CANNOT_BUILD, None, None
        if self.program.read_bytes() == self.good.read_bytes():
            return "missed", None, False
        if self.check(SHORT) != 0 or self.check([]) != 0:
            return "caught", "check", None
        if row["file"].startswith(NO_HUNT):
            return "missed", None, False
        bits = self.moves_bits()
        for scenes in self.stages() if bits else self.stages()[:1]:
            found = self.findings(self.program, scenes, self.work / "hunt.json")
            new = None if found is None else sorted(found - self.known(scenes))
            if new is None:
                return "caught", "hunt: does not end", bits
            if new:
                return "caught", f"hunt: {new[0][1]}, scene {new[0][0]}", bits
        return "missed", None, bits

    def run(self, row):
        file = self.tree / row["file"]
        original = file.read_text()
        lines = original.split("\n")
        column = row["column"] - 1
        # Lines above it may have come or gone since the list was drawn.
        places = [k for k, line in enumerate(lines) if line.strip() == row["text"] and line[column:].startswith(row["was"])]
        if not places:
            return "the line has changed", None, None
        line = lines[at := min(places, key=lambda k: abs(k - (row["line"] - 1)))]
        lines[at] = line[:column] + row["is"] + line[column + len(row["was"]):]
        try:
            file.write_text("\n".join(lines))
            return self.judge(row)
        except subprocess.TimeoutExpired as late:  # as on a busy machine, which tells nothing
            return None, f"no end in {late.timeout} s: {late.cmd[1]}", None
        finally:
            file.write_text(original)


def run(options):
    judge = Judge(options)
    judge.prepare()
    part, parts = (int(word) for word in options.take.split("/"))
    wanted = "missed" if options.missed else None
    numbers = options.numbers.split(",") if options.numbers else None
    mine = [row for row in read_list()[1] if row["verdict"] == wanted and row["number"] % parts == part % parts
            and (numbers is None or str(row["number"]) in numbers)]
    for row in mine:
        begin = time.time()
        verdict, by, bits = judge.run(row)
        head, rows = read_list()
        judged = next(one for one in rows if one["number"] == row["number"])
        judged.update(verdict=verdict, by=by, moves_bits=bits)
        write_list(head, rows)
        print(f"{row['number']:>4} {row['file']}:{row['line']} \"{row['was']}\" is \"{row['is']}\": {verdict} {by} {bits}"
              f" ({time.time() - begin:.0f} s)", flush=True)


def table(_):
    head, rows = read_list()
    print(f"seed {head['seed']}, {head['places']} places of commit {head['commit']}")
    judged = [row for row in rows if row["verdict"] in ("caught", "missed")]
    by_check = sum(row["by"] == "check" for row in judged)
    by_hunt = sum((row["by"] or "").startswith("hunt") for row in judged)
    passed = [row for row in judged if row["by"] != "check"]
    moved = [row for row in passed if row["moves_bits"]]
    print(f"{len(rows)} mutants drawn, {sum(row['verdict'] == CANNOT_BUILD for row in rows)} do not compile,"
          f" {len(judged)} judged")
    if judged:
        print(f"caught by check {by_check}, by hunt alone {by_hunt}, missed {len(judged) - by_check - by_hunt}:"
              f" {100 * (by_check + by_hunt) / len(judged):.1f} % caught, {100 * by_check / len(judged):.1f} % by check")
    print(f"of {len(moved)} that check passes although they move a bit, relations and laws caught"
          f" {sum(row['verdict'] == 'caught' for row in moved)}")
    for row in judged:
        if row["by"] != "check":
            print(f"{row['number']:>4} {row['verdict']} {row['by']} {row['file']}:{row['line']}: \"{row['was']}\" is"
                  f" \"{row['is']}\": {row['text']}; bits moved: {row['moves_bits']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", default=list_file)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("draw")
    for name in "--seed", "--count":
        one.add_argument(name, type=int, required=True)
    one.set_defaults(act=draw)
    one = commands.add_parser("run")
    one.add_argument("--tree", required=True)
    one.add_argument("--take", default="0/1", metavar="K/N")
    for name, usual in (("--scenes", 5000), ("--jobs", 2)):
        one.add_argument(name, type=int, default=usual)
    one.add_argument("--missed", action="store_true")
    one.add_argument("--numbers", metavar="N,N")
    one.set_defaults(act=run)
    commands.add_parser("table").set_defaults(act=table)
    options = parser.parse_args()
    globals()["list_file"] = ROOT / options.list
    options.act(options)


if __name__ == "__main__":
    main()
