// Run by node: reads a .glb as the web does, and writes where every vertex that is drawn is.
//
// node read_glb.mjs three|babylon|validate MODULES FILE FRAMES RATE OUT
// MODULES is a folder node_modules with the reader. Writes a line "FRAME NODE x y z" for each corner of a triangle, cm,
// z up; what it draws when nothing is played has the frame -1. `validate` writes the errors and warnings it finds.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [reader, modules, file, frames, rate, out] = process.argv.slice(2);
const require = createRequire(join(modules, 'read_glb.js'));
const bytes = readFileSync(file);
const lines = [];

// glTF has y up; ours are x, -z, y of its.
function add(frame, name, x, y, z) {
  lines.push(`${frame} ${name} ${100 * x} ${-100 * z} ${100 * y}`);
}

async function validate() {
  const report = await require('gltf-validator').validateBytes(new Uint8Array(bytes));
  for (const {severity, code, message, pointer} of report.issues.messages) {
    if (severity < 2) lines.push(`${severity} ${code} ${pointer} ${message}`);
  }
}

async function readByThree() {
  globalThis.self = globalThis;
  const path = (...names) => pathToFileURL(join(modules, 'three', ...names)).href;
  const THREE = await import(path('build', 'three.module.js'));
  const {GLTFLoader} = await import(path('examples', 'jsm', 'loaders', 'GLTFLoader.js'));
  const loaded = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
  const mixer = new THREE.AnimationMixer(loaded.scene);
  if (loaded.animations.length > 0) {
    const action = mixer.clipAction(loaded.animations[0]);
    action.setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
  }
  const point = new THREE.Vector3();
  const draw = (frame) => {
    loaded.scene.updateMatrixWorld(true);
    loaded.scene.traverseVisible((thing) => {
      if (!thing.isMesh || thing.matrixWorld.determinant() === 0) return;
      // A mesh of several materials is a group with the node's name.
      const name = thing.parent.isGroup ? thing.parent.name : thing.name;
      const index = thing.geometry.index;
      for (let i = 0; i < index.count; ++i) {
        thing.getVertexPosition(index.getX(i), point).applyMatrix4(thing.matrixWorld);
        add(frame, name, point.x, point.y, point.z);
      }
    });
  };
  draw(-1);
  if (loaded.animations.length > 0) mixer.clipAction(loaded.animations[0]).play();
  for (let frame = 0; frame < frames; ++frame) {
    mixer.setTime(Math.fround(frame / rate));
    draw(frame);
  }
}

async function readByBabylon() {
  const path = (name) => pathToFileURL(join(modules, '@babylonjs', name)).href;
  const BABYLON = await import(path('core/index.js'));
  await import(path('loaders/glTF/index.js'));
  BABYLON.Logger.LogLevels = BABYLON.Logger.NoneLogLevel;
  const scene = new BABYLON.Scene(new BABYLON.NullEngine());
  scene.useRightHandedSystem = true;
  const where = 'data:base64,' + bytes.toString('base64');
  await BABYLON.SceneLoader.AppendAsync('', where, scene, undefined, '.glb');
  const groups = scene.animationGroups;
  groups.forEach((group) => group.stop());
  const draw = (frame) => {
    for (const mesh of scene.meshes) {
      const world = mesh.computeWorldMatrix(true);
      if (mesh.getTotalVertices() === 0 || !mesh.isEnabled() || !mesh.isVisible || world.determinant() === 0) continue;
      const points = mesh.getVerticesData('position');
      for (const at of mesh.getIndices()) {
        const point = BABYLON.Vector3.TransformCoordinates(BABYLON.Vector3.FromArray(points, 3 * at), world);
        add(frame, mesh.name.replace(/_primitive\d+$/, ''), point.x, point.y, point.z);
      }
    }
  };
  draw(-1);
  for (let frame = 0; frame < frames; ++frame) {
    for (const group of groups) {
      group.start(false, 1, group.from, group.to);
      group.pause();
      group.goToFrame(Math.fround(frame / rate) * group.targetedAnimations[0].animation.framePerSecond);
    }
    draw(frame);
  }
}

await {three: readByThree, babylon: readByBabylon, validate}[reader]();
writeFileSync(out, lines.map((line) => line + '\n').join(''));
process.exit(0);
