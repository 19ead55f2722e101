"""Splits a generated suite into shards, merges them, and compares with the check of the whole; then spoils shards.

Usage: python3 tools/scripts/checks/sharding_trial.py PROGRAM FOLDER [--cases 2000] [--shards 200] [--results 100000]

Three parts, each of which ends the trial with status 1 if it fails:
  merged    the merged report.json and junit.xml are those of the whole suite, apart from durations, dates and hosts
  spoiled   of 20 shards that are damaged, lost, doubled or foreign, each is named, and nothing else is
  large     so many made results, in as many shards, are merged; seconds and memory are printed
"""
import argparse
import ctypes
import ctypes.util
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

SCENE = """title = "two boxes fall"
category = "{category}"
[world]
method = "thesis"
dt = 0.016666666666666666
steps = {steps}
[[box]]
position = [0.0, 0.0, {height}]
[[box]]
position = [0.1, 0.2, 4.0]
spin = [0.5, 1.0, 0.0]
"""
RULES = """[[metric]]
name = "drift_max"
max = {most}
why = "they fall straight down"
"""


class Digest(ctypes.Structure):
    _fields_ = [("low", ctypes.c_uint64), ("high", ctypes.c_uint64)]


def xxh3(data: bytes) -> Digest:
    function = xxh3.library.XXH3_128bits
    function.restype = Digest
    function.argtypes = [ctypes.c_char_p, ctypes.c_size_t]
    return function(data, len(data))


xxh3.library = ctypes.CDLL(ctypes.util.find_library("xxhash") or "libxxhash.so.0")


def hexadecimal(data: bytes) -> str:
    digest = xxh3(data)
    return f"{digest.high:016x}{digest.low:016x}"


def shard_of(name: str, shards: int) -> int:
    """The rule of docs/sharding.md, computed by another program than ours."""
    return 1 + xxh3(name.encode()).low % shards


def sign(manifest: dict, folder: Path) -> None:
    body = json.dumps({k: v for k, v in manifest.items() if k != "hash"}, indent=1, ensure_ascii=False)[:-2]
    (folder / "bundle.json").write_text(f'{body},\n "hash": "{hexadecimal(body.encode())}"\n}}\n')


def run(*words, **more):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, **more)


def fail(message: str) -> None:
    print("FAILED  " + message)
    sys.exit(1)


def make_suite(program: Path, suite: Path, cases: int) -> None:
    for k in range(cases):
        folder = suite / "cases" / f"case_{k:05d}"
        folder.mkdir(parents=True)
        (folder / "scene.toml").write_text(
            SCENE.format(category=("stacking", "impact")[k % 2], steps=1 + k % 3, height=0.7 + k / 4096))
        (folder / "metrics.toml").write_text(RULES.format(most=100.0))
    blessed = run(program, "bless", "--suite", suite, *[f"case_{k:05d}" for k in range(cases)], "--reason", "a trial")
    if blessed.returncode != 0:
        fail("bless: " + blessed.stderr)
    for k in range(0, cases, 97):  # some fail: their bits move, or a metric is out of bounds
        folder = suite / "cases" / f"case_{k:05d}"
        (folder / "metrics.toml").write_text(RULES.format(most=-1.0))
        if k % 2:
            text = (folder / "scene.toml").read_text()
            (folder / "scene.toml").write_text(text.replace("spin = [0.5", "spin = [0.25"))


def comparable(folder: Path):
    report = json.loads((folder / "report.json").read_text())
    for key in ("seconds", "run", "folder"):
        del report[key]
    for case in report["cases"]:
        del case["seconds"]
    junit = re.sub(r' time="[^"]*"', "", (folder / "junit.xml").read_text())
    junit = re.sub(r'name="run" value="[^"]*"', "", junit)
    return report, re.sub(r' timestamp="[^"]*"', "", junit)


