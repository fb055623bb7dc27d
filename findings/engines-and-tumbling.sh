#!/usr/bin/env bash
# Physics engines do not agree on a tile that spins about its middle axis: two of three leave out what turns it over.
#
# Expected: a free body whose three moments of inertia differ cannot spin steadily about the middle axis. By
#   Euler's equations, I dw/dt = -w x I w, the slightest tilt grows until the body turns over, again and again.
# Happens: in cannon-es, with no damping, the tile spins about that axis for ever. It has no option for it. In Jolt it does
#   so too, unless mApplyGyroscopicForce is set, which is off by default. In Rapier it turns over.
# Versions: cannon-es 0.20.0, jolt-physics 1.1.0, @dimforge/rapier3d-compat 0.21.0.
# Matters: shards are flat and are thrown spinning. Who takes exported shards into one of these engines, or compares with
#   it, sees them fly differently, with nothing wrong on either side of the exchange.
set -euo pipefail

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --ignore-scripts \
  cannon-es@0.20.0 jolt-physics@1.1.0 @dimforge/rapier3d-compat@0.21.0 || exit 2

cat > spin.mjs <<'SCRIPT'
import * as CANNON from 'cannon-es';
import RAPIER from '@dimforge/rapier3d-compat';
import initJolt from 'jolt-physics';

const half = [2, 0.5, 1]; // m: the middle moment of inertia is about z
const spin = [0.01, 0.01, 10]; // rad/s, a little tilted
const step = 1 / 240, seconds = 20;

/** What the third axis of the body's own frame has of the world's z: 1 as it began, -1 turned over. */
const upright = ({ x, y }) => 1 - 2 * (x * x + y * y);

/** Least value of upright() in the time, where advance() goes on by a step and answers the rotation. */
function least(advance) {
  let lowest = 1;
  for (let i = 0; i < seconds / step; ++i) lowest = Math.min(lowest, upright(advance()));
  return lowest;
}

function cannon() {
  const world = new CANNON.World();
  const body = new CANNON.Body({ mass: 1, shape: new CANNON.Box(new CANNON.Vec3(...half)), linearDamping: 0,
    angularDamping: 0, angularVelocity: new CANNON.Vec3(...spin) });
  world.addBody(body);
  return least(() => (world.step(step), body.quaternion));
}

async function rapier() {
  await RAPIER.init();
  const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
  world.timestep = step;
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setCanSleep(false)
    .setAngvel({ x: spin[0], y: spin[1], z: spin[2] }));
  world.createCollider(RAPIER.ColliderDesc.cuboid(...half), body);
  return least(() => (world.step(), body.rotation()));
}

async function jolt() {
  const Jolt = await initJolt();
  const settings = new Jolt.JoltSettings();
  settings.mMaxWorkerThreads = 0;
  const objects = new Jolt.ObjectLayerPairFilterTable(1);
  objects.EnableCollision(0, 0);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = objects;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, objects, 1);
  const world = new Jolt.JoltInterface(settings);
  world.GetPhysicsSystem().SetGravity(new Jolt.Vec3(0, 0, 0));
  const bodies = world.GetPhysicsSystem().GetBodyInterface();
  const run = (adjust) => {
    const made = new Jolt.BodyCreationSettings(new Jolt.BoxShape(new Jolt.Vec3(...half), 0.05),
      new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1), Jolt.EMotionType_Dynamic, 0);
    made.mLinearDamping = made.mAngularDamping = 0;
    made.mAllowSleeping = false;
    adjust(made);
    const body = bodies.CreateBody(made);
    bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
    body.SetAngularVelocity(new Jolt.Vec3(...spin));
    const lowest = least(() => {
      world.Step(step, 1);
      const turn = body.GetRotation();
      return { x: turn.GetX(), y: turn.GetY() };
    });
    bodies.RemoveBody(body.GetID());
    return lowest;
  };
  return [run(() => {}), run((made) => (made.mApplyGyroscopicForce = true))];
}

const [joltDefault, joltAsked] = await jolt();
const seen = { 'cannon-es': cannon(), 'Jolt, default': joltDefault, 'Jolt, asked for': joltAsked, Rapier: await rapier() };
for (const [name, lowest] of Object.entries(seen))
  console.log(`${name}: ${lowest < -0.9 ? 'turns over' : 'spins on'} (least cosine ${lowest.toFixed(6)} in ${seconds} s)`);
const same = seen['cannon-es'] > 0.99 && joltDefault > 0.99 && joltAsked < -0.9 && seen.Rapier < -0.9;
console.log(same ? 'as described' : 'not as described');
process.exit(same ? 0 : 1);
SCRIPT
node spin.mjs
