// Reads .glb files of `tumble export`: Khronos's validator finds nothing wrong, every keyframe is the float of what
// `tumble dump` prints, and three.js in a browser draws the session.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import test from "node:test";
import { pathToFileURL } from "node:url";

const { CHROMIUM, MODULES, WORK } = process.env;
const load = createRequire(`${MODULES}/`);
const validator = load("gltf-validator");

function parse(path) {
  const bytes = readFileSync(path);
  const size = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString("utf8", 20, 20 + size));
  return { json, binary: bytes.subarray(20 + size + 8) };
}

function floats({ json, binary }, accessor) {
  const { bufferView, byteOffset = 0, count, type } = json.accessors[accessor];
  const width = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type];
  const begin = (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
  return Array.from({ length: count * width }, (_, i) => binary.readFloatLE(begin + 4 * i));
}

for (const name of ["session", "shapes", "one"]) {
  test(`${name}.glb: the validator finds no error and no warning`, async () => {
    const report = await validator.validateBytes(new Uint8Array(readFileSync(`${WORK}/${name}.glb`)), { maxIssues: 20 });
    assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages));
    assert.equal(report.issues.numWarnings, 0, JSON.stringify(report.issues.messages));
  });
}

test("every keyframe is the float of the state", () => {
  const file = parse(`${WORK}/session.glb`);
  const { json } = file;
  const [head, ...rows] = readFileSync(`${WORK}/session.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
  const body = (id) => json.nodes.findIndex((node) => node.extras?.id === id);
  const [animation] = json.animations;
  const output = (node, path) => {
    const channel = animation.channels.find(({ target }) => target.node === node && target.path === path);
    return channel && floats(file, animation.samplers[channel.sampler].output);
  };
  const tables = new Map();
  const first = Number(rows[0][0]);
  let compared = 0;
  for (const row of rows) {
    const at = Object.fromEntries(head.map((name, i) => [name, row[i]]));
    const node = body(Number(at.id));
    if (!tables.has(node)) tables.set(node, [output(node, "translation"), output(node, "rotation")]);
    const [translation, rotation] = tables.get(node);
    const k = Number(at.step) - first;
    for (const [c, letter] of ["x", "y", "z"].entries()) {
      assert.equal(translation[3 * k + c], Math.fround(Number(at[`position.${letter}`])));
      ++compared;
    }
    for (const [c, letter] of ["x", "y", "z", "w"].entries()) {
      assert.ok(Math.abs(rotation[4 * k + c] - Number(at[`orientation.${letter}`])) < 1e-6);
    }
  }
  assert.ok(compared > 1000);
  const thrown = body(Number(rows.at(-1)[1]));
  const scale = output(thrown, "scale");
  assert.deepEqual(scale?.slice(0, 6), [0, 0, 0, 1, 1, 1], "a body that is thrown in later is scaled to nothing before");
});

test("three.js draws it", async () => {
  const { chromium } = load("playwright-core");
  const esbuild = load("esbuild");
  const { outputFiles } = await esbuild.build({
    stdin: { contents: readFileSync(new URL("show_gltf.js", import.meta.url), "utf8"), resolveDir: MODULES },
    bundle: true,
    format: "iife",
    write: false,
    nodePaths: [MODULES],
  });
  writeFileSync(`${WORK}/show.html`, `<!doctype html><body style="margin:0"><script>${outputFiles[0].text}</script>`);
  const browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--enable-unsafe-swiftshader", "--no-sandbox"] });
  try {
    for (const name of ["session", "shapes"]) {
      const page = await browser.newPage({ viewport: { width: 800, height: 500 } });
      const problems = [];
      page.on("pageerror", (error) => problems.push(error.message));
      await page.goto(pathToFileURL(`${WORK}/show.html`).href);
      const glb = readFileSync(`${WORK}/${name}.glb`).toString("base64");
      const facts = await page.evaluate(([data, share]) => window.show(data, share), [glb, 0.9]);
      await page.screenshot({ path: `${WORK}/${name}.png` });
      assert.deepEqual(problems, []);
      assert.ok(facts.meshes > 1 && facts.tracks > 1 && facts.camera, JSON.stringify(facts));
      assert.ok(facts.colours > 200, `a picture of ${facts.colours} colours`);
      await page.close();
    }
  } finally {
    await browser.close();
  }
});
