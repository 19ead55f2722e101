// How long the pages of `tumble view` let a person wait in chromium: opened, until the first state is drawn, and sought.
// Usage: node figures.js ADDRESS|FILE.html [RUNS]     prints JSON; ADDRESS: of a served page
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { CHROMIUM, MODULES } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const [, , place, runs = "5"] = process.argv;
const kSeeks = 40;
const address = place.startsWith("http:") ? place : pathToFileURL(place).href;
const middle = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

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
      for (let i = 0; i < count; ++i) {
        const step = String((i * 617 + 311) % Number(slider.max));
        const start = performance.now();
        slider.value = step;
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        while (!/^step \d+ /.test(said.value) || performance.now() - start < 1 || said.value === window.before) await new Promise(requestAnimationFrame);
        window.before = said.value;
        times.push(performance.now() - start);
      }
      return times;
    }, kSeeks);
  }
  await page.context().close();
}
await browser.close();
process.stdout.write(`${JSON.stringify({ open_ms: { median: middle(opened), most: Math.max(...opened) },
  seek_ms: { median: middle(seeks), most: Math.max(...seeks) } })}\n`);
