#!/usr/bin/env bash
# three.js no longer draws a skinned mesh once its bones are elsewhere than when it was first drawn.
#
# Expected: a mesh in front of the camera is drawn.
# Happens: the renderer leaves out what a sphere says is not in view; that of a skinned mesh is made when it is first
#   drawn, about its vertices as the bones have them then, and stays there when an animation moves the bones.
# Versions: three 0.187.0 (npm), with its own GLTFLoader.
# Matters: pieces of a thing that flies apart, made the bones of one skin to save nodes, vanish where they go, and all of
#   them at once. Give each a node with a mesh of its own, or set `frustumCulled` to false.
set -euo pipefail

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --ignore-scripts three@0.187.0 || exit 2
cat > check.mjs <<'SCRIPT'
import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

// Of a browser, what the loader asks for.
globalThis.self = globalThis;
globalThis.ProgressEvent = class extends Event {};

// A triangle with one bone, which falls by 10 m in a second.
const floats = (...numbers) => new Uint8Array(new Float32Array(numbers).buffer);
const parts = [
  floats(0, 0, 0, 1, 0, 0, 0, 1, 0),                                   // 0: positions
  new Uint8Array(12),                                                  // 36: bones
  floats(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0),                          // 48: weights
  floats(0, 1), floats(0, 0, 0, 0, -10, 0)];                           // 96: times, 104: places of the bone
const data = Buffer.concat(parts);
const view = (byteOffset, byteLength) => ({buffer: 0, byteOffset, byteLength});
const accessor = (bufferView, componentType, count, type, more) =>
  ({bufferView, componentType, count, type, ...more});
const gltf = {
  asset: {version: '2.0'}, scene: 0, scenes: [{nodes: [0, 1]}],
  nodes: [{name: 'bone'}, {name: 'thing', mesh: 0, skin: 0}],
  skins: [{joints: [0]}],
  meshes: [{primitives: [{attributes: {POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2}}]}],
  animations: [{samplers: [{input: 3, output: 4}], channels: [{sampler: 0, target: {node: 0, path: 'translation'}}]}],
  accessors: [accessor(0, 5126, 3, 'VEC3', {min: [0, 0, 0], max: [1, 1, 0]}), accessor(1, 5121, 3, 'VEC4'),
              accessor(2, 5126, 3, 'VEC4'), accessor(3, 5126, 2, 'SCALAR', {min: [0], max: [1]}),
              accessor(4, 5126, 2, 'VEC3')],
  bufferViews: [view(0, 36), view(36, 12), view(48, 48), view(96, 8), view(104, 24)],
  buffers: [{byteLength: data.length, uri: 'data:application/octet-stream;base64,' + data.toString('base64')}],
};
const loaded = await new GLTFLoader().parseAsync(JSON.stringify(gltf), '');
const scene = loaded.scene;
const mesh = scene.getObjectByProperty('isSkinnedMesh', true);
const mixer = new THREE.AnimationMixer(scene);
mixer.clipAction(loaded.animations[0]).play().setLoop(THREE.LoopOnce).clampWhenFinished = true;
const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 100);

// As WebGLRenderer decides what to draw.
function isDrawn(seconds) {
  mixer.setTime(seconds);
  scene.updateMatrixWorld(true);
  mesh.skeleton.update();
  const middle = mesh.getVertexPosition(0, new THREE.Vector3()).applyMatrix4(mesh.matrixWorld);
  camera.position.set(0.3, middle.y + 0.3, 8);
  camera.updateMatrixWorld(true);
  const frustum = new THREE.Frustum().setFromProjectionMatrix(
    new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
  const drawn = !mesh.frustumCulled || mesh.intersectsFrustum(frustum);
  console.log(`at ${seconds} s its first corner is at y = ${middle.y}, straight before the camera; drawn: ${drawn}`);
  return drawn;
}
const same = isDrawn(0) && !isDrawn(1);
console.log(same ? 'as described' : 'not as described');
process.exit(same ? 0 : 1);
SCRIPT
node check.mjs
