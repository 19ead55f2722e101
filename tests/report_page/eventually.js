// Waits for what a page's script will write shortly.
import assert from "node:assert/strict";

/// How long a page may take: many times what any needs, so that no slow machine is judged.
export const kPatienceMs = 600000;

/// Reads until wanted(value) holds, and returns the value.
export async function eventually(page, read, wanted, words) {
  const end = Date.now() + kPatienceMs;
  for (;;) {
    const found = await read();
    if (wanted(found)) return found;
    assert.ok(Date.now() < end, `${words}; the last value was ${found}`);
    await page.waitForTimeout(50);
  }
}