def part_merged(program: Path, work: Path, cases: int, shards: int) -> list:
    suite = work / "suite"
    make_suite(program, suite, cases)
    whole = run(program, "check", "--suite", suite, "--report", work / "whole")
    if whole.returncode != 1:
        fail(f"the whole suite: status {whole.returncode}, wanted 1: {whole.stderr}")
    bundles = []
    begin = time.time()
    for k in range(1, shards + 1):
        bundles.append(work / f"shard-{k}")
        one = run(program, "check", "--suite", suite, "--shard", "auto", "--report", bundles[-1],
                  env={**os.environ, "TUMBLE_SHARD": f"{k}/{shards}"})
        if one.returncode not in (0, 1):
            fail(f"shard {k}: status {one.returncode}: {one.stderr}")
        for name in json.loads((bundles[-1] / "bundle.json").read_text())["judged"]:
            if shard_of(name, shards) != k:
                fail(f"{name} is in shard {k}, wanted {shard_of(name, shards)}")
    print(f"        {shards} shards in {time.time() - begin:.0f} s")
    merged = run(program, "check", "--merge", *bundles, "--report", work / "merged")
    if merged.returncode != 1:
        fail(f"merge: status {merged.returncode}, wanted 1: {merged.stderr}")
    if comparable(work / "whole") != comparable(work / "merged"):
        fail("the merged report is not that of the whole suite")
    print(f"passed  merged: {cases} cases in {shards} shards")
    return bundles


