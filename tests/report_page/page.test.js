// The page of a failing check in a browser: what a person does with it, by mouse and by keyboard.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, kPatienceMs } from "./eventually.js";
import { kHostile, kHostileFolder, make_report } from "./suite.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");

let browser;
let page;
const errors = [];
const requests = [];

/// A page that writes down whatever goes wrong in it and whatever it asks the network for.
async function open(options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, offline: true, ...options });
  const opened = await context.newPage();
  opened.setDefaultTimeout(kPatienceMs);
  opened.on("pageerror", (error) => errors.push(error.message));
  opened.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  opened.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) requests.push(request.url());
  });
  await opened.goto(pathToFileURL(`${WORK}/report/index.html`).href);
  return opened;
}

const section = (name) => page.locator("details", { has: page.locator(`#${name}`) });

before(async () => {
  make_report(TUMBLE, WORK);
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
  page = await open();
});
after(() => browser?.close());

test("drawings that are not in view yet do not ask for JavaScript", async () => {
  const fresh = await open();
  assert.doesNotMatch(await fresh.locator("body").evaluate((body) => body.textContent), /need JavaScript/);
  await fresh.context().close();
});

test("one click on a failed case of the summary leads to it", async () => {
  const link = page.locator(".glance a", { hasText: "moved" });
  await link.click();
  assert.ok(await section("moved").evaluate((place) => place.open));
  await eventually(page, () => page.locator("#moved").evaluate((head) => head.getBoundingClientRect().top),
    (top) => top > -1 && top < 300, "the case should be at the top of the window");
  assert.equal(await page.locator("details.fail").count(), 3);
  assert.equal(await page.locator("details.pass[open]").count(), 0, "what passed stays out of the way");
});

test("the keyboard leads there too", async () => {
  const fresh = await open();
  const at = () => fresh.evaluate(() => document.activeElement.textContent);
  for (let k = 0; k < 10 && await at() !== "moved"; ++k) await fresh.keyboard.press("Tab");
  assert.equal(await at(), "moved");
  await fresh.keyboard.press("Enter");
  await eventually(page, () => fresh.locator("#moved").evaluate((head) => head.getBoundingClientRect().top),
    (top) => top > -1 && top < 300, "Enter should go to the case");
  await fresh.context().close();
});

test("the picture's slider uncovers expected and actual", async () => {
  const viewer = section("moved").locator(".viewer");
  const over = viewer.locator(".over").first();
  const covered = () => over.evaluate((image) => Number(/([\d.]+)%\)?$/.exec(image.style.clipPath)?.[1]));
  const slider = viewer.locator("input[type=range]");
  assert.equal(await covered(), 50);
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await covered(), 51);
  await page.keyboard.press("End");
  assert.equal(await covered(), 100);
  assert.equal(await viewer.locator("output").textContent(), "expected");
  await page.keyboard.press("Home");
  assert.equal(await viewer.locator("output").textContent(), "actual");
  const box = await slider.boundingBox();
  await slider.click({ position: { x: box.width / 4, y: box.height / 2 } });
  const share = await covered();
  assert.ok(share > 15 && share < 35, `a click at a quarter of the slider gave ${share}`);
  const sizes = await viewer.locator("img").evaluateAll((images) => images.map((image) => image.naturalWidth));
  assert.deepEqual(sizes, [320, 320, 320], "expected, actual, difference");
});

test("blink shows both pictures in turn until it is pressed again", async () => {
  const viewer = section("moved").locator(".viewer");
  const said = () => viewer.locator("output").textContent();
  const blink = viewer.locator("button", { hasText: "Blink" });
  await blink.click();
  assert.equal(await blink.getAttribute("aria-pressed"), "true");
  await eventually(page, said, (words) => words === "actual", "blinking should come to the actual picture");
  await eventually(page, said, (words) => words === "expected", "and back to the expected one");
  await blink.focus();
  await page.keyboard.press("Space");
  assert.equal(await blink.getAttribute("aria-pressed"), "false");
  const words = await said();
  await page.waitForTimeout(1000);
  assert.equal(await said(), words, "it should rest now");
  const difference = viewer.locator("button", { hasText: "Difference" });
  await difference.press("Enter");
  assert.ok(await viewer.locator("img").nth(2).isVisible());
  await difference.click();
  assert.ok(!await viewer.locator("img").nth(2).isVisible());
});

