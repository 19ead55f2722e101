// How long the pages of `tumble view` let a person wait in chromium: opened, until the first state is there; sought, until
// the state is there, and until it is drawn.
// Usage: node figures.js ADDRESS|FILE.html [RUNS]     prints JSON; ADDRESS: of a served page
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { CHROMIUM, MODULES } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const [, , place, runs = "5"] = process.argv;
const kSeeks = 40;
const address = place.startsWith("http:") ? place : pathToFileURL(place).href;
const middle = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const summary = (values) => ({ median: middle(values), most: Math.max(...values) });

const browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--enable-unsafe-swiftshader"] });
const opened = [];
let seeks = [];
for (let run = 0; run < Number(runs); ++run) {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
  await page.goto("about:blank");
  const began = performance.now();
  await page.goto(address, { waitUntil: "commit" });
  await page.locator("#session[data-ready]").waitFor();
  opened.push(performance.now() - began);
  if (run === 0) {
    seeks = await page.evaluate(async (count) => {
      const slider = document.querySelector(".scrubber");
      const said = document.querySelector("output.said");
      const times = [];
      const shown = () => new Promise((resolve) => {
        const watch = new MutationObserver(() => { watch.disconnect(); resolve(performance.now()); });
        watch.observe(said, { childList: true, characterData: true, subtree: true });
      });
      for (let i = 0; i < count; ++i) {
        const change = shown();
        const start = performance.now();
        slider.value = String((i * 617 + 311) % Number(slider.max));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        const there = await change;
        await new Promise(requestAnimationFrame);  // draws
        await new Promise(requestAnimationFrame);  // after that picture
        times.push([there - start, performance.now() - start]);
      }
      return times;
    }, kSeeks);
  }
  await page.context().close();
}
await browser.close();
process.stdout.write(`${JSON.stringify({ open_ms: summary(opened),
  seek_ms: summary(seeks.map(([there]) => there)), drawn_ms: summary(seeks.map(([, drawn]) => drawn)) })}\n`);
