// Logs for the tests of the session page, and the program that shows them.
import { execFileSync, spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

/// What no page may take for anything but text.
export const kHostile = `</script><script>window.hacked = 1</script><img src="http://127.0.0.1:9/a" onerror="hacked = 2">`;

/// A file's name goes into the title, attributes and messages.
export const kHostileFile = `a" onmouseover="hacked=1' <b>.tumble`;

const scene = (title, thrown, steps) => `title = '''${title}'''
category = "impact"
[world]
method = "layered"
dt = 0.016666666666666666
steps = ${steps}
[[wall]]
courses = 3
bricks = 4
size = [2.0, 1.0, 1.0]
mass = 2.0
material = { texture = "brick" }
[[input]]
step = 20
kind = "throw"
id = 900
size = [1.0, 1.0, 1.0]
mass = 20.0
position = [0.0, -6.0, 1.5]
velocity = [${thrown}, 20.0, 0.0]
[[input]]
step = 90
kind = "push"
id = 1
impulse = [0.0, 1.0, 0.0]
[camera]
position = [8.0, -10.0, 5.0]
target = [0.0, 0.0, 1.5]
`;

export class Sessions {
  constructor(program, folder) {
    Object.assign(this, { program, folder, started: [] });
  }

  path(name) { return join(this.folder, name); }
  run(...words) { return execFileSync(this.program, words, { cwd: this.folder, stdio: "pipe" }).toString(); }

  /// Also where the program finds a damaged log, status 3.
  run_any(...words) {
    try {
      return { status: 0, out: this.run(...words) };
    } catch (error) {
      return { status: error.status, out: String(error.stdout), err: String(error.stderr) };
    }
  }

  record(name, { title = "a cube meets a wall", thrown = "0.0", steps = 120 } = {}, ...more) {
    writeFileSync(this.path("scene.toml"), scene(title, thrown, steps));
    this.run("record", "scene.toml", "-o", name, ...more);
  }

  /// A session of another engine: two bodies, ten steps; body 2 is no number from step 6 on.
  import_lost(name) {
    let text = "# engine: toy\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z," +
      "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,frozen\n";
    for (let k = 0; k <= 10; ++k) {
      const z = k >= 6 ? "nan" : `0.${5 + k}`;
      text += `${k},1,0,0,0.5,1,0,0,0,0,0,0,0,0,0,0\n${k},2,3,0,${z},1,0,0,0,0,0,1,0,0,0,0\n`;
    }
    writeFileSync(this.path("lost.csv"), text);
    this.run("import", "lost.csv", "-o", name);
  }

  /// Changes a byte in the middle of a file.
  damage(from, to) {
    const bytes = readFileSync(this.path(from));
    bytes[Math.floor(bytes.length / 2)] ^= 1;
    writeFileSync(this.path(to), bytes);
  }

  start(...words) {
    const child = spawn(this.program, words, { cwd: this.folder, stdio: ["ignore", "pipe", "inherit"] });
    this.started.push(child);
    return child;
  }

  /// Waits for a log that is being recorded to have steps that can be read.
  async until_readable(name) {
    while (!/steps +[1-9]/.test(this.run_any("info", name).out ?? "")) await new Promise((resolve) => setTimeout(resolve, 100));
  }

  /// Serves logs; resolves to {address, child}.
  serve(...words) {
    const child = this.start("view", ...words);
    return new Promise((resolve, reject) => {
      let said = "";
      child.stdout.on("data", (bytes) => {
        said += bytes;
        const found = /^(http:\S+)/m.exec(said);
        if (found) resolve({ address: found[1], child });
      });
      child.on("exit", (status) => reject(new Error(`tumble view ended with ${status}: ${said}`)));
    });
  }

  end() {
    for (const child of this.started) if (child.exitCode === null) child.kill("SIGINT");
  }
}