test("the plots show this run and what was expected", async () => {
  await section("moved").locator(".drawing").scrollIntoViewIfNeeded();
  const plots = section("moved").locator(".plots figure");
  await plots.first().waitFor();
  assert.deepEqual(await plots.locator("figcaption").allTextContents(), ["Heights"], "the group of its only metric");
  const inked = await plots.locator("canvas").evaluateAll((all) => all.map((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  }));
  assert.ok(inked.every((colours) => colours > 10), `colours in each plot: ${inked}`);
  assert.match(await plots.first().locator(".u-legend").textContent(), /highest.*highest, expected/s);
});

test("the scrubber moves the bodies, the words and the plots", async () => {
  const drawing = section("moved").locator(".drawing");
  const scrubber = drawing.locator(".scrubber");
  const words = () => drawing.locator("output").textContent();
  const picture = async () => (await drawing.locator(".view3d canvas").screenshot()).toString("base64");
  await scrubber.scrollIntoViewIfNeeded();
  await drawing.locator(".view3d canvas").waitFor();
  await scrubber.focus();
  await page.keyboard.press("Home");
  assert.match(await words(), /^step 0: every body within 2 mm/);
  const first = await picture();
  await page.keyboard.press("End");
  assert.match(await words(), /^step 60: \d+ of 13 bodies elsewhere, the furthest is body \d+, .* away$/);
  const last = await picture();
  assert.notEqual(last, first, "the view should have changed");
  assert.match(await drawing.locator(".u-legend").first().textContent(), /^step:?\s*60/);
  const box = await scrubber.boundingBox();
  await scrubber.click({ position: { x: box.width / 2, y: box.height / 2 } });
  assert.match(await words(), /^step (2[89]|3[0-2]):/);
  await page.keyboard.press("Home");
  assert.equal(await picture(), first, "the same step gives the same view");
});

test("the view turns by arrow keys and by mouse, and play runs to the end", async () => {
  const drawing = section("moved").locator(".drawing");
  const canvas = drawing.locator(".view3d canvas");
  const picture = async () => (await canvas.screenshot()).toString("base64");
  const still = await picture();
  await canvas.focus();
  await page.keyboard.press("ArrowRight");
  const turned = await picture();
  assert.notEqual(turned, still);
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + 50, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + 150, box.y + 60, { steps: 3 });
  await page.mouse.up();
  assert.notEqual(await picture(), turned);
  await drawing.locator("button.play").click();
  await eventually(page, () => drawing.locator("output").textContent(), (words) => words.startsWith("step 60:"),
    "it should play to the last step");
  await eventually(page, () => drawing.locator("button.play").getAttribute("aria-label"), (words) => words === "play", "and stop there");
});

test("texts of a scene stay text", async () => {
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.ok((await section("loose").textContent()).includes(kHostile), "the title is shown as it is");
  assert.match(await page.title(), /3 of 11 cases failed/);
  assert.equal(await page.locator("img:not([src^='data:image/png'])").count(), 0);
  assert.equal(await page.locator("script:not([type])").count(), 1, "the page's own script only");
  // A folder's name goes into attributes, addresses and commands as well.
  const heading = page.locator("details h3", { hasText: "onmouseover" });
  assert.equal(await heading.textContent(), `✕ ${kHostileFolder}`);
  for (const place of await page.locator("[id], [alt], a").all()) {
    const names = await place.evaluate((one) => one.getAttributeNames());
    assert.ok(names.every((name) => !name.startsWith("on")), names.join(" "));
  }
});

