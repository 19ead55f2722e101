// The shapes of bodies: a table from a shape's kind to its geometry. A log's bodies are boxes unless it says otherwise.
import {
  BoxGeometry, BufferGeometry, CapsuleGeometry, CylinderGeometry, Float32BufferAttribute, SphereGeometry, Vector3,
} from "three";
import { ConvexGeometry } from "three/addons/geometries/ConvexGeometry.js";
import { by_name } from "../theme.js";

const kRound = 24;  // segments around
const kUnknownEdge = 0.1;  // m, of a body whose size no log says

/// three.js has its round shapes along y. axis: 0 x, 1 y, 2 z.
function along(axis, geometry) {
  if (axis === 0) return geometry.rotateZ(-Math.PI / 2);
  return axis === 2 ? geometry.rotateX(Math.PI / 2) : geometry;
}

const corners_of = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => new Vector3().fromArray(flat, 3 * i));

function faces({ points, triangles }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.setIndex(triangles);
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

// Lengths in m, in the body's axes around its centre of mass. has_edges: texture coordinates run from edge to edge of each
// face, so that edges can be drawn.
const kShapes = by_name({
  box: { geometry: () => new BoxGeometry(), has_edges: true },
  sphere: { geometry: ({ radius }) => new SphereGeometry(radius, kRound, kRound / 2) },
  capsule: { geometry: (one) => along(one.axis, new CapsuleGeometry(one.radius, 2 * one.half_length, 8, kRound)) },
  cylinder: { geometry: (one) => along(one.axis, new CylinderGeometry(one.radius, one.radius, 2 * one.half_length, kRound)) },
  hull: { geometry: ({ points }) => new ConvexGeometry(corners_of(points)) },
  mesh: { geometry: faces },
});

const is_known = (body) => body.shape !== "box" && body.shape in kShapes;

/// body: {shape, size, …}: `size` are the edges of a box, or of the box around another shape. An unknown kind is drawn
/// as that box.
export const shape_of = (body) => (is_known(body) ? kShapes[body.shape] : kShapes.box);
/// Bodies of one key share a geometry, which is scaled by scale_of().
export const key_of = (body) => (is_known(body) ? `${body.shape} ${body.index}` : "box");
export const size_of = (body) => (body.size[0] > 0 ? body.size : [kUnknownEdge, kUnknownEdge, kUnknownEdge]);
export const scale_of = (body) => (is_known(body) ? [1, 1, 1] : size_of(body));
