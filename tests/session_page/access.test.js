// The page of `tumble view` as a screen reader has it: chromium's accessibility tree, and the page worked by keyboard alone.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, kPatienceMs } from "../report_page/eventually.js";
import { Sessions } from "./sessions.js";

const { CHROMIUM, MODULES, TUMBLE, WORK } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const sessions = new Sessions(TUMBLE, WORK);
let browser;
let page;

/// Every node that a screen reader meets: [{role, name, properties}].
async function tree() {
  const client = await page.context().newCDPSession(page);
  const { nodes } = await client.send("Accessibility.getFullAXTree");
  await client.detach();
  return nodes.filter((node) => !node.ignored).map((node) => ({ role: node.role?.value, name: node.name?.value ?? "",
    properties: Object.fromEntries((node.properties ?? []).map(({ name, value }) => [name, value.value])) }));
}
const of_role = (nodes, role) => nodes.filter((node) => node.role === role);

before(async () => {
  sessions.record("a.tumble");
  sessions.record("b.tumble", { thrown: "0.001" });
  sessions.run("view", "a.tumble", "b.tumble", "-o", "both.html");
  browser = await chromium.launch({ executablePath: CHROMIUM, timeout: kPatienceMs, args: ["--enable-unsafe-swiftshader"] });
  page = await (await browser.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
  page.setDefaultTimeout(kPatienceMs);
  await page.goto(pathToFileURL(sessions.path("both.html")).href);
  await page.locator("#session[data-ready]").waitFor();
});
after(async () => {
  sessions.end();
  await browser?.close();
});

test("everything that can be worked has a role and a name", async () => {
  const nodes = await tree();
  for (const role of ["button", "slider", "searchbox", "combobox", "textbox", "spinbutton", "img", "image", "link", "DisclosureTriangle"]) {
    for (const node of of_role(nodes, role)) assert.notEqual(node.name.trim(), "", `a ${role} without a name`);
  }
  assert.ok(of_role(nodes, "button").every(({ name }) => !/^-?[\d.e+-]+$/.test(name)), "no button is called by a bare number");
  assert.ok(of_role(nodes, "table").every(({ name }) => name !== ""), "a table without a name");
  assert.ok(of_role(nodes, "button").length >= 10, "buttons");
  assert.ok(of_role(nodes, "heading").some(({ name }) => name.includes("a.tumble")), "the head names the log");
  for (const name of ["the state shown", "search and numbers"]) {
    assert.ok(nodes.some((node) => node.name === name), `the part "${name}"`);
  }
  const names = await page.locator("canvas").evaluateAll((all) => all.map((one) => [one.getAttribute("role"), one.getAttribute("aria-label"), one.getAttribute("aria-hidden")]));
  for (const [role, label, hidden] of names) assert.ok((role === "img" && label) || hidden === "true", `a canvas: ${role}, ${label}`);
});

test("the timeline is a slider that says its step in words", async () => {
  const [slider, ...more] = of_role(await tree(), "slider");
  assert.deepEqual(more, []);
  assert.equal(slider.name, "step shown");
  await page.locator("body").press("End");
  assert.deepEqual([slider.properties.valuemin, slider.properties.valuemax], [0, 120]);
  // The tree of the inspector has the number of a range here; the one that a screen reader gets has these words.
  assert.match(await page.getByRole("slider", { name: "step shown" }).getAttribute("aria-valuetext"), /^step 120 · 2\.000 s · 13 bodies, \d+ asleep · /);
  assert.ok((await tree()).some(({ role, name }) => role === "group" && name.startsWith("timeline")), "the lanes are a group with a name");
});

/// What the live region of a name says; undefined where there is none.
async function told(name) {
  const region = of_role(await tree(), "status").find((node) => node.name === name);
  if (!region || region.properties.live !== "polite") return undefined;
  return page.getByRole("status", { name, exact: true }).textContent();
}

test("what changes is said in live regions: verdict, body, search, playing", async () => {
  await page.reload();
  await page.locator("#session[data-ready]").waitFor();
  assert.equal(await told("what has happened"), "First difference: step 20, phase inputs");
  const step = of_role(await tree(), "status").filter(({ name, properties }) => name === "" && properties.live === "polite");
  assert.ok(step.length >= 1, "the words under the view");
  await page.locator("body").press("/");
  await page.keyboard.type("speed of 900 > 15");
  await eventually(page, () => told("what the search found"), (words) => /^\d+ runs? of steps, the first at 2[01]; speeds are made of places rounded to 100 µm$/.test(words), "the search");
  await eventually(page, () => told("what has happened"), (words) => words === "body 900 is chosen", "the body");
  await page.keyboard.press("Escape");
  await page.locator("select.speed").selectOption("0.05");
  await page.locator("body").press("l");
  assert.equal(await told("what has happened"), "playing");
  assert.equal(await page.locator("output.said").getAttribute("aria-live"), "off", "not thirty states a second");
  await page.locator("body").press("k");
  assert.match(await told("what has happened"), /^stopped at step \d+ · /);
  assert.equal(await page.locator("output.said").getAttribute("aria-live"), "polite");
});

test("everything that a mouse does in the view, a keyboard does too", async () => {
  const view = page.locator(".view3d canvas");
  await view.focus();
  const picture = async () => (await view.screenshot()).toString("base64");
  const press = async (key, others) => {
    await page.keyboard.press(key);
    return eventually(page, picture, (one) => !others.includes(one), `${key} gives another view`);
  };
  const first = await picture();
  for (const [way, back] of [["ArrowRight", "ArrowLeft"], ["ArrowUp", "ArrowDown"]]) {
    const turned = await press(way, [first]);
    await page.keyboard.press(back);
    await eventually(page, picture, (one) => one === first, `${back} turns back`);
    await press(`Shift+${way}`, [first, turned]);
    await page.keyboard.press(`Shift+${back}`);
    await eventually(page, picture, (one) => one === first, `${back} moves back`);
  }
  await press("+", [first]);
});

test("a number that leads to its cause says so", async () => {
  const { address, child } = await sessions.serve("a.tumble");
  const served = await (await page.context().browser().newContext()).newPage();
  served.setDefaultTimeout(kPatienceMs);
  await served.goto(`${address}#step=30&body=900`);
  const number = served.getByRole("button", { name: /^velocity\.z -?[\d.e-]+: where does it come from\?$/ });
  await number.focus();
  await served.keyboard.press("Enter");
  await eventually(served, () => served.getByRole("status", { name: "what has happened" }).textContent(),
    (words) => /^velocity\.z -?[\d.e-]+ comes from step \d+, \w+: ./.test(words), "the answer is said");
  await served.context().close();
  child.kill("SIGINT");
});

test("the keyboard alone reaches everything, and what has it is seen", async () => {
  await page.locator("h1").click();
  const wanted = await page.locator("button:visible:not(:disabled), input:visible, select:visible, summary:visible, canvas[tabindex]").count();
  const met = new Set();
  for (let k = 0; k < 3 * wanted; ++k) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => {
      const one = document.activeElement;
      if (!one || one === document.body) return null;
      one.dataset.met ??= String(document.querySelectorAll("[data-met]").length);
      const { outlineStyle, boxShadow } = getComputedStyle(one);
      return { key: one.dataset.met, seen: outlineStyle !== "none" || boxShadow !== "none", what: one.outerHTML.slice(0, 90) };
    });
    if (at === null) break;
    met.add(at.key);
    assert.ok(at.seen, `has the keyboard and does not show it: ${at.what}`);
  }
  assert.ok(met.size >= 0.95 * wanted, `${met.size} of ${wanted} can be reached`);
});

test("toggles say whether they are on", async () => {
  const pressed = async (name) => of_role(await tree(), "button").find((node) => node.name.startsWith(name))?.properties.pressed;
  assert.equal(await pressed("Contacts"), "false");
  await page.locator("h1").click();
  await page.locator("body").press("c");
  assert.equal(await pressed("Contacts"), "true");
});
