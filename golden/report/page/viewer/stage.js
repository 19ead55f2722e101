// Bodies in three dimensions: one or two sessions, contacts as arrows, ways as lines. Knows three.js and nothing of the
// page. z is up; lengths in m.
import {
  BufferGeometry, DirectionalLight, Float32BufferAttribute, GridHelper, Group, HemisphereLight, LineBasicMaterial,
  LineDashedMaterial, LineSegments, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { make_arrows } from "./arrows.js";
import { make_bodies } from "./bodies.js";

const kFieldOfView = 40;  // degrees
const kPixelRatioMax = 2;

function segments(points, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  if (material.isLineDashedMaterial) lines.computeLineDistances();
  return lines;
}

function drop(thing) {
  thing.traverse?.((part) => {
    part.geometry?.dispose();
    part.material?.dispose();
    part.dispose?.();
  });
  thing.removeFromParent();
}

/// The camera's place around a centre.
function make_view(radius, camera) {
  const view = { around: -0.9, up: 0.45, distance: 0.82 * radius / Math.sin((kFieldOfView / 2) * Math.PI / 180),
    centre: new Vector3() };
  if (camera) {
    const from = new Vector3(...camera.position).sub(new Vector3(...camera.target));
    view.around = Math.atan2(from.y, from.x);
    view.up = Math.min(1.5, Math.max(-0.3, Math.asin(from.z / from.length())));
  }
  return view;
}

/// box: {centre: [x, y, z], radius}. hue: as theme.js has it. Throws where the browser has no WebGL.
export function make_stage(canvas, { hue, box, camera: wanted, ground = true }) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, kPixelRatioMax));
  const { radius } = box;
  const scene = new Scene();
  const camera = new PerspectiveCamera(kFieldOfView, 1, radius / 200, radius * 200);
  camera.up.set(0, 0, 1);
  const sun = new DirectionalLight("#ffffff", 2.2);
  sun.position.set(0.45, -0.7, 1);
  const fill = new DirectionalLight("#ffffff", 0.7);  // sides that the sun does not reach still have shape
  fill.position.set(-0.8, 0.3, 0.4);
  scene.add(new HemisphereLight("#ffffff", "#c9d1da", 1.9), sun, fill);
  if (ground) {
    const grid = new GridHelper(8 * radius, 40, hue.line, hue.line);
    grid.rotation.x = Math.PI / 2;
    grid.position.set(box.centre[0], box.centre[1], 0);
    scene.add(grid);
  }
  const view = make_view(radius, wanted);
  view.centre.set(...box.centre);
  const sessions = [];
  const shared = new Group();
  scene.add(shared);
  const arrows = [make_arrows(hue.contact, 1), make_arrows(hue.expected, 0.7)];
  for (const { group } of arrows) scene.add(group);
  const lines = new Map();
  let side_by_side = false;
  let drawn = false;
  let waits = 0;  // the browser's number of the frame that will draw; 0: none

  // A picture that is higher than wide shows as much from side to side as another one does from top to bottom.
  const place_camera = () => {
    const distance = view.distance * Math.max(1, 0.95 / camera.aspect);
    const flat = Math.cos(view.up) * distance;
    camera.position.set(view.centre.x + flat * Math.cos(view.around), view.centre.y + flat * Math.sin(view.around),
      view.centre.z + distance * Math.sin(view.up));
    camera.lookAt(view.centre);
  };
  const halves = () => (side_by_side && sessions.length === 2 ? 2 : 1);
  const draw_now = () => {
    cancelAnimationFrame(waits);
    waits = 0;
    drawn = true;
    const size = renderer.getSize(new Vector2());
    const parts = halves();
    camera.aspect = size.x / parts / Math.max(1, size.y);
    camera.updateProjectionMatrix();
    place_camera();
    renderer.setScissorTest(parts === 2);
    for (let i = 0; i < parts; ++i) {
      const left = Math.round(i * size.x / parts);
      renderer.setViewport(left, 0, size.x / parts, size.y);
      renderer.setScissor(left, 0, size.x / parts, size.y);
      sessions.forEach((session, s) => { session.group.visible = parts === 1 || s === i; });
      arrows.forEach(({ group }, s) => { group.visible = parts === 1 || s === i; });
      for (const { session, line } of lines.values()) line.visible = parts === 1 || session === i;
      renderer.render(scene, camera);
    }
  };
  const draw = () => { waits ||= requestAnimationFrame(draw_now); };

  return {
    view,
    draw,
    draw_now,
    /// look: "solid", "ghost" or "marks" (a diamond where a body is).
    add_session(look, colour) {
      const bodies = make_bodies(look, colour, hue);
      sessions.push(bodies);
      scene.add(bodies.group);
      return {
        describe(table) { bodies.describe(table); draw(); },
        show(frame, paint) { bodies.show(frame, paint); draw(); },
      };
    },
    set_side_by_side(on) {
      side_by_side = on;
      sessions[1]?.set_ghost(!on);
      draw();
    },
    /// Segments by name, which replace those of before: {points: flat, colour, dash: m or 0, on_top, session: 0 or 1}.
    set_lines(name, made) {
      if (lines.has(name)) drop(lines.get(name).line);
      lines.delete(name);
      if (made && made.points.length > 0) {
        const { points, colour, dash, on_top } = made;
        const look = { color: colour, depthTest: !on_top, transparent: true, opacity: made.opacity ?? 1 };
        const material = dash ? new LineDashedMaterial({ ...look, dashSize: dash, gapSize: 0.7 * dash })
          : new LineBasicMaterial(look);
        const found = segments(points, material);
        found.renderOrder = on_top ? 2 : 1;
        shared.add(found);
        lines.set(name, { line: found, session: made.session ?? 0 });
      }
      draw();
    },
    /// Of session s: 0 or 1.
    set_arrows(list, s = 0) { arrows[s].show(list, view.distance); draw(); },
    /// The body under a point of the canvas, in shares of its width and height: {session, row}, or null.
    pick(x, y) {
      const parts = halves();
      const half = Math.min(parts - 1, Math.floor(x * parts));
      place_camera();
      camera.updateMatrixWorld();
      const ray = new Raycaster();
      ray.setFromCamera(new Vector2(2 * (x * parts - half) - 1, 1 - 2 * y), camera);
      const hits = sessions.flatMap((session, s) => (parts === 2 && s !== half ? [] :
        session.hits(ray).map((hit) => ({ ...hit, session: s }))));
      hits.sort((a, b) => a.distance - b.distance);
      return hits[0] ?? null;
    },
    turn(around, up) {
      view.around += around;
      view.up = Math.min(1.55, Math.max(-0.3, view.up + up));
      draw();
    },
    zoom(factor) {
      view.distance = Math.min(40 * radius, Math.max(radius / 100, view.distance * factor));
      draw();
    },
    /// Along the picture, in shares of its height.
    pan(right, up) {
      place_camera();
      camera.updateMatrixWorld();
      const scale = 2 * view.distance * Math.tan((kFieldOfView / 2) * Math.PI / 180);
      const along = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(-right * scale);
      view.centre.add(along.add(new Vector3().setFromMatrixColumn(camera.matrixWorld, 1).multiplyScalar(up * scale)));
      draw();
    },
    look_at(place) {
      view.centre.set(...place);
      draw();
    },
    resize(width, height) {
      const size = renderer.getSize(new Vector2());
      if (size.x === width && size.y === height) return;
      renderer.setSize(width, height, false);  // clears the picture
      if (drawn) draw_now();
      else draw();
    },
    dispose() {
      for (const session of sessions) drop(session.group);
      drop(shared);
      scene.traverse((thing) => {
        thing.geometry?.dispose();
        thing.material?.dispose();
      });
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}
