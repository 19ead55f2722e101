// The session page of two sessions whose first difference is no state: a parameter differs from step 1 on, and a body
// feels it many steps later. Sent and served.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, kPatienceMs } from "../report_page/eventually.js";
import { open_page } from "./pages.js";
import { Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");

let browser;
const sessions = new Sessions(TUMBLE, WORK);
const errors = [];
before(async () => {
  sessions.record("one.tumble");
  sessions.record("rougher.tumble", {}, "--set", "material.friction=0.4000000001");
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
});
after(async () => {
  sessions.end();
  await browser?.close();
  assert.deepEqual(errors, []);
});

/// As `diff` prints it.
function effect_of() {
  const { out } = sessions.run_any("diff", "one.tumble", "rougher.tumble", "--json");
  const found = JSON.parse(out);
  assert.ok(found.effect.step > found.first.step + 1, "the effect comes later");
  return found;
}

async function names_both_steps(page) {
  const { first, effect } = effect_of();
  const panel = page.locator(".panel", { has: page.locator("h2", { hasText: "Comparison" }) });
  await eventually(page, () => panel.textContent(), (words) => /First difference/.test(words), "compared");
  assert.match(await panel.locator("strong").first().textContent(), new RegExp(`^First difference: step ${first.step}, `));
  assert.match(await panel.locator(".effect").textContent(),
    new RegExp(`^Effect: step ${effect.step}, phase ${effect.phase}, .*${effect.field.replace(".", "\\.")}: `));
  const said = () => page.locator("output.said").textContent();
  const goes_to = async (step, what) => eventually(page, said, (words) => words.startsWith(`step ${step} `), what);
  await panel.getByRole("button", { name: "Go to the first state that differs" }).click();
  await goes_to(effect.step, "the state");
  await panel.getByRole("button", { name: "Go to the first difference" }).click();
  await goes_to(first.step, "the difference");
  await page.locator("body").press("Shift+D");
  await goes_to(effect.step, "the state, by key");
}

test("the page to send names the effect with its own step", async () => {
  sessions.run("view", "one.tumble", "rougher.tumble", "-o", "later.html");
  await names_both_steps(await open_page(browser, pathToFileURL(sessions.path("later.html")).href, errors));
});

test("so does the served page", async () => {
  const { address, child } = await sessions.serve("one.tumble", "rougher.tumble");
  await names_both_steps(await open_page(browser, address, errors));
  child.kill("SIGINT");
});
