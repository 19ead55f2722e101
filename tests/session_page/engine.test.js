// The session page of another engine's log, with names, shapes and channels; and the chain behind a value of our own.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { TimelineRows } from "../../golden/report/page/session/timeline_rows.js";
import { box_around } from "../../golden/report/page/viewer/pointer.js";
import { kPatienceMs } from "../report_page/eventually.js";
import { open_page } from "./pages.js";
import { Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const sessions = new Sessions(TUMBLE, WORK);
const errors = [];
let browser;

const open = (address) => open_page(browser, address, errors);

const panel_of = (page, title) => page.locator(".panel", { has: page.locator("h2", { hasText: title }) });
const until = (page, selector, words) => page.locator(selector, { hasText: words }).first().waitFor();

/// A sphere, a capsule, a cylinder, a hull and a box in a row, ten steps; a value of each step and one of the sphere.
function import_shapes(name) {
  writeFileSync(sessions.path("wedge.obj"), "v 0.5 0.5 -0.5\nv -0.5 0.5 -0.5\nv 0.5 -0.5 -0.5\nv -0.5 -0.5 -0.5\nv 0 0 0.5\nf 1 2 5\n");
  const shapes = [["ball", "sphere"], ["pill", "capsule-z"], ["can", "cylinder-z"], ["wedge", "hull:wedge.obj"], ["crate", "box"]];
  let text = "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,shape," +
    "size.x,size.y,size.z,channel.heat,world.score\n";
  for (let k = 0; k <= 10; ++k) {
    shapes.forEach(([id, shape], i) => {
      const size = id === "pill" ? "1,1,2" : "1,1,1";
      text += `${k},${id},${1.5 * i},${0.1 * k},1,1,0,0,0,${shape},${size},${i === 0 ? k : ""},${k * k}\n`;
    });
  }
  writeFileSync(sessions.path("shapes.csv"), text);
  sessions.run("import", "shapes.csv", "-o", name);
}

before(async () => {
  import_shapes("shapes.tumble");
  sessions.record("own.tumble");
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
});
after(async () => {
  sessions.end();
  await browser?.close();
});

test("names, shapes and channels of another engine, sent and served", async () => {
  sessions.run("view", "shapes.tumble", "-o", "shapes.html");
  const { address, child } = await sessions.serve("shapes.tumble");
  for (const [kind, place] of [["sent", pathToFileURL(sessions.path("shapes.html")).href], ["served", address]]) {
    const page = await open(place);
    await until(page, ".lane", "score");
    await page.locator("body").press("End");
    await until(page, "output.said", "step 10 ");
    const score = page.locator(".lane", { hasText: "score" });
    await score.locator(".value", { hasText: "100" }).waitFor();
    await page.locator("input[type=search]").fill("score >= 81");
    await until(page, ".search output", "1 run of steps, the first at 9");
    await page.locator(".lane", { hasText: "heat, largest of bodies" }).locator(".value", { hasText: "10" }).waitFor();
    await page.locator("input[type=search]").fill("heat > 7");
    await until(page, ".search output", "1 run of steps, the first at 8");
    await page.locator("input[type=search]").fill("ball");
    await page.keyboard.press("Enter");
    await panel_of(page, "Body").locator("text=ball").first().waitFor();
    assert.doesNotMatch(await page.locator("aside").textContent(), /(^|[^.\d])\d{16}/, "a name says more than an id made of it");
    await page.locator("input[type=search]").fill("height of ball > 1.05");
    await until(page, ".search output", "in no step");
    if (kind === "served") await panel_of(page, "Body").locator("tr", { hasText: "heat" }).locator("td", { hasText: "10" }).waitFor();
    await panel_of(page, "Contacts").locator("text=holds no contacts").waitFor();
    await page.screenshot({ path: sessions.path(`shapes_${kind}.png`) });
    await page.context().close();
  }
  child.kill("SIGINT");
});

test("contacts that a page to send has no room for are not said to be in no log", () => {
  const with_contacts = (of_another, contacts) => {
    const rows = new TimelineRows([], of_another);
    Object.assign(rows, { step: [0, 1, 2], contacts });
    return rows;
  };
  const engine = with_contacts(true, [0, 5, 24433]);
  assert.match(engine.why_no_contacts(2), /^this page has no contacts of this state/);
  assert.equal(engine.why_no_contacts(0), "the log of another engine holds no contacts of step 0");
  assert.equal(with_contacts(true, [0, 0, 0]).why_no_contacts(2), "the log of another engine holds no contacts");
  assert.match(with_contacts(false, [0, 0, 0]).why_no_contacts(2), /^this page has no contacts of this state/);
});

test("the first view of bodies that hang above the ground has the ground in it", () => {
  const over = (z, ground) => box_around([[1, 2, 3], [0, 0, 0], [z, z, z]], 1, ground);
  assert.equal(over(5, true).centre[2], 2.5);
  assert.equal(over(5, false).centre[2], 5);
  assert.equal(over(0.5, true).centre[2], 0.5, "lying on it");
  assert.equal(over(1000, true).centre[2], 1000, "too far for both to be seen");
});

/// Body 1, a box, and from step 5 on body 2, a sphere, unless it is left out.
function import_late(name, with_two) {
  let text = "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,shape," +
    "size.x,size.y,size.z\n";
  for (let k = 0; k <= 10; ++k) {
    text += `${k},1,0,0,${k},1,0,0,0,box,1,2,3\n`;
    if (with_two && k >= 5) text += `${k},2,4,0,1,1,0,0,0,sphere,1,1,1\n`;
  }
  writeFileSync(sessions.path("late.csv"), text);
  sessions.run("import", "late.csv", "-o", name);
}

test("a body that appears later has its shape, and one that only one session has is said to be so", async () => {
  import_late("late.tumble", true);
  import_late("without.tumble", false);
  sessions.run("view", "late.tumble", "-o", "late.html");
  sessions.run("view", "late.tumble", "without.tumble", "-o", "late_two.html");
  const one = await sessions.serve("late.tumble");
  const two = await sessions.serve("late.tumble", "without.tumble");
  for (const place of [pathToFileURL(sessions.path("late.html")).href, one.address]) {
    for (const [id, words] of [[2, "Body 2 sphere of radius 0.5 m · awake"], [1, "Body 1 box · 1 × 2 × 3 m · awake"]]) {
      const page = await open(`${place}#step=7&body=${id}`);
      await until(page, ".panel p", words);
      await page.context().close();
    }
  }
  for (const place of [pathToFileURL(sessions.path("late_two.html")).href, two.address]) {
    const page = await open(`${place}#step=7&body=2`);
    await until(page, ".panel p", "Body 2 sphere of radius 0.5 m · awake · only in A");
    await until(page, "output.said", "1 body only in A");
    await until(page, ".effect", "body 2, only in A");
    await page.context().close();
  }
  one.child.kill("SIGINT");
  two.child.kill("SIGINT");
});

/// Two bodies and a pull between them, which grows while the heat of the second falls; body 3 has neither.
function import_pull(name) {
  let text = "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z," +
    "channel.heat,pair.pull\n";
  for (let k = 0; k <= 20; ++k) {
    text += `${k},1,0,0,1,1,0,0,0,100,2=${k} 3=50\n${k},2,2,0,1,1,0,0,0,${20 - k},\n${k},3,4,0,1,1,0,0,0,,\n`;
  }
  writeFileSync(sessions.path("pull.csv"), text);
  sessions.run("import", "pull.csv", "-o", name);
}

test("a channel of one body and of one pair is plotted and searched", async () => {
  import_pull("pull.tumble");
  const { address, child } = await sessions.serve("pull.tumble");
  const page = await open(`${address}#step=4&body=2`);
  const body = panel_of(page, "Body");
  const lane = (name) => page.locator(".lane", { has: page.getByText(name, { exact: true }) });
  const value = (name, words) => lane(name).locator(".value", { hasText: words }).waitFor();
  await value("heat, largest of bodies", /^100$/);
  await body.getByRole("button", { name: "plot heat in the timeline" }).click();
  await value("heat of body 2", /^16$/);
  await body.getByRole("button", { name: "plot pull with body 1 in the timeline" }).press("Enter");
  await value("pull of body 2 and body 1", /^4$/);
  await value("pull, largest of pairs", /^50$/);
  await page.locator("body").press("End");
  await value("heat of body 2", /^0$/);
  await value("pull of body 2 and body 1", /^20$/);
  const search = page.locator("input[type=search]");
  for (const [words, answer] of [["heat of 2 < 5", "1 run of steps, the first at 16"], ["pull of 1 and 2 > 17", "1 run of steps, the first at 18"],
    ["pull of 2 and 1 >= 17", "1 run of steps, the first at 17"], ["heat of 3 > 0", "no step has a value of it"], ["pull of 1 > 0", `"pull" is a channel of pairs: pull of 1 and 2 > 0`],
    ["heat of 9 > 0", `no body "9"`]]) {
    await search.fill(words);
    await page.locator(".search output").getByText(answer, { exact: true }).waitFor();
  }
  await page.screenshot({ path: sessions.path("pull.png") });
  const plot = body.getByRole("button", { name: "plot heat in the timeline" });
  assert.equal(await plot.getAttribute("aria-pressed"), "true");
  await plot.click();
  await lane("heat of body 2").waitFor({ state: "detached" });
  await page.context().close();
  const status = async (path) => (await fetch(address + path)).status;
  assert.equal(await status("channel?log=0&channel=0&a=2&b=0&from=0"), 200);
  assert.equal(await status("channel?log=0&channel=2&a=2&b=0&from=0"), 400);
  child.kill("SIGINT");
});

test("a lane says nothing of steps that the timeline has not reached", async () => {
  const { address, child } = await sessions.serve("own.tumble");
  const page = await (await browser.newContext()).newPage();
  // A server that has read up to step 40 so far.
  await page.route(/\/timeline\?/, async (route) => {
    const whole = await (await route.fetch()).json();
    const rows = whole.step.length - 41;
    const first = (values) => (Array.isArray(values) ? values.slice(0, -rows) : values);
    await route.fulfill({ json: { ...whole, ...Object.fromEntries(["step", "time", "read", "kinetic", "potential", "inputs",
      "contacts", "bodies", "sleeping", "lost", "speed", "speed_body", "height", "overlap"].map((name) => [name, first(whole[name])])) } });
  });
  await page.goto(`${address}#step=40`);
  const value = page.locator(".lane", { hasText: "sleeping" }).locator(".value");
  await value.locator("text=/ of /").waitFor();
  await page.locator("body").press("End");
  await until(page, "output.said", "step 120 ");
  assert.equal(await value.textContent(), "–");
  await page.context().close();
  child.kill("SIGINT");
});

test("a timeline that was not read is not searched", async () => {
  const { address, child } = await sessions.serve("own.tumble");
  const page = await (await browser.newContext()).newPage();
  const unread = "own.tumble: cannot be opened: No such file or directory";
  await page.route(/\/news\?/, async (route) => {
    const news = await (await route.fetch()).json();
    await route.fulfill({ json: { ...news, rows: 0, begun: 0, timeline_done: true, contacts_done: true, note: unread, unread } });
  });
  await page.goto(address);
  await until(page, ".notices .fail", unread);
  await page.locator("input[type=search]").fill("speed > 1");
  await until(page, ".search output", `the timeline was not read: ${unread}`);
  await page.context().close();
  child.kill("SIGINT");
});

test("a press on a number asks for the chain behind it", async () => {
  const { address, child } = await sessions.serve("own.tumble");
  const page = await open(`${address}#step=30&body=900`);
  const row = panel_of(page, "Body").locator("tr", { hasText: "velocity.z" });
  await row.locator("button").click();
  const chain = panel_of(page, "Where it comes from");
  await chain.locator("ol.blame > li").first().waitFor();
  assert.match(await chain.textContent(), /Body 900, velocity\.z after step 30: -?[\d.e-]+ m\/s/);
  const status = async (path) => (await fetch(address + path)).status;
  assert.equal(await status("blame?log=0&step=30&id=900&field=velocity.z&back=1"), 200);
  assert.equal(await status("blame?log=0&step=30&id=900&field=wobble&back=1"), 400);
  assert.equal(await status("blame?log=0&step=30&id=900&field=velocity.z&back=9999"), 400);
  await page.screenshot({ path: sessions.path("blame.png") });
  child.kill("SIGINT");
  await page.context().close();
});

test("a timeline judges the bounds of a case", async () => {
  writeFileSync(sessions.path("metrics.toml"), `require = ["behaviour"]
[[metric]]
name = "drift_max"
max = 0.1
bodies = "900"
from_step = 30
why = "a test"
[[metric]]
name = "mirror_error"
max = 0.1
why = "of a transformed scene"
`);
  const made = sessions.run_any("view", "own.tumble", "-o", "case.html", "--bounds", "metrics.toml");
  assert.equal(made.status, 0, made.err);
  const page = await open(pathToFileURL(sessions.path("case.html")).href);
  const lane = page.locator(".lane", { hasText: "drift_max of 900 from step 30 <= 0.1" });
  await lane.locator(".value", { hasText: "not judged" }).waitFor();
  await page.locator("body").press("End");
  await lane.locator(".value", { hasText: "✕ broken" }).waitFor();
  await page.context().close();
});

test("a timeline judges the bounds of the command line", async () => {
  sessions.run("view", "own.tumble", "-o", "bounds.html", "--require", "drift_max<=0.1", "--require", "lost<=0");
  const page = await open(pathToFileURL(sessions.path("bounds.html")).href);
  await page.locator("body").press("End");
  await page.locator(".lane", { hasText: "drift_max<=0.1" }).locator(".value", { hasText: "✕ broken" }).waitFor();
  await page.locator(".lane", { hasText: "lost<=0" }).locator(".value", { hasText: "✓ holds" }).waitFor();
  await page.locator("input[type=search]").fill("broken > 0");
  await until(page, ".search output", "1 run of steps, the first at");
  await page.context().close();
});

test("nothing went wrong", () => assert.deepEqual(errors, []));
