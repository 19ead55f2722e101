// What the page lists or draws in part: it says how many there are.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { kPatienceMs } from "../report_page/eventually.js";
import { open_page } from "./pages.js";
import { Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const sessions = new Sessions(TUMBLE, WORK);
const errors = [];
let browser;

/// Thirty bodies in a row, two steps; body 1 has a pull to each of the others, and the nine heats of body 2 are numbers.
function import_many(name) {
  const heats = [...Array(9).keys()];
  let text = "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z," +
    `pair.pull,${heats.map((k) => `channel.heat_${k}`).join()}\n`;
  for (let k = 0; k <= 2; ++k) {
    for (let id = 1; id <= 30; ++id) {
      const pulls = id > 1 ? "" : [...Array(29).keys()].map((other) => `${other + 2}=${k}`).join(" ");
      text += `${k},${id},${2 * id},0,${5 - k},1,0,0,0,${pulls},${heats.map((h) => (id === 2 ? h + k : "")).join()}\n`;
    }
  }
  writeFileSync(sessions.path("many.csv"), text);
  sessions.run("import", "many.csv", "-o", name);
}

before(async () => {
  import_many("many.tumble");
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
});
after(async () => {
  sessions.end();
  await browser?.close();
});

test("pairs, bodies found, ways and plots that are more than the page has room for are counted", async () => {
  const { address, child } = await sessions.serve("many.tumble");
  const page = await open_page(browser, `${address}#step=1&body=1`, errors);
  const body = page.locator(".panel", { has: page.locator("h2", { hasText: "Body" }) });
  await body.getByText("24 of 29 values of pairs are listed; tumble dump has all of them.", { exact: true }).waitFor();
  assert.equal(await body.locator("tr", { hasText: "pull with" }).count(), 24);
  await page.locator("input[type=search]").fill("box");
  await page.locator(".hits li", { hasText: "and 18 more" }).waitFor();
  await page.locator("input[type=search]").fill("2");
  await page.keyboard.press("Enter");
  await body.locator("tr", { hasText: "heat_8" }).waitFor();
  assert.equal(await body.getByText("values of pairs").count(), 0, "its one pull is all there is");
  const plot = (k) => body.getByRole("button", { name: `plot heat_${k} in the timeline` });
  for (let k = 0; k < 9; ++k) await plot(k).click();
  await page.locator("output", { hasText: "8 channels are plotted at most; gone is channel heat_0 of body 2" }).waitFor({ state: "attached" });
  assert.equal(await plot(0).getAttribute("aria-pressed"), "false");
  assert.equal(await plot(8).getAttribute("aria-pressed"), "true");
  await body.getByRole("button", { name: "Let go" }).click();
  await page.getByRole("button", { name: "Ways" }).click();
  await page.locator("output.said", { hasText: "ways of 15 of 30 bodies" }).waitFor();
  await page.getByRole("button", { name: "Ways" }).click();
  await page.locator("output.said", { hasText: /asleep$/ }).waitFor();
  await page.context().close();
  child.kill("SIGINT");
  assert.deepEqual(errors, []);
});
