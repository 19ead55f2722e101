// The server of `tumble view`: it answers its own page and nobody else.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, renameSync, rmSync, statSync, truncateSync } from "node:fs";
import { Agent, request } from "node:http";
import { connect } from "node:net";
import { after, before, test } from "node:test";
import { Sessions } from "./sessions.js";

const sessions = new Sessions(process.env.TUMBLE, process.env.WORK);

before(() => {
  sessions.record("a.tumble");
  sessions.record("other.tumble", { thrown: "0.5" });
});
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

/// A server of a log of its own: the place of the log, and how to ask.
async function served(name) {
  copyFileSync(sessions.path("a.tumble"), sessions.path(name));
  const { address, child } = await sessions.serve(name);
  return { log: sessions.path(name), address, child, ask: async (question) => (await fetch(address + question)).json() };
}
const kSlow = ["contacts?log=0&step=100", "history?log=0&id=900&from=0", "blame?log=0&step=100&id=900&field=velocity.y&back=1"];

test("a second browser is answered while another holds its connections open", async () => {
  const { address, child } = await served("two.tumble");
  const { host, hostname, port, pathname } = new URL(address);
  const began = performance.now();
  const sockets = await Promise.all(Array.from({ length: 12 }, () => new Promise((resolve) => {
    const socket = connect(port, hostname, () => socket.write(`GET ${pathname}news?log=0 HTTP/1.1\r\nHost: ${host}\r\n\r\n`));
    socket.once("data", () => resolve(socket));
  })));
  const other = new Agent({ keepAlive: true });
  await new Promise((resolve) => {
    request(address + "news?log=0", { agent: other }, (reply) => { reply.resume(); reply.on("end", resolve); }).end();
  });
  assert.ok(performance.now() - began < 1500, `waited ${performance.now() - began} ms`);
  for (const socket of sockets) socket.destroy();
  other.destroy();
  child.kill("SIGINT");
});

test("a log that is removed while it is served: states stay, the rest says why not", async () => {
  const { log, child, ask, address } = await served("gone.tumble");
  rmSync(log);
  assert.equal((await ask("body?log=0&step=100&id=900")).fields.length, 13);
  assert.ok((await (await fetch(`${address}frames?log=0&first=100&count=1&stride=1`)).arrayBuffer()).byteLength > 100);
  for (const question of kSlow) assert.match((await ask(question)).why_not, /^gone\.tumble: cannot be opened: No such file/, question);
  child.kill("SIGINT");
});

test("a named pipe where a log lay: nobody waits for it", async () => {
  const { log, child, ask } = await served("pipe.tumble");
  rmSync(log);
  execFileSync("mkfifo", [log]);
  const info = spawnSync(sessions.program, ["info", log], { timeout: 20000 });
  assert.equal(info.status, 2, "not killed while it waits");
  assert.match(String(info.stderr), /pipe\.tumble: is no file, but a pipe/);
  for (const question of kSlow) assert.match((await ask(question)).why_not, /^pipe\.tumble: is no file, but a pipe/, question);
  child.kill("SIGINT");
  assert.equal(await new Promise((resolve) => { child.on("exit", resolve); }), 0);
});

test("a log that is cut while it is served: nothing is said of what is gone", async () => {
  const { log, child, ask } = await served("cut.tumble");
  truncateSync(log, Math.floor(statSync(log).size / 3));
  for (const question of kSlow) {
    assert.match((await ask(question)).why_not, /^cut\.tumble: was cut while it was shown: its last step is \d+ now, and was 120; start/, question);
  }
  child.kill("SIGINT");
});

test("another log at the place of the one that is served is not mixed with it", async () => {
  const { log, child, ask } = await served("mixed.tumble");
  const before = await ask("body?log=0&step=100&id=900");
  copyFileSync(sessions.path("other.tumble"), sessions.path("new.tumble"));
  renameSync(sessions.path("new.tumble"), log);
  assert.deepEqual(await ask("body?log=0&step=100&id=900"), before);
  for (const question of kSlow) assert.match((await ask(question)).why_not, /^mixed\.tumble: another log lies here now; start/, question);
  child.kill("SIGINT");
});

test("a log that is being recorded and is removed: the page is told", async () => {
  const recorder = sessions.start("record", "scene.toml", "-o", "young.tumble", "--realtime", "--seconds", "600");
  await sessions.until_readable("young.tumble");
  const { address, child } = await sessions.serve("young.tumble");
  const news = async () => (await fetch(`${address}news?log=0`)).json();
  const { last } = await news();
  const until = async (holds) => {
    for (const end = performance.now() + 60000; performance.now() < end && !holds(await news());) await new Promise((resolve) => { setTimeout(resolve, 100); });
  };
  await until((one) => one.last > last);
  assert.equal((await news()).note, "");
  rmSync(sessions.path("young.tumble"));
  await until((one) => one.note !== "");
  assert.match((await news()).note, /^young\.tumble: cannot be opened: No such file/);
  recorder.kill("SIGINT");
  child.kill("SIGINT");
});
