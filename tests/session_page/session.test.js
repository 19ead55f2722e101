// The page of `tumble view` in a browser, sent and served: what a person does with it, by mouse and by keyboard.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, kPatienceMs } from "../report_page/eventually.js";
import { kHostile, kHostileFile, Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");

let browser;
const sessions = new Sessions(TUMBLE, WORK);
const errors = [];
const requests = [];

/// A page that writes down whatever goes wrong in it and whatever it asks the network for.
async function open(address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, offline: address.startsWith("file:"), ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatienceMs);
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("request", (request) => {
    if (!request.url().startsWith(address.replace(/#.*/, "")) && !/^(data|blob):/.test(request.url())) requests.push(request.url());
  });
  await page.goto(address);
  await page.locator("#session[data-ready]").waitFor();
  return page;
}
const sent = (name) => pathToFileURL(sessions.path(name)).href;
const said = (page) => page.locator("output.said").textContent();
const panel_of = (page, title) => page.locator(".panel", { has: page.locator("h2", { hasText: title }) });
const values = (page, lane) => page.locator(".lane", { hasText: lane }).locator(".value").first().textContent();

before(async () => {
  sessions.record("a.tumble");
  sessions.record("b.tumble", { thrown: "0.001" });
  sessions.record(kHostileFile, { title: kHostile });
  sessions.import_lost("lost.tumble");
  sessions.record("long.tumble", { steps: 400 }, "--set", "world.freezing=false");
  sessions.damage("long.tumble", "damaged.tumble");
  sessions.run("view", "a.tumble", "-o", "a.html");
  sessions.run("view", "a.tumble", "b.tumble", "-o", "both.html");
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
});
after(async () => {
  sessions.end();
  await browser?.close();
});

test("the page to send scrubs by keyboard and by mouse, and plays both ways", async () => {
  const page = await open(sent("a.html"));
  assert.match(await said(page), /^step 0 · 0\.000 s · 12 bodies, \d+ asleep$/);
  const picture = async () => (await page.locator(".view3d canvas").screenshot()).toString("base64");
  const scrubber = page.locator(".scrubber");
  const first = await picture();
  await scrubber.focus();
  await page.keyboard.press("End");
  assert.match(await said(page), /^step 120 · 2\.000 s · 13 bodies/);
  assert.match(await scrubber.getAttribute("aria-valuetext"), /^step 120/);
  await eventually(page, picture, (one) => one !== first, "another picture");
  await page.keyboard.press("ArrowLeft");
  assert.match(await said(page), /^step 119/);
  await page.keyboard.press("Shift+ArrowLeft");
  assert.match(await said(page), /^step 109/);
  await page.locator("body").press("Home");
  assert.match(await said(page), /^step 0/);
  await page.keyboard.press("l");
  await eventually(page, () => said(page), (words) => words.startsWith("step 120 "), "l should play to the end");
  await page.keyboard.press("j");
  await eventually(page, () => said(page), (words) => words.startsWith("step 0 "), "j should play back to the start");
  assert.equal(await page.locator("button.play").getAttribute("aria-label"), "play");
  const lane = await page.locator(".lane canvas").first().boundingBox();
  await page.mouse.click(lane.x + lane.width / 2, lane.y + lane.height / 2);
  assert.match(await said(page), /^step (59|60|61) /);
  await page.keyboard.press("]");
  assert.match(await said(page), /^step 90 /, "the next input");
  assert.equal(await values(page, "events"), "push 1");
  await page.context().close();
});

test("the search finds steps by a condition, and bodies by id and name", async () => {
  const page = await open(sent("a.html"));
  const search = page.locator("input[type=search]");
  const answer = () => page.locator(".search output").textContent();
  await page.keyboard.press("/");
  await page.keyboard.type("speed > 15");
  assert.match(await answer(), /^1 run of steps, the first at 20$/);
  await page.keyboard.press("Enter");
  assert.match(await said(page), /^step 20 /);
  assert.match(await page.locator(".hits").textContent(), /up to .* m\/s, body 900/);
  await search.fill("contacts >= 1e9");
  assert.equal(await answer(), "in no step");
  await search.fill("overlap > 1e-12");
  assert.match(await answer(), /runs? of steps/);
  await search.fill("wobble > 1");
  assert.match(await answer(), /"wobble" is no quantity; there are speed,/);
  await search.fill("speed > much");
  assert.match(await answer(), /"much" is no number/);
  await search.fill("900");
  await page.keyboard.press("Enter");
  await eventually(page, () => panel_of(page, "Body").textContent(),
    (words) => /Body 900 thrown · 1 × 1 × 1 m · awake.*position\.x/s.test(words), "the body's numbers");
  await search.fill("wall 0, row 2");
  assert.match(await answer(), /^4 bodies$/);
  await page.context().close();
});

test("the search finds the steps of one body", async () => {
  for (const served of [false, true]) {
    const { address, child } = served ? await sessions.serve("a.tumble", "b.tumble") : { address: sent("both.html") };
    const page = await open(address);
    const search = page.locator("input[type=search]");
    const answer = async () => (await page.locator(".search output").textContent()).replace(/; (places|speeds) are .*rounded to 100 µm$/, "");
    await search.fill("speed of 900 > 15");
    await eventually(page, answer, (words) => /^\d+ runs? of steps, the first at 2[01]$/.test(words), "of the thrown cube");
    await eventually(page, () => panel_of(page, "Body").textContent(), (words) => words.includes("Body 900"), "it is chosen");
    await search.press("Enter");
    await eventually(page, () => said(page), (words) => /^step 2[01] /.test(words), "the first of them");
    await search.fill("height of 900 < -1");
    await eventually(page, answer, (words) => words === "in no step", "never below ground");
    await search.fill("separation of 900 > 1e-6");
    await eventually(page, answer, (words) => /^\d+ runs? of steps, the first at \d+$/.test(words), "between the two");
    await search.fill("asleep of 1 = 1");
    await eventually(page, answer, (words) => /^(\d+ runs? of steps|in no step)/.test(words), "sleeping");
    await search.fill("wobble of 900 > 1");
    assert.match(await answer(), /"wobble" is no quantity of a body; there are speed,/);
    await search.fill("speed of nobody > 1");
    assert.match(await answer(), /^no body "nobody"$/);
    await search.fill("speed of wall > 1");
    assert.match(await answer(), /^\d+ bodies answer to "wall"; wanted one$/);
    await page.context().close();
    child?.kill("SIGINT");
  }
});

test("contacts of both logs, each by its own letter", async () => {
  const { address, child } = await sessions.serve("a.tumble", "b.tumble");
  const page = await open(`${address}#step=60`);
  const contacts = panel_of(page, "Contacts");
  await eventually(page, () => contacts.locator(".contacts").allTextContents(),
    (both) => both.length === 2 && both.every((words) => /^\d+ contact points/.test(words)), "two lists");
  assert.deepEqual(await contacts.locator("h3").allTextContents(), ["A", "B"]);
  const plain = (await page.locator(".view3d canvas").screenshot()).toString("base64");
  await page.locator("button", { hasText: "Contacts" }).click();
  await eventually(page, async () => (await page.locator(".view3d canvas").screenshot()).toString("base64"), (one) => one !== plain, "arrows");
  await page.screenshot({ path: sessions.path("contacts.png") });
  await page.context().close();
  child.kill("SIGINT");
});

test("two logs: the first difference, its growth and the phases", async () => {
  const page = await open(sent("both.html"));
  const panel = panel_of(page, "Comparison");
  assert.match(await panel.textContent(), /First difference: step 20, phase inputs/);
  assert.match(await panel.locator("ul.marks").textContent(), /more than 1e-12 m apart from step 20, .*more than 1 µm apart from/);
  assert.match(await panel.locator("table.phases").textContent(), /push_contacts/);
  await page.locator("body").press("d");
  assert.match(await said(page), /^step 20 .* m apart$/);
  await page.locator("body").press("ArrowLeft");
  assert.match(await said(page), /^step 19 .*the same in both$/);
  await page.locator("button.jump").click();
  assert.match(await said(page), /^step 20 /);
  assert.match(await values(page, "separation"), /m$/);
  const ghosts = (await page.locator(".view3d canvas").screenshot()).toString("base64");
  await page.locator("button", { hasText: "Side by side" }).click();
  await eventually(page, async () => (await page.locator(".view3d canvas").screenshot()).toString("base64"), (one) => one !== ghosts, "side by side");
  await page.locator("input[type=search]").fill("separation > 1e-6");
  assert.match(await page.locator(".search output").textContent(), /^1 run of steps/);
  await page.context().close();
});

test("two logs without a difference: what the page says of every bit", async () => {
  const verdict = async (a, b, name) => {
    sessions.run("view", a, b, "-o", name);
    const page = await open(sent(name));
    const panel = panel_of(page, "Comparison");
    const words = [await panel.locator("p.good").textContent(), await panel.locator("p.soft").first().textContent()];
    await page.context().close();
    return words;
  };
  sessions.record("again.tumble");
  sessions.record("states.tumble", {}, "--hashes", "states");
  assert.deepEqual(await verdict("a.tumble", "again.tumble", "same.html"), ["Identical: 120 steps, the same in every bit.", "Not compared: names, texts, notes, snapshots, cameras, lights and looks: no step depends on them."]);
  const [good, left_out] = await verdict("a.tumble", "states.tumble", "compared.html");
  assert.equal(good, "Identical: 120 steps, the same in every compared bit.");
  assert.match(left_out, /^Not compared: .*phase/);
});

test("names of files and scenes stay text, and no script but the page's own runs", async () => {
  sessions.run("view", kHostileFile, "-o", "hostile.html");
  const page = await open(sent("hostile.html"));
  assert.ok((await page.locator("header").textContent()).includes(kHostile), "the title is shown as it is");
  assert.match(await page.title(), /onmouseover/);
  assert.equal(await page.locator("script:not([type])").count(), 1);
  assert.equal(await page.locator("img").count(), 0);
  const names = await page.locator("body *").evaluateAll((all) => all.flatMap((one) => one.getAttributeNames()));
  assert.ok(names.every((name) => !name.startsWith("on")), names.join(" "));
  await page.locator("input[type=search]").fill(kHostile);
  await page.evaluate(() => { document.body.insertAdjacentHTML("beforeend", `<img src="x:" onerror="window.hacked = 3">`); });
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.deepEqual(requests.splice(0), ["x:"], "of this test itself");
  const blocked = errors.splice(0);
  assert.ok(blocked.every((words) => /Content Security Policy|ERR_UNKNOWN_URL_SCHEME/.test(words)), blocked.join("\n"));
  await page.context().close();
});

test("a body that is no number is marked, and a log of another engine has no contacts", async () => {
  const { address, child } = await sessions.serve("lost.tumble");
  const page = await open(address);
  await page.locator("body").press("End");
  await eventually(page, () => said(page), (words) => /^step 10 .*body 2 lost: no numbers/.test(words), "the lost body");
  await eventually(page, () => page.locator(".facts").textContent(), (words) => words.includes("bodies lost"), "the head says so");
  assert.match(await panel_of(page, "Contacts").textContent(), /another engine/);
  await page.locator("input[type=search]").fill("lost > 0");
  await eventually(page, () => page.locator(".search output").textContent(), (words) => words === "1 run of steps, the first at 6", "from step 6");
  await page.context().close();
  child.kill("SIGINT");
});

test("a damaged log is shown around its gap, and says so", async () => {
  const made = sessions.run_any("view", "damaged.tumble", "-o", "damaged.html");
  assert.equal(made.status, 3);
  const page = await open(sent("damaged.html"));
  assert.match(await page.locator(".notices").textContent(), /steps \d+ to \d+: the record with it is damaged/);
  await page.context().close();
  const served = await sessions.serve("damaged.tumble");
  const other = await open(served.address);
  const notices = await eventually(other, () => other.locator(".notices").textContent(), (words) => /steps \d+ to/.test(words), "the head names the gap");
  const gap = /steps (\d+) to (\d+)/.exec(notices);
  await other.evaluate((step) => { location.hash = `#step=${step}`; location.reload(); }, gap[1]);
  await other.locator("#session[data-ready]").waitFor();
  await eventually(other, () => other.locator(".over-view").textContent(), (words) => /is not here: the record with it is damaged|cannot be read/.test(words), "the gap");
  await other.context().close();
  served.child.kill("SIGINT");
});

test("served: every bit of a body, contacts of every step, and exact search", async () => {
  const { address, child } = await sessions.serve("a.tumble", "b.tumble");
  const page = await open(address);
  await eventually(page, () => panel_of(page, "Comparison").textContent(), (words) => /First difference/.test(words), "compared");
  await page.locator("body").press("d");
  await page.locator("input[type=search]").fill("900");
  await page.keyboard.press("Enter");
  const numbers = panel_of(page, "Body");
  await eventually(page, () => numbers.textContent(), (words) => words.includes("velocity.x"), "the body's numbers");
  const row = numbers.locator("tr", { hasText: "velocity.x" });
  assert.match(await row.locator("td").first().getAttribute("title"), /^0x[0-9a-f]{16}$/);
  assert.match(await row.getAttribute("class"), /differs/);
  await page.locator("body").press("Escape");
  await eventually(page, () => panel_of(page, "Contacts").textContent(), (words) => /\d+ contact points/.test(words), "contacts");
  await page.context().close();
  child.kill("SIGINT");
});

test("a session that is being recorded is followed to its last chunk", async () => {
  sessions.record("scene.tumble");  // writes scene.toml
  const recorder = sessions.start("record", "scene.toml", "-o", "young.tumble", "--realtime", "--seconds", "600");
  await sessions.until_readable("young.tumble");
  const { address, child } = await sessions.serve("young.tumble");
  const page = await open(address);
  assert.match(await page.locator(".facts").textContent(), /not finished/);
  const last = () => page.locator(".scrubber").evaluate((slider) => Number(slider.max));
  const at_first = await last();
  await eventually(page, last, (step) => step > at_first + 60, "it should grow");
  recorder.kill("SIGINT");
  await eventually(page, () => page.locator(".facts").textContent(), (words) => !words.includes("not finished"), "and end");
  await page.context().close();
  child.kill("SIGINT");
});

test("narrow and dark, the page keeps within its width", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await open(sent("both.html"), { viewport: { width: 390, height: 800 }, colorScheme });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `the page is ${width} px wide`);
    await page.context().close();
  }
});

test("a page to send keeps to its size, and says what it left out", async () => {
  // A little more than the page takes without its states.
  const most = statSync("golden/report/page/bundle.js").size + 40000;
  sessions.run("view", "long.tumble", "-o", "small.html", "--megabytes", String(most / 1e6));
  assert.ok(statSync(sessions.path("small.html")).size <= most, String(statSync(sessions.path("small.html")).size));
  assert.equal(sessions.run_any("view", "long.tumble", "-o", "small.html", "--megabytes", "0.5").status, 2);
  const page = await open(sent("small.html"));
  assert.match(await page.locator(".notices").textContent(), /thinned: it has \d+ of 401 states(, rounded| \(one in ([1-9]\d?|[123]\d\d),)/);
  await page.context().close();
});

test("nothing went wrong, and nothing was asked of any other place", () => {
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
});
