// A page that draws a .glb at a share of its animation; bundled by gltf.test.js.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

window.show = async (base64, share) => {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer, "");
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(window.innerWidth, window.innerHeight);
  document.body.append(renderer.domElement);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x9db4c8);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x806040, 1), gltf.scene);
  const [clip] = gltf.animations;
  const mixer = new THREE.AnimationMixer(gltf.scene);
  mixer.clipAction(clip).play();
  mixer.setTime(clip.duration * share);
  const [camera] = gltf.cameras;
  camera.aspect = window.innerWidth / window.innerHeight;
  camera.updateProjectionMatrix();
  scene.updateMatrixWorld(true);
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const colours = new Set(new Uint32Array(pixels.buffer));
  let meshes = 0;
  gltf.scene.traverse((node) => (meshes += node.isMesh ? 1 : 0));
  return { meshes, tracks: clip.tracks.length, camera: camera.isPerspectiveCamera === true, colours: colours.size };
};
