// The recipes of docs/ci fit the schemas that GitHub's and GitLab's editors use, and a misspelt key does not.
import assert from "node:assert";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

const modules = process.env.MODULES;
const load = (name) => import(pathToFileURL(path.join(modules, name)).href);
const { default: Ajv } = await load("ajv/dist/ajv.js");
const { schema } = await load("gitlab-ci-local/src/schema/schema.js");

/** What is wrong with a workflow of GitHub; empty: nothing. */
function githubErrors(text) {
  const file = path.join(mkdtempSync(path.join(tmpdir(), "tumble_ci_")), "workflow.yml");
  writeFileSync(file, text);
  const done = spawnSync("node", [path.join(modules, "@action-validator/cli/cli.mjs"), file], { encoding: "utf8" });
  return done.status === 0 ? "" : done.stdout + done.stderr || "no words";
}

function gitlabErrors(text) {
  const python = "import json, sys, yaml; json.dump(yaml.safe_load(sys.stdin), sys.stdout)";
  const parsed = spawnSync("/usr/bin/python3", ["-c", python], { input: text, encoding: "utf8" });
  assert.equal(parsed.status, 0, parsed.stderr);
  const validate = new Ajv({ strict: false, validateFormats: false }).compile(schema);
  return validate(JSON.parse(parsed.stdout)) ? "" : JSON.stringify(validate.errors);
}

for (const [file, errors, right, wrong] of [
  ["docs/ci/github.yml", githubErrors, "runs-on:", "runs_on:"],
  ["docs/ci/github_shards.yml", githubErrors, "matrix:", "matrices:"],
  ["docs/ci/gitlab.yml", gitlabErrors, "when: always", "when: sometimes"],
]) {
  test(`${file} fits the published schema`, () => {
    const text = readFileSync(file, "utf8");
    assert.equal(errors(text), "");
    assert.ok(text.includes(right));
    assert.notEqual(errors(text.replace(right, wrong)), "");
  });
}
