// What the session page does not know it does not draw or say: states that were lost, values that are none, contacts that
// an engine did not tell. And what it knows has room.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { copyFileSync, statSync, truncateSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, kPatienceMs } from "../report_page/eventually.js";
import { open_page } from "./pages.js";
import { Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const sessions = new Sessions(TUMBLE, WORK);
const errors = [];
let browser;

const open = (address) => open_page(browser, address, errors);

/// The page to send and the served one: what(page, kind).
async function both(names, hash, what) {
  sessions.run_any("view", ...names, "-o", "both.html");
  const { address, child } = await sessions.serve(...names);
  for (const [kind, place] of [["sent", pathToFileURL(sessions.path("both.html")).href], ["served", address]]) {
    const page = await open(place + hash);
    await what(page, kind);
    await page.context().close();
  }
  child.kill("SIGINT");
}

/// Whether a lane has any colour at a share of its width.
const drawn_at = (page, lane, share) => page.locator(".lane", { has: page.locator(`.label >> text="${lane}"`) }).locator("canvas").evaluate((canvas, at) => {
  const x = Math.round(at * (canvas.width - 1));
  return canvas.getContext("2d").getImageData(x, 0, 1, canvas.height).data.some((byte) => byte > 0);
}, share);

before(async () => {
  sessions.record("long.tumble", { steps: 400 }, "--set", "world.freezing=false");
  sessions.record("other.tumble", { steps: 400, thrown: "0.123456789" }, "--set", "world.freezing=false");
  sessions.damage("long.tumble", "damaged.tumble");
  for (const name of ["torn", "cut"]) copyFileSync(sessions.path("long.tumble"), sessions.path(`${name}.tumble`));
  let text = "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,world.heat\n";
  for (let k = 0; k <= 10; ++k) text += `${k},wheel,0,0,1,1,0,0,0,${k >= 3 && k <= 6 ? "nan" : k}\n`;
  writeFileSync(sessions.path("heat.csv"), text);
  sessions.run("import", "heat.csv", "-o", "heat.tumble");
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
});
after(async () => {
  sessions.end();
  await browser?.close();
});

test("no line goes over steps that were not read, and no page has every state of them", async () => {
  await both(["damaged.tumble"], "", async (page, kind) => {
    const notices = await eventually(page, () => page.locator(".notices").textContent(), (words) => /steps \d+ to/.test(words), "the gap");
    const [first, last] = /steps (\d+) to (\d+)/.exec(notices).slice(1).map(Number);
    await eventually(page, () => drawn_at(page, "energy", (last + 20) / 400), (drawn) => drawn, "the lane behind the gap");
    for (const lane of ["sleeping", "contacts", "energy", "highest speed"]) {
      assert.equal(await drawn_at(page, lane, (first - 20) / 400), true, lane);
      assert.equal(await drawn_at(page, lane, (first + last) / 2 / 400), false, lane);
    }
    if (kind === "sent") assert.match(notices, /every state that could be read/);
  });
});

test("no line goes over a channel's values that are no numbers", async () => {
  await both(["heat.tumble"], "", async (page) => {
    await eventually(page, () => drawn_at(page, "heat", 0.9), (drawn) => drawn, "the lane");
    assert.equal(await drawn_at(page, "heat", 0.1), true);
    assert.equal(await drawn_at(page, "heat", 0.45), false);
  });
});

test("where another engine tells no contacts there is no number of them", async () => {
  const search = async (page, words, answer) => {
    await page.locator("input[type=search]").fill(words);
    await eventually(page, () => page.locator(".search output").textContent(), (said) => answer.test(said), `"${words}" should be answered by ${answer}`);
  };
  await both(["heat.tumble"], "", async (page) => {
    await search(page, "bodies = 1", /^1 run of steps, the first at 0/);
    await search(page, "contacts = 0", /^no step has a value of it/);
    assert.equal(await page.locator(".lane:visible", { has: page.locator('.label >> text="contacts"') }).count(), 0);
  });
});

test("a page to send follows no log", async () => {
  truncateSync(sessions.path("torn.tumble"), Math.floor(statSync(sessions.path("torn.tumble")).size / 2));
  await both(["torn.tumble"], "", async (page, kind) => {
    assert.match(await page.locator(".facts").textContent(), kind === "sent" ? /not finished: shown to its last chunk/ : /not finished: followed/);
  });
});

test("the page says of a recovered log without its end that the session may have gone on", async () => {
  truncateSync(sessions.path("cut.tumble"), Math.floor(statSync(sessions.path("cut.tumble")).size * 3 / 4));
  sessions.run_any("recover", "cut.tumble", "-o", "saved.tumble");
  await both(["saved.tumble"], "", async (page) => {
    assert.match(await page.locator(".facts").textContent(), /cut short/);
    assert.match(await page.locator(".notices").textContent(), /The session may have gone on: recovered up to step \d+/);
  });
});

test("an address that names body 0 names none", async () => {
  await both(["heat.tumble"], "#step=3&body=0", async (page) => {
    await eventually(page, () => page.locator("output.said").textContent(), (words) => words.startsWith("step 3 "), "the step");
    assert.match(await page.locator(".panel", { has: page.locator("h2", { hasText: "Body" }) }).textContent(), /Press a body/);
  });
});

test("the values of a body in two sessions have room beside their fields", async () => {
  await both(["long.tumble", "other.tumble"], "#step=100&body=900", async (page) => {
    const table = page.locator(".panel table", { hasText: "orientation.w" });
    await table.waitFor();
    const [wide, room, tallest] = await table.evaluate((one) => [one.scrollWidth, one.parentElement.clientWidth,
      Math.max(...[...one.querySelectorAll("tr")].map((row) => row.getBoundingClientRect().height))]);
    assert.ok(wide <= room, `${wide} px of ${room}`);
    assert.ok(tallest < 40, `a row of ${tallest} px`);
    assert.deepEqual(errors, []);
  });
});