test("a handler or a script that got in would not run", async () => {
  const fresh = await open();
  const told = [];
  fresh.on("console", (message) => told.push(message.text()));
  const before_errors = errors.length;
  await fresh.evaluate(() => {
    const place = document.createElement("div");
    place.innerHTML = `<img src="data:," onerror="window.hacked = 3"><a href="javascript:hacked = 4" id="trap">a</a>`;
    document.body.append(place);
    const script = document.createElement("script");
    script.textContent = "window.hacked = 5";
    document.body.append(script);
    place.querySelector("#trap").click();
  });
  await eventually(page, async () => told.filter((text) => text.includes("Content Security Policy")).length, (n) => n >= 3,
    "the policy should name what it refused");
  assert.equal(await fresh.evaluate(() => window.hacked), undefined);
  errors.length = before_errors;  // its refusals are what this test wants
  await fresh.context().close();
});

test("the table sorts and filters by verdict, magnitude and category", async () => {
  const fresh = await open();
  const rows = fresh.locator("table.glance tbody tr:visible");
  const names = () => rows.evaluateAll((all) => all.map((row) => row.dataset.name));
  assert.deepEqual((await names()).slice(0, 1), ["moved"], "the largest distance comes first");
  await fresh.locator("th[data-sort=name] button").click();
  assert.deepEqual(await names(), [kHostileFolder, "loose", "moved"].sort());
  await fresh.locator("th[data-sort=name] button").press("Enter");
  assert.deepEqual(await names(), [kHostileFolder, "loose", "moved"].sort().reverse());
  const filters = fresh.locator(".filters");
  await filters.locator("select").nth(1).selectOption("energy");
  assert.deepEqual(await names(), ["loose"]);
  assert.equal(await fresh.locator("details[data-category=impact]:visible").count(), 0, "sections follow");
  await filters.locator("select").nth(1).selectOption("");
  await filters.locator("input").fill("mov");
  assert.ok((await names()).includes("moved"));
  assert.ok(!(await names()).includes("loose"));
  assert.match(await filters.locator("output").textContent(), /^\d of 3 failed or moved cases$/);
  await fresh.context().close();
});

test("the top says what the cases have in common, and where the run comes from", async () => {
  const banner = await page.locator(".banner").textContent();
  assert.match(banner, /2 of 2 first differ in step \d+, phase \w+/);
});

test("a case that bless would refuse has the reason in place of the command", async () => {
  const commands = await section("loose").locator("pre").allTextContents();
  assert.ok(commands.every((line) => !line.startsWith("tumble bless")), commands.join("\n"));
  assert.match(await section("loose").textContent(), /bless would refuse it: drift_max is .*above the bound/);
});

test("the commands to reproduce and to accept are there", async () => {
  const commands = await section("moved").locator("pre").allTextContents();
  assert.ok(commands.some((line) => line.startsWith("tumble record suite/cases/moved/scene.toml")), commands.join("\n"));
  assert.ok(commands.includes("tumble check moved --suite suite"), commands.join("\n"));
  assert.ok(commands.some((line) => line.startsWith("tumble bless moved --suite suite")), commands.join("\n"));
});

test("a narrow screen needs no scrolling sideways, light or dark", async () => {
  const papers = new Set();
  for (const colorScheme of ["light", "dark"]) {
    const narrow = await open({ viewport: { width: 360, height: 700 }, colorScheme });
    await narrow.locator(".drawing").first().scrollIntoViewIfNeeded();
    await narrow.locator(".view3d").first().scrollIntoViewIfNeeded();
    await narrow.locator(".view3d canvas").first().waitFor();
    assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 360, colorScheme);
    // Names of files and words of an engine may be long and hold no place to break.
    await narrow.evaluate(() => {
      for (const place of document.querySelectorAll("h1, p, li, summary h3, summary > span, .glance td")) {
        if (place.childElementCount === 0) place.textContent = "golden/cases/".padEnd(200, "x");
      }
    });
    assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 360, "long words");
    papers.add(await narrow.evaluate(() => getComputedStyle(document.body).backgroundColor));
    await narrow.context().close();
  }
  assert.equal(papers.size, 2, "light and dark have different paper");
});

// The last test: it judges all that was done before.
test("nothing went wrong and nothing asked the network", () => {
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
});