def spoilers(whole: int):
    """20 of (what to do to a shard's folder, what the message must have)"""
    def edit(key, value):
        def change(folder):
            manifest = json.loads((folder / "bundle.json").read_text())
            where = manifest
            for part in key[:-1]:
                where = where[part]
            where[key[-1]] = value
            sign(manifest, folder)
        return change

    def flip(name):
        def change(folder):
            data = bytearray((folder / name).read_bytes())
            data[len(data) // 2] ^= 4
            (folder / name).write_bytes(data)
        return change

    def cut(name):
        def change(folder):
            data = (folder / name).read_bytes()
            (folder / name).write_bytes(data[:len(data) // 2])
        return change

    def link(folder):
        (folder / "report.json").rename(folder / "other.json")
        (folder / "report.json").symlink_to("other.json")

    return [
        (cut("report.json"), "report.json: found"), (cut("bundle.json"), "damaged: its end is missing"),
        (flip("report.json"), "its content has changed"), (flip("bundle.json"), "damaged: its text has the hash"),
        (lambda f: (f / "report.json").unlink(), "report.json: is missing"), (link, "is a link or no file"),
        (edit(["canaries"], ["a", "b", "c", "d", "e", "f", "g", "h", "i"]), "9 were asked, wanted the same canaries"),
        (edit(["judged"], ["nothing"]), "are judged, wanted the same cases"),
        (edit(["files"], [{"path": "../x", "bytes": 0, "hash": ""}]), "names the file"),
        (edit(["format"], 1), "found format 1, wanted 2"),
        (lambda f: (f / "bundle.json").unlink(), "holds no bundle.json"), (shutil.rmtree, "no such folder"),
        (None, "is missing"), (edit(["shard"], whole), "is there twice"),
        (edit(["shards"], 9999), "of another number of shards"), (edit(["run", "commit"], "f" * 40), "of another commit"),
        (edit(["facts", "program_hash"], "1" * 32), "of another program"),
        (edit(["facts", "suite_hash"], "2" * 32), "of another suite"),
        (edit(["facts", "selected_hash"], "3" * 32), "of another selection of cases"),
        (edit(["facts", "options", "require"], "image"), "of another set of options"),
    ]


def part_spoiled(program: Path, work: Path, bundles: list) -> None:
    kept = work / "spoiled"
    shutil.copytree(work, kept, symlinks=True, ignore=lambda at, names: [n for n in names if not n.startswith("shard-")]
                    if Path(at) == work else [])
    folders = [kept / b.name for b in bundles]
    given = list(folders)
    spoiled = [(3 + 9 * number) % len(folders) for number in range(20)]
    all_of_them = spoilers(1 + next(k for k in range(len(folders)) if k not in spoiled))
    for number, (change, _) in enumerate(all_of_them):
        folder = folders[spoiled[number]]
        if change is None:
            given = [g for g in given if g != folder]
        else:
            change(folder)
    merged = run(program, "check", "--merge", *given, "--report", work / "never")
    lines = merged.stderr.splitlines()
    if merged.returncode != 3:
        fail(f"spoiled: status {merged.returncode}, wanted 3: {merged.stderr}")
    for number, (_, words) in enumerate(all_of_them):
        k = 1 + spoiled[number]
        if not any(re.search(rf"shard[- ]{k}\b", line) and words in line
                   for line in lines):
            fail(f"shard {k}: nothing says \"{words}\" of it:\n{merged.stderr}")
    print(f"passed  spoiled: each of {len(all_of_them)} shards is named, in {len(lines) - 1} lines")


def part_large(program: Path, work: Path, bundle: Path, results: int, shards: int) -> None:
    report = json.loads((bundle / "report.json").read_text())
    manifest = json.loads((bundle / "bundle.json").read_text())
    all_canaries = json.loads((work / "merged" / "report.json").read_text())["canaries"]
    names = [[] for _ in range(shards)]
    for k in range(results):
        names[shard_of(f"made_{k:06d}", shards) - 1].append(f"made_{k:06d}")
    pattern = json.dumps(next(case for case in report["cases"] if case["passed"]), ensure_ascii=False)
    selected = b"".join(len(n).to_bytes(8, "little") + n.encode() for n in sorted(sum(names, [])))
    folders = []
    for k in range(shards):
        folder = work / f"large-{k + 1}"
        folder.mkdir()
        canaries = [one for one in all_canaries if shard_of(one["name"], shards) == k + 1]
        cases = [json.loads(re.sub(r"case_\d{5}", name, pattern)) for name in names[k]]
        text = json.dumps({**report, "shard": k + 1, "shards": shards, "cases": cases, "canaries": canaries}, ensure_ascii=False).encode()
        (folder / "report.json").write_bytes(text)
        sign({**manifest, "shard": k + 1, "shards": shards, "selected": results, "expected": names[k],
              "judged": names[k], "canaries": [one["name"] for one in canaries], "facts": {**manifest["facts"], "selected_hash": hexadecimal(selected)},
              "files": [{"path": "report.json", "bytes": len(text), "hash": hexadecimal(text)}]}, folder)
        folders.append(folder)
    begin = time.time()
    merged = run(program, "check", "--merge", *folders, "--report", work / "large")
    seconds = time.time() - begin
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    if merged.returncode != 0 or f"{results} cases passed" not in merged.stdout:
        fail(f"large: status {merged.returncode}: {merged.stdout[-300:]}{merged.stderr[-2000:]}")
    sizes = {name: (work / "large" / name).stat().st_size >> 20 for name in ("report.json", "junit.xml", "index.html")}
    print(f"passed  large: {results} results of {shards} shards in {seconds:.1f} s, at most {memory:.0f} MB; MB: {sizes}")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--cases", type=int, default=2000)
    parser.add_argument("--shards", type=int, default=200)
    parser.add_argument("--results", type=int, default=100000)
    given = parser.parse_args()
    if given.shards <= 20:
        parser.error("--shards: wanted more than 20, of which 20 are spoiled")
    program, work = given.program.resolve(), given.folder.resolve()
    work.mkdir(parents=True)
    bundles = part_merged(program, work, given.cases, given.shards)
    part_spoiled(program, work, bundles)
    passing = next(b for b in bundles if any(c["passed"] for c in json.loads((b / "report.json").read_text())["cases"]))
    part_large(program, work, passing, given.results, given.shards)


if __name__ == "__main__":
    main()
