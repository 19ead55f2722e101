// The bodies of one session on the stage: one instanced mesh for each geometry.
import {
  Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, MeshLambertMaterial, OctahedronGeometry, Quaternion, Vector3,
} from "three";
import { key_of, scale_of, shape_of, size_of } from "./shapes.js";

export const kAbsent = 0;
export const kAwake = 1;
export const kFrozen = 2;
export const kNotFinite = 3;

const kTurnUnit = 32767;
const nothing = new Matrix4().makeScale(0, 0, 0);

/// Darkens the edges of each face, so that bodies of one colour are told apart.
function with_edges(material) {
  material.defines = { USE_UV: "" };
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", [
      "#include <color_fragment>",
      "vec2 toEdge = min(vUv, 1.0 - vUv) / max(fwidth(vUv), vec2(1e-6));",
      "float flatness = clamp(3.0 * max(fwidth(vUv).x, fwidth(vUv).y), 0.0, 1.0);",
      "diffuseColor.rgb *= mix(mix(0.5, 1.0, flatness), 1.0, smoothstep(0.4, 1.6, min(toEdge.x, toEdge.y)));",
    ].join("\n"));
  };
  return material;
}

function material_of(look, has_edges) {
  if (look === "marks") return new MeshBasicMaterial({ wireframe: true, depthTest: false });
  const material = new MeshLambertMaterial();
  return has_edges ? with_edges(material) : material;
}

/// look: "solid", "ghost" or "marks".
export function make_bodies(look, colour, hue) {
  const group = new Group();
  const lost = new Group();
  let meshes = [];  // {mesh, rows}: instance i of a mesh is body rows[i]
  let table = { count: 0 };
  let shown = null;
  const set_ghost = (on) => {
    for (const { mesh } of meshes) {
      mesh.material.transparent = on;
      mesh.material.opacity = on ? 0.45 : 1;
      mesh.material.depthWrite = !on;
      mesh.material.needsUpdate = true;
      mesh.renderOrder = on ? 1 : 0;
    }
  };
  const rebuild = () => {
    for (const { mesh } of meshes) {
      group.remove(mesh);
      mesh.geometry.dispose();
      mesh.material.dispose();
      mesh.dispose();
    }
    const by_key = new Map();
    for (let row = 0; row < table.count; ++row) {
      const body = table.body(row);
      const key = look === "marks" ? "marks" : key_of(body);
      if (!by_key.has(key)) by_key.set(key, { body, rows: [] });
      by_key.get(key).rows.push(row);
    }
    meshes = [...by_key.values()].map(({ body, rows }) => {
      const shape = shape_of(body);
      const geometry = look === "marks" ? new OctahedronGeometry(0.5) : shape.geometry(body);
      const mesh = new InstancedMesh(geometry, material_of(look, shape.has_edges), rows.length);
      mesh.frustumCulled = false;
      if (look === "marks") mesh.renderOrder = 2;
      group.add(mesh);
      return { mesh, rows };
    });
    if (look === "ghost") set_ghost(true);
  };
  const plain = new Color(colour);
  group.add(lost);

  const self = {
    group,
    set_ghost,
    /// made: {count, body(row): {shape, size, …}}
    describe(made) {
      table = made;
      rebuild();
      if (shown) self.show(...shown);
    },
    /// frame: {rows, x, y, z, turn, mark}, or null for none. paint: {colour(row, Color) sets a colour, or null;
    /// hidden(row)}.
    show(frame, paint = {}) {
      shown = [frame, paint];
      const matrix = new Matrix4();
      const place = new Vector3();
      const turn = new Quaternion();
      const scale = new Vector3();
      const tone = new Color();
      for (const { mesh, rows } of meshes) {
        rows.forEach((row, i) => {
          const there = frame && row < frame.rows && frame.mark[row] !== kAbsent && frame.mark[row] !== kNotFinite;
          if (!there || paint.hidden?.(row)) {
            mesh.setMatrixAt(i, nothing);
          } else {
            const body = table.body(row);
            const n = frame.rows;
            place.set(frame.x[row], frame.y[row], frame.z[row]);
            if (look === "marks") {
              scale.setScalar(Math.min(...size_of(body)));
              turn.identity();
            } else {
              scale.set(...scale_of(body));
              turn.set(frame.turn[n + row], frame.turn[2 * n + row], frame.turn[3 * n + row], frame.turn[row])
                .normalize();
            }
            mesh.setMatrixAt(i, matrix.compose(place, turn, scale));
          }
          tone.copy(plain);
          paint.colour?.(row, tone, frame);
          mesh.setColorAt(i, tone);
        });
        mesh.instanceMatrix.needsUpdate = true;
        if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
        mesh.boundingSphere = null;
      }
      self.mark_lost(paint.lost ?? []);
    },
    /// Marks the places where bodies were last seen that have no place now.
    mark_lost(places) {
      for (const mesh of [...lost.children]) {
        lost.remove(mesh);
        mesh.geometry.dispose();
        mesh.material.dispose();
      }
      if (places.length === 0) return;
      const mesh = new InstancedMesh(new OctahedronGeometry(0.7),
        new MeshBasicMaterial({ color: hue.bad, wireframe: true, depthTest: false }), places.length);
      mesh.frustumCulled = false;
      mesh.renderOrder = 4;
      const matrix = new Matrix4();
      places.forEach(({ at, size }, i) => {
        mesh.setMatrixAt(i, matrix.compose(new Vector3(...at), new Quaternion(), new Vector3().setScalar(size)));
      });
      lost.add(mesh);
    },
    hits(ray) {
      return meshes.flatMap(({ mesh, rows }) => {
        const found = [];
        mesh.raycast(ray, found);
        return found.map((hit) => ({ distance: hit.distance, row: rows[hit.instanceId] }));
      });
    },
  };
  return self;
}

/// An orientation (w, x, y, z) as frames keep it: columns of whole numbers.
export function turns_of(rows, quaternion) {
  const turn = new Int16Array(4 * rows);
  for (let row = 0; row < rows; ++row) {
    quaternion(row).forEach((part, c) => { turn[c * rows + row] = Math.round(kTurnUnit * part); });
  }
  return turn;
}
