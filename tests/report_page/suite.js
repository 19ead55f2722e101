// A suite that was blessed and then fails in several ways, and the report of its check.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

/// What no page may take for anything but text.
export const kHostile = `</script><script>window.hacked = 1</script><img src="http://127.0.0.1:9/a" onerror="hacked = 2">`;

/// A case's folder: its name goes into attributes, addresses and commands.
export const kHostileFolder = `a" onmouseover="hacked=1' <b>`;

const scene = (title, thrown, category = "impact") => `title = '''${title}'''
category = "${category}"
[world]
method = "layered"
dt = 0.016666666666666666
steps = 60
[[wall]]
courses = 3
bricks = 4
size = [2.0, 1.0, 1.0]
mass = 2.0
material = { texture = "brick" }
[[input]]
step = 2
kind = "throw"
id = 900
size = [1.0, 1.0, 1.0]
mass = 20.0
position = [0.0, -6.0, 1.5]
velocity = [${thrown}, 20.0, 0.0]
[camera]
position = [8.0, -10.0, 5.0]
target = [0.0, 0.0, 1.5]
`;

const rules = (max, picture) => `require = ["exact", "behaviour"${picture ? ', "image"' : ""}]
[[metric]]
name = "drift_max"
max = ${max}
why = '''${kHostile}'''
${picture ? '[[picture]]\nstep = 30\nfar_off_max = 10\nwhy = "a brick out of place"\n' : ""}`;

/// program: tumble. Eleven cases; "moved" (a picture, other bits), "loose" (out of a bound) and the hostile folder (other bits) fail. Returns the page's path.
export function make_report(program, folder) {
  const file = (name, which) => join(folder, "suite", "cases", name, which);
  const add = (name, picture) => {
    mkdirSync(file(name, ""), { recursive: true });
    writeFileSync(file(name, "scene.toml"), scene("a cube meets a wall", "0.0"));
    writeFileSync(file(name, "metrics.toml"), rules(1000, picture));
  };
  const passing = Array.from({ length: 8 }, (_, i) => `passes_${i}`);
  for (const name of ["moved", "loose", kHostileFolder, ...passing]) add(name, name === "moved");
  execFileSync(program, ["bless", "--all", "--suite", "suite", "--reason", "a test"], { cwd: folder, stdio: "pipe" });
  writeFileSync(file("moved", "scene.toml"), scene("a cube meets a wall", "1.5"));
  writeFileSync(file("loose", "scene.toml"), scene(kHostile, "0.0", "energy"));
  writeFileSync(file(kHostileFolder, "scene.toml"), scene("a cube meets a wall", "0.001"));
  const bounds = readFileSync(file("loose", "metrics.toml"), "utf8");
  writeFileSync(file("loose", "metrics.toml"), bounds.replace(/^max = .*$/m, "max = 0.001"));
  try {
    execFileSync(program, ["check", "--suite", "suite", "--report", "report"], { cwd: folder, stdio: "pipe" });
  } catch (error) {
    if (error.status !== 1) throw new Error(`the check should fail with status 1: ${error.stdout}${error.stderr}`);
    return join(folder, "report", "index.html");
  }
  throw new Error("the check passed, so that there is no failure to show");
}
