// Three views of a failing page, for the documentation: its beginning, a picture under the slider, the trajectories.
// Usage: node picture.js PAGE FOLDER     writes FOLDER/top.png, FOLDER/slider.png and FOLDER/bodies.png
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { CHROMIUM, MODULES } = process.env;
const { chromium } = createRequire(`${MODULES}/`)("playwright-core");
const [, , address, folder] = process.argv;

const browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--enable-unsafe-swiftshader"] });
const page = await browser.newPage({ viewport: { width: 920, height: 1090 }, offline: true, colorScheme: "light" });
await page.goto(pathToFileURL(address).href);
await page.screenshot({ path: `${folder}/top.png` });
await page.locator(".viewer").first().screenshot({ path: `${folder}/slider.png` });
await page.locator(".drawing").first().scrollIntoViewIfNeeded();
const view = page.locator(".view3d").first();
await view.scrollIntoViewIfNeeded();
await view.locator("canvas").waitFor();
await view.evaluate((place) => place.scrollIntoView({ block: "center" }));
await page.waitForTimeout(500);  // until it is drawn
const box = await view.boundingBox();
const clip = { x: box.x, y: box.y - 75, width: box.width, height: box.height + 160 };
await page.screenshot({ path: `${folder}/bodies.png`, clip });
await browser.close();
