// The server of `tumble view`: it answers its own page and nobody else.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Sessions } from "./sessions.js";

const sessions = new Sessions(process.env.TUMBLE, process.env.WORK);

before(() => sessions.record("a.tumble"));
after(() => sessions.end());

test("the server answers nobody but its own page", async () => {
  const { address, child } = await sessions.serve("a.tumble");
  const { origin, pathname, port } = new URL(address);
  const status = async (path, options) => (await fetch(origin + path, options)).status;
  assert.equal(await status(pathname), 200);
  assert.equal(await status("/"), 403);
  assert.equal(await status(`/${"0".repeat(32)}/`), 403);
  assert.equal(await status(`${pathname}news?log=0`), 200);
  assert.equal(await status(`${pathname}news?log=1`), 400);
  assert.equal(await status(`${pathname}frames?log=0&first=0&count=99999&stride=1`), 400);
  assert.equal(await status(`${pathname}frames?log=0&first=-1&count=1&stride=1`), 400);
  assert.equal(await status(`${pathname}../a.tumble`), 403);
  assert.equal(await status(`${pathname}a.tumble`), 404);
  assert.equal(await status(`${pathname}..%2fscene.toml`), 404);
  assert.equal(await status(pathname, { method: "POST", body: "x".repeat(100) }) >= 400, true);
  const { request } = await import("node:http");
  const with_host = (host) => new Promise((resolve) => {
    request({ host: "127.0.0.1", port, path: pathname, headers: { Host: host } }, (reply) => { reply.resume(); resolve(reply.statusCode); }).end();
  });
  assert.equal(await with_host(`127.0.0.1:${port}`), 200);
  assert.equal(await with_host(`evil.example:${port}`), 403);
  const reply = await fetch(address);
  assert.match(reply.headers.get("content-security-policy"), /default-src 'none'/);
  assert.equal(reply.headers.get("cross-origin-resource-policy"), "same-origin");
  assert.equal(reply.headers.get("access-control-allow-origin"), null);
  child.kill("SIGINT");
  const ended = await new Promise((resolve) => { child.on("exit", resolve); });
  assert.equal(ended, 0);
});
