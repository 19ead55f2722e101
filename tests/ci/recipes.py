"""Runs the shell blocks of docs/ci as the service would, with the built program on PATH and stubs for apt-get and curl.

Usage: recipes.py TUMBLE SOURCE        exits with 77 where python3-yaml is missing
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    import yaml
except ImportError:
    print("recipes: skipped: python3-yaml is missing (tools/setup.sh --only tests)")
    sys.exit(77)

TUMBLE, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
STUB = '#!/bin/sh\necho "$(basename "$0") $*" >> "$STUBS.log"\n'


def fail(text):
    sys.exit(f"recipes: {text}")


def want(condition, text):
    if not condition:
        fail(text)


def github_steps(recipe):
    """(condition, script) of each step with a script; the environment; the paths that are uploaded."""
    job = recipe["jobs"]["goldens"]
    want(job["defaults"]["run"]["shell"] == "bash", "github.yml: blocks are run by bash here, and not there")
    uploads = [step["with"]["path"] for step in job["steps"] if "upload-artifact" in step.get("uses", "")]
    return [(step.get("if"), step["run"]) for step in job["steps"] if "run" in step], job["env"], uploads


def github_shard_steps(recipe):
    """As github_steps(): the job of each shard, one after the other, then the one that merges."""
    steps = []
    shards = recipe["jobs"]["shards"]
    for shard in shards["strategy"]["matrix"]["shard"]:
        fill = lambda text: text.replace("${{ matrix.shard }}", str(shard))
        variables = "".join(f"export {name}={fill(value)}; " for name, value in shards["env"].items())
        steps += [(step.get("if"), variables + fill(step["run"])) for step in shards["steps"] if "run" in step]
    merge = recipe["jobs"]["goldens"]
    want(merge["needs"] == "shards" and merge["if"] == "always()", "github_shards.yml: a lost shard is not reported")
    uploads = [step["with"]["path"] for step in merge["steps"] if "upload-artifact" in step.get("uses", "")]
    return steps + [(None, step["run"]) for step in merge["steps"] if "run" in step], recipe["env"], uploads


def gitlab_steps(recipe):
    job = recipe["physics"]
    want(job["artifacts"]["when"] == "always", "gitlab.yml: the report of a failed check is not kept")
    uploads = job["artifacts"]["paths"] + list(job["artifacts"]["reports"].values())
    return [(None, line) for line in job["before_script"] + job["script"]], job["variables"], uploads


def run_recipe(name, steps_of, folder):
    """Runs a recipe's steps in a folder as the service does. Returns whether all passed and what was printed."""
    # In YAML 1.1 the key `on` is true.
    steps, variables, uploads = steps_of(yaml.safe_load((SOURCE / "docs/ci" / name).read_text()))
    stubs = folder / "stubs"
    environment = {**os.environ, **variables, "STUBS": str(stubs)}
    environment |= {"GITHUB_WORKSPACE": str(folder), "CI_PROJECT_DIR": str(folder)}
    environment["PATH"] = f"{stubs}:{TUMBLE.parent}:{environment['PATH']}"
    passed, printed = True, ""
    for condition, script in steps:
        if not passed and condition not in ("always()", "failure()") or passed and condition == "failure()":
            continue
        done = subprocess.run(["bash", "-eo", "pipefail", "-c", script], cwd=folder, env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        passed, printed = passed and done.returncode == 0, printed + done.stdout
    for path in uploads:
        want((folder / path).exists(), f"{name}: the check left no {path}\n{printed}")
    return passed, printed


def suite_in(folder):
    """A suite of two cases that CI has checked out, and the stubs."""
    for case in ("bounce", "layered_bounce"):
        shutil.copytree(SOURCE / "golden/cases" / case, folder / "golden/cases" / case)
    (folder / "stubs").mkdir()
    for stub in ("apt-get", "curl"):
        path = folder / "stubs" / stub
        path.write_text(STUB)
        path.chmod(0o755)


def try_recipe(name, steps_of, shown):
    """shown(printed, folder): the line that the service shows for each failure."""
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        suite_in(folder)
        passed, printed = run_recipe(name, steps_of, folder)
        want(passed, f"{name}: a suite that passes\n{printed}")
        want(shown(printed, folder) == [], f"{name}: shows {shown(printed, folder)} for a suite that passes")
        calls = (folder / "stubs.log").read_text()
        want("apt-get install -y ./tumble.deb" in calls and "curl " in calls, f"{name}: installs no package: {calls}")

        scene = folder / "golden/cases/bounce/scene.toml"
        text = scene.read_text()
        want("restitution = 0.8" in text, "the case bounce has another restitution")
        scene.write_text(text.replace("restitution = 0.8", "restitution = 0.7"))
        passed, printed = run_recipe(name, steps_of, folder)
        want(not passed, f"{name}: a suite that fails\n{printed}")
        lines = shown(printed, folder)
        want(len(lines) == 1 and "bounce" in lines[0] and "first difference: step " in lines[0],
             f"{name}: shows {lines}, wanted one line with the first difference of bounce\n{printed}")
        cases = xml.etree.ElementTree.parse(folder / "report/junit.xml").getroot().iter("testcase")
        failed = [case.get("name") for case in cases if case.find("failure") is not None]
        want(failed == ["bounce"], f"{name}: junit.xml has the failures {failed}")


def try_subfolder():
    """A project in a folder of its repository: the service knows its files from the repository's folder."""
    with tempfile.TemporaryDirectory() as made:
        repository = pathlib.Path(made)
        (repository / "physics").mkdir()
        suite_in(repository / "physics")
        (repository / "physics/golden/cases/bounce/expected.tumble").unlink()
        environment = {**os.environ, "GITHUB_WORKSPACE": made, "CI_PROJECT_DIR": made}
        wanted = "physics/golden/cases/bounce/scene.toml"
        for service in ("github", "gitlab"):
            done = subprocess.run([TUMBLE, "check", "bounce", "--report", "report", "--annotate", service],
                                  cwd=repository / "physics", env=environment, text=True, capture_output=True, check=False)
            findings = repository / "physics/report/gl-code-quality-report.json"
            said = done.stdout if service == "github" else findings.read_text()
            want(wanted in said, f"{service}: found no {wanted} in\n{said}{done.stderr}")


try_subfolder()
try_recipe("github.yml", github_steps, lambda printed, _: [l for l in printed.splitlines() if l.startswith("::error ")])
try_recipe("github_shards.yml", github_shard_steps,
           lambda printed, _: [l for l in printed.splitlines() if l.startswith("::error ")])
try_recipe("gitlab.yml", gitlab_steps, lambda _, folder: [
    finding["description"] for finding in json.loads((folder / "report/gl-code-quality-report.json").read_text())])
print("recipes: github.yml, github_shards.yml and gitlab.yml pass and fail as they should")
