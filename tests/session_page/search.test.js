// The search of the session page, sent and served: what it finds is there, what it cannot know it says.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, kPatienceMs } from "../report_page/eventually.js";
import { find_runs, pair_in, parse_query } from "../../golden/report/page/session/search.js";
import { add_values } from "../../golden/report/page/session/timeline_rows.js";
import { largest } from "../../golden/report/page/theme.js";
import { open_page } from "./pages.js";
import { Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const sessions = new Sessions(TUMBLE, WORK);
const errors = [];
let browser;

const open = (address) => open_page(browser, address, errors);

/// Opens a log as a page to send and as a served one: what(page, kind).
async function both(name, what) {
  sessions.run_any("view", name, "-o", `${name}.html`);
  const { address, child } = await sessions.serve(name);
  for (const [kind, place] of [["sent", pathToFileURL(sessions.path(`${name}.html`)).href], ["served", address]]) {
    const page = await open(place);
    await what(page, kind);
    await page.context().close();
  }
  child.kill("SIGINT");
}

/// Types into the search, and waits for its answer.
async function search(page, words, answer) {
  await page.locator("input[type=search]").fill(words);
  await eventually(page, () => page.locator(".search output").textContent(), (said) => (answer instanceof RegExp ? answer.test(said) : said === answer),
    `"${words}" should be answered by ${answer}`);
}
const hits = (page) => page.locator(".hits").textContent();

/// One body, a step for each row of values; heads: the columns that they are in.
function import_values(name, heads, rows) {
  let text = `# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,${heads}\n`;
  rows.forEach((values, k) => { text += `${k},wheel,0,0,1,1,0,0,0,${values}\n`; });
  writeFileSync(sessions.path("values.csv"), text);
  sessions.run("import", "values.csv", "-o", name);
}

before(async () => {
  sessions.record("long.tumble", { steps: 400 }, "--set", "world.freezing=false");
  sessions.damage("long.tumble", "damaged.tumble");
  import_values("odd.tumble", "channel.constructor,channel.__proto__", ["1,2", "5,6"]);
  import_values("exact.tumble", "channel.fine,channel.endless,world.count", ["7,1,1", "7.00000004,inf,9007199254740992", "6.99999999,-inf,1e300"]);
  const heats = Array.from({ length: 13000 }, (_, k) => String(k === 7001 ? 9 : k === 9001 ? -9 : 1));
  import_values("many_steps.tumble", "channel.heat", heats);
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
});
after(async () => {
  sessions.end();
  await browser?.close();
});

test("steps that could not be read are in no answer, and each answer says how many they are", async () => {
  await both("damaged.tumble", async (page, kind) => {
    const notices = await eventually(page, () => page.locator(".notices").textContent(), (words) => /steps \d+ to/.test(words), "the gap");
    const [first, last] = /steps (\d+) to (\d+)/.exec(notices).slice(1).map(Number);
    const unread = `${last - first + 1} steps were not read`;
    await search(page, "bodies < 1", `in no step; ${unread}`);
    for (const words of ["lost = 0", "bodies >= 0", "contacts >= 0", "sleeping >= 0"]) {
      await search(page, words, `2 runs of steps, the first at 0; ${unread}`);
      assert.ok((await hits(page)).startsWith(`steps 0 to ${first - 1}:`), `${words}: ${await hits(page)}`);
    }
    await search(page, "height of 900 < -1", `in no step; ${unread}${kind === "sent" ? "; places are rounded to 100 µm" : ""}`);
    if (kind === "sent") return;  // which has no state of the gap to show
    await page.evaluate((step) => { location.hash = `#step=${step}`; location.reload(); }, first);
    await page.locator("#session[data-ready]").waitFor();
    await page.locator(".lane", { hasText: "contacts" }).first().locator(".value", { hasText: /^–$/ }).waitFor();
  });
});

test("a quantity may have any name", async () => {
  await both("odd.tumble", async (page, kind) => {
    await search(page, "constructor > 3", /^1 run of steps, the first at 1/);
    await search(page, "__proto__ > 1", /^1 run of steps, the first at 0/);
    if (kind === "served") await search(page, "__proto__ of wheel > 3", "1 run of steps, the first at 1");
    for (const words of ["toString > 5", "hasOwnProperty > 5"]) await search(page, words, /" is no quantity; there are speed,/);
    await search(page, "valueOf of wheel > 5", /"valueOf" is no quantity of a body; there are speed,/);
  });
});

test("conditions are about exact values, also infinite ones", async () => {
  await both("exact.tumble", async (page, kind) => {
    await search(page, "fine > 7", "1 run of steps, the first at 1");
    await search(page, "fine < 7", "1 run of steps, the first at 2");
    await search(page, "endless > 1e308", "1 run of steps, the first at 1");
    await search(page, "endless < -1e308", "1 run of steps, the first at 2");
    await search(page, "count = 9007199254740992", "1 run of steps, the first at 1");
    if (kind !== "served") return;
    await search(page, "fine of wheel > 7", "1 run of steps, the first at 1");
    await search(page, "fine of wheel = 7", "1 run of steps, the first at 0");
    await search(page, "endless of wheel > 5", "1 run of steps, the first at 1");
    assert.match(await hits(page), /infinite/);
  });
});

test("a condition may have the unit of its quantity, and no other", async () => {
  writeFileSync(sessions.path("units.csv"), "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z," +
    "orientation.w,orientation.x,orientation.y,orientation.z,channel.heat (K)\n0,wheel,0,0,1,1,0,0,0,7\n1,wheel,0,0,1,1,0,0,0,9\n");
  sessions.run("import", "units.csv", "-o", "units.tumble");
  await both("units.tumble", async (page, kind) => {
    await search(page, "heat > 7 K", "1 run of steps, the first at 1");
    assert.equal(await hits(page), "step 1: up to 9 K");
    await search(page, "heat < 7.5K", "1 run of steps, the first at 0");
    assert.equal(await hits(page), "step 0: down to 7 K");
    await search(page, "heat = 7 K", "1 run of steps, the first at 0");
    assert.equal(await hits(page), "step 0: 7 K");
    await search(page, "heat > 7 m", `"m" is not the unit of heat, which is in K`);
    await search(page, "bodies > 7 m", `"m" is not the unit of bodies, which has none`);
    if (kind === "served") await search(page, "heat of wheel >7 K", "1 run of steps, the first at 1");
  });
});

test("a page goes where its address says, also when that is typed anew", async () => {
  const { address, child } = await sessions.serve("long.tumble");
  const page = await open(`${address}#step=5`);
  const until = (words) => page.locator("output.said", { hasText: words }).waitFor();
  await until("step 5 ");
  await page.evaluate(() => { location.hash = "#step=50&body=900"; });
  await until("step 50 ");
  await page.locator(".panel h2", { hasText: "Body" }).waitFor();
  await eventually(page, () => page.locator("aside").textContent(), (words) => words.includes("Body 900"), "the body named");
  await page.context().close();
  child.kill("SIGINT");
});

test("a step that the session has not is no place to go", async () => {
  await both("long.tumble", async (page) => {
    const enter = async () => page.locator("input[type=search]").press("Enter");
    await search(page, "step 40", "Enter goes to step 40");
    await enter();
    await page.locator("output.said", { hasText: "step 40 " }).waitFor();
    for (const step of ["999", "-1"]) {
      await search(page, `step ${step}`, `no step ${step}: the session has steps 0 to 400`);
      await enter();
      await page.locator("output.said", { hasText: "step 40 " }).waitFor();
    }
  });
});

test("lane and search say what method thesis counts, which is more than contact points", async () => {
  sessions.record("thesis.tumble", {}, "--set", "world.method=\"thesis\"");
  await both("thesis.tumble", async (page) => {
    await search(page, "contacts > 0", /; contacts are the collisions resolved in all substeps$/);
    assert.equal(await page.locator(".lane", { has: page.locator('.label >> text="collisions resolved"') }).count(), 1);
    assert.equal(await page.locator(".lane", { has: page.locator('.label >> text="contacts"') }).count(), 0);
  });
  await both("long.tumble", async (page) => {
    await search(page, "contacts > 0", /the first at \d+$/);
    assert.equal(await page.locator(".lane", { has: page.locator('.label >> text="contacts"') }).count(), 1);
  });
});

test("what is still being recorded is answered so far", async () => {
  const recorder = sessions.start("record", "scene.toml", "-o", "young.tumble", "--realtime", "--seconds", "600");
  await sessions.until_readable("young.tumble");
  const { address, child } = await sessions.serve("young.tumble");
  const page = await open(address);
  await search(page, "height of 1 < -1", "in no step so far");
  await search(page, "bodies < 1", "in no step so far");
  await page.context().close();
  recorder.kill("SIGINT");
  child.kill("SIGINT");
});

test("nothing went wrong", () => assert.deepEqual(errors, []));

// Names of an engine's channels and bodies are its own: one that is called as a quantity of ours can be asked for.
test("channels with the names of quantities, and pairs of names with \" and \"", () => {
  const channels = [{ name: "speed", unit: "rpm" }, { name: "heat", unit: "K" }];
  const rows = { step: [0, 1], speed: [0, 9], speed_body: [1, 1], channels: { speed: [70, 80], heat: [1, 2] } };
  const ours = parse_query("speed > 5", channels);
  assert.equal(ours.unit, "m/s");
  assert.equal(find_runs(ours, rows).runs[0].first, 1);
  const theirs = parse_query("channel.speed > 75 rpm", channels);
  assert.deepEqual([theirs.kind, theirs.quantity, theirs.bound], ["steps", "speed", 75]);
  assert.equal(find_runs(theirs, rows).runs[0].peak, 80);
  const of_body = parse_query("channel.speed of wheel > 5", channels);
  assert.deepEqual([of_body.kind, of_body.quantity, of_body.body], ["channel steps", "speed", "wheel"]);
  assert.equal(parse_query("channel.nothing > 5", channels).kind, "wrong");
  const is_body = (name) => ["nut and bolt", "plate"].includes(name);
  assert.deepEqual(pair_in("nut and bolt and plate", is_body), ["nut and bolt", "plate"]);
  assert.deepEqual(pair_in("plate and nut and bolt", is_body), ["plate", "nut and bolt"]);
  assert.deepEqual(pair_in("1 and 2", () => true), ["1", "2"]);
  assert.deepEqual(pair_in("1", () => true), ["1"]);
});

test("a page to send that thins its timeline finds the largest values, and says that it has no others", async () => {
  await both("many_steps.tumble", async (page, kind) => {
    const note = kind === "sent" ? "; of each 3 steps only the largest value was searched" : "";
    const at = kind === "sent" ? 6999 : 7001;
    await search(page, "heat > 5", `1 run of steps, the first at ${at}${note}`);
    await search(page, "heat < 0", kind === "sent" ? `in no step${note}` : "1 run of steps, the first at 9001");
  });
});

test("columns and lists may be longer than a call takes arguments", () => {
  const many = new Array(300_000).fill(1);
  many[200_000] = 7;
  assert.equal(largest(many), 7);
  assert.equal(largest([]), -Infinity);
  const column = [];
  add_values(column, many);
  assert.equal(column.length, many.length);
});
