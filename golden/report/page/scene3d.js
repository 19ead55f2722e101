// The bodies of one case in three dimensions: boxes where this run has them, diamonds where they were expected, and
// the ways of those that went furthest astray. Knows three.js and nothing of the page.
import {
  AmbientLight, BoxGeometry, BufferGeometry, Color, DirectionalLight, GridHelper, InstancedMesh,
  LineBasicMaterial, LineDashedMaterial, LineSegments, Matrix4, MeshBasicMaterial, MeshLambertMaterial,
  OctahedronGeometry, PerspectiveCamera, Quaternion, Scene, Vector3, WebGLRenderer,
} from "three";

export const kApartMm = 2;  // nearer than this, millimetres alone can make the difference
const kSeenShare = 0.05;    // of a body's smallest edge, or of the session's largest distance if that is less
const kWaysMax = 40;        // more lines hide what they show
const kFieldOfView = 40;    // degrees

/// A row's coordinates of body i; null where any of them is unknown or not finite.
export const numbers_of = (row, i) => {
  const numbers = row === null ? [null] : row.slice(3 * i, 3 * i + 3);
  return numbers.includes(null) ? null : numbers;
};
const place_of = (row, i) => {
  const numbers = numbers_of(row, i);
  return numbers && new Vector3(...numbers).divideScalar(1000);
};

/// How far each body of each frame is from where it was expected, mm; null where that is not known.
export function distances(data) {
  const { actual_mm, expected_mm } = data.frames;
  return actual_mm.map((actual, f) => data.bodies.id.map((_, i) => {
    const a = place_of(actual, i);
    const b = place_of(expected_mm[f], i);
    return a && b ? 1000 * a.distanceTo(b) : null;
  }));
}

/// From how far apart a body gets a diamond, mm: what cannot be seen would only hide what can.
function seen_from(data, apart) {
  const worst = Math.max(0, ...apart.flat());
  return data.bodies.id.map((_, i) => {
    const edge = 1000 * Math.min(...data.bodies.size.slice(3 * i, 3 * i + 3));
    return Math.max(kApartMm, kSeenShare * Math.min(worst, edge > 0 ? edge : worst));
  });
}

/// The middle nine tenths of all places: one body that flew off must not make the others invisible.
function view_box(data) {
  const low = new Vector3();
  const high = new Vector3();
  const rows = [...data.frames.actual_mm, ...data.frames.expected_mm].filter((row) => row !== null);
  ["x", "y", "z"].forEach((axis, c) => {
    const values = rows.flatMap((row) => row.filter((value, k) => k % 3 === c && value !== null)).sort((a, b) => a - b);
    if (values.length === 0) return;
    low[axis] = values[Math.floor(0.05 * (values.length - 1))] / 1000;
    high[axis] = values[Math.ceil(0.95 * (values.length - 1))] / 1000;
  });
  const size = Math.max(...data.bodies.size, 0.1);
  return { centre: low.clone().add(high).divideScalar(2), radius: low.distanceTo(high) / 2 + Math.min(size, 4) };
}

function lines_of(points, material) {
  const geometry = new BufferGeometry().setFromPoints(points);
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  if (material.isLineDashedMaterial) lines.computeLineDistances();
  return lines;
}

/// From frame to frame, for the bodies that went furthest from where they were expected.
function ways_of(data, rows, apart) {
  const worst = data.bodies.id.map((_, i) => Math.max(...apart.map((frame) => frame[i] ?? 0)));
  const chosen = worst.map((_, i) => i).sort((a, b) => worst[b] - worst[a]).slice(0, kWaysMax);
  const points = [];
  for (const i of chosen) {
    for (let f = 1; f < rows.length; ++f) {
      const from = place_of(rows[f - 1], i);
      const to = place_of(rows[f], i);
      if (from && to) points.push(from, to);
    }
  }
  return points;
}

function add_boxes(scene, data, hue) {
  const count = data.bodies.id.length;
  const boxes = new InstancedMesh(new BoxGeometry(), new MeshLambertMaterial(), count);
  // Five shades, so that a brick can be told from its neighbours.
  for (let i = 0; i < count; ++i) boxes.setColorAt(i, new Color(hue.actual).offsetHSL(0, 0, 0.035 * (i % 5 - 2)));
  const marks = new InstancedMesh(new OctahedronGeometry(0.5),
    new MeshBasicMaterial({ color: hue.expected, wireframe: true, depthTest: false }), count);
  for (const mesh of [boxes, marks]) mesh.frustumCulled = false;
  marks.renderOrder = 2;
  scene.add(boxes, marks);
  return { boxes, marks };
}

