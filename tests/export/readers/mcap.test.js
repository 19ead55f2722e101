// Reads an MCAP file of `tumble export` with @mcap/core and protobufjs, and compares every number with `tumble dump`.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import test from "node:test";

const { MODULES, WORK } = process.env;
const load = createRequire(`${MODULES}/`);
const { McapIndexedReader, McapStreamReader } = load("@mcap/core");
const protobuf = load("protobufjs");
const descriptor = load("protobufjs/ext/descriptor/index.js");
const fzstd = load("fzstd");

const decompressHandlers = { zstd: (bytes, size) => fzstd.decompress(bytes, new Uint8Array(Number(size))) };

class Bytes {
  constructor(path) {
    this.bytes = readFileSync(path);
  }
  async size() {
    return BigInt(this.bytes.length);
  }
  async read(offset, length) {
    return new Uint8Array(this.bytes.subarray(Number(offset), Number(offset + length)));
  }
}

function typeOf(schema) {
  const set = descriptor.FileDescriptorSet.decode(schema.data);
  return protobuf.Root.fromDescriptor(set).lookupType(schema.name);
}

/// Messages by topic, each {time, value}.
async function read(path) {
  const reader = await McapIndexedReader.Initialize({ readable: new Bytes(path), decompressHandlers });
  const types = new Map();
  const topics = {};
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    if (!types.has(channel.schemaId)) types.set(channel.schemaId, typeOf(reader.schemasById.get(channel.schemaId)));
    (topics[channel.topic] ??= []).push({ time: message.logTime, value: types.get(channel.schemaId).decode(message.data) });
  }
  return { reader, topics };
}

/// The table of `tumble dump --csv`, by step and id.
function table(path) {
  const [head, ...rows] = readFileSync(path, "utf8").trim().split("\n").map((line) => line.split(","));
  const steps = new Map();
  for (const row of rows) {
    const body = Object.fromEntries(head.map((name, i) => [name, row[i]]));
    if (!steps.has(body.step)) steps.set(body.step, []);
    steps.get(body.step).push(body);
  }
  return [...steps.values()];
}

const number = (cell) => (cell === "inf" ? Infinity : cell === "-inf" ? -Infinity : Number(cell.startsWith("nan") ? NaN : cell));
const same = (found, wanted, about) => assert.ok(Object.is(found, number(wanted)), `${about}: ${found}, wanted ${wanted}`);

test("every pose, velocity and id is that of dump, to the bit", async () => {
  const { reader, topics } = await read(`${WORK}/session.mcap`);
  const steps = table(`${WORK}/session.csv`);
  assert.equal(topics["/tf"].length, steps.length);
  assert.equal(topics["/poses"].length, steps.length);
  let compared = 0;
  for (const [k, bodies] of steps.entries()) {
    const transforms = topics["/tf"][k].value.transforms;
    const poses = topics["/poses"][k].value.poses;
    const states = topics["/bodies"][k].value;
    assert.equal(transforms.length, bodies.length);
    assert.equal(Number(states.step), Number(bodies[0].step));
    for (const [i, body] of bodies.entries()) {
      assert.equal(String(states.id[i]), body.id);
      assert.equal(transforms[i].child_frame_id, `body_${body.id}`);
      assert.equal(transforms[i].parent_frame_id, "world");
      for (const [c, letter] of ["x", "y", "z"].entries()) {
        same(transforms[i].translation[letter], body[`position.${letter}`], "translation");
        same(poses[i].position[letter], body[`position.${letter}`], "position");
        same(states.velocity[3 * i + c], body[`velocity.${letter}`], "velocity");
        same(states.spin[3 * i + c], body[`spin.${letter}`], "spin");
        compared += 4;
      }
      for (const letter of ["w", "x", "y", "z"]) {
        same(transforms[i].rotation[letter], body[`orientation.${letter}`], "rotation");
        same(poses[i].orientation[letter], body[`orientation.${letter}`], "orientation");
      }
      assert.equal(states.frozen[i], body.frozen === "1");
    }
  }
  assert.ok(compared > 1000);
  assert.equal(reader.statistics.messageCount, BigInt(Object.values(topics).reduce((sum, list) => sum + list.length, 0)));
  assert.ok(reader.chunkIndexes.length > 0);
});

test("the scene has every body once, fixed to its frame, and again where a body comes", async () => {
  const { topics } = await read(`${WORK}/session.mcap`);
  const steps = table(`${WORK}/session.csv`);
  const counts = topics["/scene"].map(({ value }) => value.entities.filter((one) => one.frame_locked).length);
  const wanted = steps.map((bodies) => bodies.length).filter((count, k, all) => count !== all[k - 1]);
  assert.deepEqual(counts, wanted);
  for (const { value } of topics["/scene"]) {
    assert.equal(value.deletions.length, 1);
    for (const entity of value.entities) {
      const parts = entity.cubes.length + entity.spheres.length + entity.cylinders.length + entity.triangles.length;
      assert.ok(parts > 0, entity.id);
    }
  }
});

test("a reader without the index reads the same messages", async () => {
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  stream.append(new Uint8Array(readFileSync(`${WORK}/session.mcap`)));
  let messages = 0;
  let last;
  for (let record; (record = stream.nextRecord()); ) {
    if (record.type === "Message") ++messages;
    last = record.type;
  }
  assert.equal(last, "Footer");
  assert.ok(stream.done());
  const { reader } = await read(`${WORK}/session.mcap`);
  assert.equal(BigInt(messages), reader.statistics.messageCount);
});

test("channels are topics with their values, of bodies and of the step", async () => {
  const { reader, topics } = await read(`${WORK}/channels.mcap`);
  const rows = readFileSync(`${WORK}/channels.csv`, "utf8").trim().split("\n").filter((line) => !line.startsWith("#"));
  const head = rows[0].split(",");
  const column = (name) => head.indexOf(name);
  const wanted = rows.slice(1).map((row) => row.split(","));
  const knee = topics["/channel/knee"].flatMap(({ value }) => value.values.map((one) => one.float64));
  assert.deepEqual(knee, wanted.map((row) => Number(row[column("channel.knee")])));
  const seed = topics["/channel/seed"].map(({ value }) => Number(value.values[0].int64));
  assert.deepEqual(seed, wanted.filter((_, i) => i % 2 === 0).map((row) => Number(row[column("world.seed")])));
  const word = topics["/channel/word"].flatMap(({ value }) => value.values.map((one) => one.text));
  assert.deepEqual(word, wanted.map((row) => row[column("channel.word")]));
  const channel = [...reader.channelsById.values()].find(({ topic }) => topic === "/channel/knee");
  assert.equal(channel.metadata.get("kind"), "float64");
});
