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
after(() => browser?.close());

test("everything that can be worked has a role and a name", async () => {
  const nodes = await tree();
  for (const role of ["button", "slider", "searchbox", "combobox", "textbox", "spinbutton", "img", "image", "link", "DisclosureTriangle"]) {
    for (const node of of_role(nodes, role)) assert.notEqual(node.name.trim(), "", `a ${role} without a name`);
  }
  assert.ok(of_role(nodes, "button").length >= 10, "buttons");
  assert.ok(of_role(nodes, "heading").some(({ name }) => name.includes("a.tumble")), "the head names the log");
  for (const name of ["the state shown", "search and numbers"]) {
    assert.ok(nodes.some((node) => node.name === name), `the part "${name}"`);
  }
  const names = await page.locator("canvas").evaluateAll((all) => all.map((one) => [one.getAttribute("role"), one.getAttribute("aria-label"), one.getAttribute("aria-hidden")]));
  for (const [role, label, hidden] of names) assert.ok((role === "img" && label) || hidden === "true", `a canvas: ${role}, ${label}`);
});

test("what changes is said: the state shown, what was found, and where playing stands", async () => {
  const status = of_role(await tree(), "status");
  assert.ok(status.length >= 2, "the words under the view and the answer of the search are live regions");
  await page.locator("body").press("End");
  await eventually(page, () => page.locator(".scrubber").getAttribute("aria-valuetext"), (words) => words.startsWith("step 120 "),
    "the slider says the step in words");
  await page.locator("body").press("/");
  await page.keyboard.type("speed of 900 > 15");
  const said = await page.locator(".search output").evaluate((one) => [one.tagName, one.getAttribute("aria-live") ?? "polite"]);
  assert.deepEqual(said, ["OUTPUT", "polite"]);
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
