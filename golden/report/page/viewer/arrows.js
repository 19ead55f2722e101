// Contacts as arrows along their normals: as long as the square root of their impulse, relative to the largest.
import { ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import { largest } from "../theme.js";

const kLengthOverDistance = 0.07;  // of the longest arrow, of the camera's distance
const kShortest = 0.25;            // of the longest

/// colour: of all arrows. thick: of a contact's arrow, relative to the usual one.
export function make_arrows(colour, thickness) {
  const group = new Group();
  const shaft = new CylinderGeometry(0.5, 0.5, 1, 6).translate(0, 0.5, 0);
  const tip = new ConeGeometry(0.5, 1, 10).translate(0, 0.5, 0);
  const look = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true, opacity: 0.9 });
  let meshes = [];
  return {
    group,
    /// list: [{at: [x, y, z], normal: [x, y, z], impulse}].
    show(list, distance) {
      for (const mesh of meshes) {
        group.remove(mesh);
        mesh.dispose();
      }
      meshes = [];
      if (list.length === 0) return;
      const [shafts, tips] = meshes = [shaft, tip].map((part) => new InstancedMesh(part, look, list.length));
      const longest = kLengthOverDistance * distance;
      const most = largest([...list.map((one) => one.impulse), 1e-30]);
      const up = new Vector3(0, 1, 0);
      const matrix = new Matrix4();
      list.forEach(({ at, normal, impulse }, i) => {
        const length = longest * Math.max(kShortest, Math.sqrt(Math.max(0, impulse) / most));
        const turn = new Quaternion().setFromUnitVectors(up, new Vector3(...normal).normalize());
        const foot = new Vector3(...at);
        const thick = longest * 0.05 * thickness;
        shafts.setMatrixAt(i, matrix.compose(foot, turn, new Vector3(thick, length * 0.7, thick)));
        const head = new Vector3(0, length * 0.7, 0).applyQuaternion(turn).add(foot);
        tips.setMatrixAt(i, matrix.compose(head, turn, new Vector3(thick * 3.4, length * 0.3, thick * 3.4)));
      });
      for (const mesh of meshes) {
        mesh.frustumCulled = false;
        mesh.renderOrder = 3;
        group.add(mesh);
      }
    },
  };
}
