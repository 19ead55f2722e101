// Pictures of a session page, for the documentation and to look at.
// Usage: node picture.js ADDRESS FILE.png [WIDTH HEIGHT light|dark SCRIPT]   SCRIPT: keys to press, by blanks; "click:TEXT"
// presses a button, "find:TEXT" searches
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { CHROMIUM, MODULES } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const [, , place, file, width = "1280", height = "940", colorScheme = "light", script = ""] = process.argv;

const browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--enable-unsafe-swiftshader"] });
const page = await browser.newPage({ viewport: { width: Number(width), height: Number(height) }, colorScheme });
page.on("pageerror", (error) => process.stderr.write(`${error.stack}\n`));
page.on("console", (message) => process.stderr.write(`${message.text()}\n`));
await page.goto(place.startsWith("http:") ? place : pathToFileURL(place).href);
await page.locator("#session[data-ready]").waitFor();
for (const word of script.split(" ").filter((one) => one !== "")) {
  if (word.startsWith("click:")) await page.locator("button", { hasText: word.slice(6).replaceAll("_", " ") }).first().click();
  else if (word.startsWith("find:")) {
    await page.locator("input[type=search]").fill(word.slice(5).replaceAll("_", " "));
    await page.locator("input[type=search]").press("Enter");
  } else if (word.startsWith("step:")) {
    await page.locator("input.step").fill(word.slice(5));
    await page.locator("input.step").press("Enter");
    await page.locator("h1").click();
  } else await page.locator("body").press(word);
}
await page.waitForTimeout(2500);  // until it is drawn
await page.screenshot({ path: file });
await browser.close();
