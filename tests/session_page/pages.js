// A session page in a browser.
import { kPatienceMs } from "../report_page/eventually.js";

/// Opens an address and waits until the session is there. errors: gets the messages of scripts that failed.
export async function open_page(browser, address, errors) {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
  page.setDefaultTimeout(kPatienceMs);
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(address);
  await page.locator("#session[data-ready]").waitFor();
  return page;
}