/// hue: as theme.js has it. Throws where the browser has no WebGL.
export function make_scene(canvas, data, hue) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  const { centre, radius } = view_box(data);
  const scene = new Scene();
  const camera = new PerspectiveCamera(kFieldOfView, 1, radius / 100, radius * 100);
  camera.up.set(0, 0, 1);
  const sun = new DirectionalLight("#ffffff", 2.4);
  sun.position.set(0.4, -0.7, 1);
  const grid = new GridHelper(4 * radius, 20, hue.line, hue.line);
  grid.rotation.x = Math.PI / 2;
  grid.position.set(centre.x, centre.y, 0);
  scene.add(new AmbientLight("#ffffff", 0.9), sun, grid);

  const apart = distances(data);
  const limits = seen_from(data, apart);
  const { boxes, marks } = add_boxes(scene, data, hue);
  const dash = radius / 40;
  scene.add(
    lines_of(ways_of(data, data.frames.actual_mm, apart), new LineBasicMaterial({ color: hue.actual })),
    lines_of(ways_of(data, data.frames.expected_mm, apart),
      new LineDashedMaterial({ color: hue.expected, dashSize: dash, gapSize: 0.7 * dash })));
  const links = lines_of(data.bodies.id.flatMap(() => [new Vector3(), new Vector3()]),
    new LineBasicMaterial({ color: hue.bad, depthTest: false }));
  links.renderOrder = 1;
  scene.add(links);

  const view = { around: -0.9, up: 0.45, distance: radius / Math.sin((kFieldOfView / 2) * Math.PI / 180) };
  const draw = () => {
    const flat = Math.cos(view.up) * view.distance;
    camera.position.set(centre.x + flat * Math.cos(view.around), centre.y + flat * Math.sin(view.around),
      centre.z + view.distance * Math.sin(view.up));
    camera.lookAt(centre);
    renderer.render(scene, camera);
  };
  return {
    view,
    draw,
    show(frame) {
      place_frame(data, { apart: apart[frame], limits }, frame, { boxes, marks, links });
      draw();
    },
    turn(around, up) {
      view.around += around;
      view.up = Math.min(1.55, Math.max(-0.3, view.up + up));
      draw();
    },
    zoom(factor) {
      view.distance = Math.min(20 * radius, Math.max(radius / 10, view.distance * factor));
      draw();
    },
    resize(width, height) {
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      draw();
    },
    dispose() {
      scene.traverse((thing) => {
        thing.geometry?.dispose();
        thing.material?.dispose();
      });
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

/// Puts boxes, diamonds and the lines between them where a frame has them; what is not there shrinks to nothing.
function place_frame(data, { apart, limits }, frame, { boxes, marks, links }) {
  const { actual_mm, actual_turn, expected_mm } = data.frames;
  const ends = links.geometry.getAttribute("position");
  const matrix = new Matrix4();
  const nothing = new Matrix4().makeScale(0, 0, 0);
  const straight = new Quaternion();
  data.bodies.id.forEach((_, i) => {
    const size = new Vector3().fromArray(data.bodies.size, 3 * i);
    if (size.x === 0) size.setScalar(0.1);
    const actual = place_of(actual_mm[frame], i);
    const expected = place_of(expected_mm[frame], i);
    const [w, x, y, z] = actual_turn[frame].slice(4 * i, 4 * i + 4);
    boxes.setMatrixAt(i, actual ? matrix.compose(actual, new Quaternion(x, y, z, w), size) : nothing);
    const astray = expected && !(apart[i] !== null && apart[i] <= limits[i]);
    const least = Math.min(size.x, size.y, size.z);
    marks.setMatrixAt(i, astray ? matrix.compose(expected, straight, size.setScalar(least)) : nothing);
    const both = astray && actual;
    ends.setXYZ(2 * i, ...(both ? actual : new Vector3()));
    ends.setXYZ(2 * i + 1, ...(both ? expected : new Vector3()));
  });
  for (const mesh of [boxes, marks]) mesh.instanceMatrix.needsUpdate = true;
  ends.needsUpdate = true;
}
