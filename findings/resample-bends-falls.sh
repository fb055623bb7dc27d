#!/usr/bin/env bash
# glTF Transform's resample() moves what it calls lossless, and the more the finer the recording is.
#
# Expected: its documentation says that it is "losslessly deduplicating keyframes". A recorded fall has no two keys
#   alike, so all should stay; at worst one would expect errors up to the option `tolerance`, 1e-4.
# Happens: a key is dropped when it lies within the tolerance of the straight line between its two neighbours, one
#   of which was itself the end of a line before. The tolerance is absolute, in units of the file (metres). At 120
#   frames a second every key of a free fall stays. At 1000 frames a second 25 of 501 are left, and the body is up to
#   0.54 mm, five tolerances, from where it was recorded. A tremor of 0.04 mm is gone at any rate.
# Versions: @gltf-transform/core and @gltf-transform/functions 4.5.1.
# Matters: breaking is recorded at hundreds to thousands of frames a second, and shards of a dish are millimetres.
#   Programs that shrink a .glb offer this step as harmless. Pass a smaller tolerance, or leave the step out.
set -euo pipefail

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --ignore-scripts \
  @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1 || exit 2

cat > fall.mjs <<'SCRIPT'
import { Document } from '@gltf-transform/core';
import { resample } from '@gltf-transform/functions';

/** Keys left of a recorded motion after resample(), and how far it then is from the record at most, m. */
async function resampled(framesPerSecond, heightAt, options) {
  const count = Math.round(0.5 * framesPerSecond) + 1;
  const times = Float32Array.from({ length: count }, (_, i) => i / framesPerSecond);
  const places = new Float32Array(3 * count);
  times.forEach((time, i) => (places[3 * i + 1] = heightAt(time, i)));
  const file = new Document();
  const buffer = file.createBuffer();
  const accessor = (array, type) => file.createAccessor().setArray(array).setType(type).setBuffer(buffer);
  const node = file.createNode('cup');
  file.createScene().addChild(node);
  const sampler = file.createAnimationSampler().setInterpolation('LINEAR')
    .setInput(accessor(times, 'SCALAR')).setOutput(accessor(places.slice(), 'VEC3'));
  const animation = file.createAnimation('fall').addSampler(sampler).addChannel(
    file.createAnimationChannel().setTargetNode(node).setTargetPath('translation').setSampler(sampler));
  await file.transform(resample(options));
  const left = animation.listChannels()[0].getSampler();
  const keys = left.getInput().getArray(), values = left.getOutput().getArray();
  let worst = 0;
  for (let i = 0; i < count; ++i) {
    let k = 1;
    while (k < keys.length - 1 && keys[k] < times[i]) ++k;
    const share = keys.length > 1 ? (times[i] - keys[k - 1]) / (keys[k] - keys[k - 1]) : 0;
    const low = values[3 * (k - 1) + 1], high = keys.length > 1 ? values[3 * k + 1] : low;
    worst = Math.max(worst, Math.abs(low + share * (high - low) - places[3 * i + 1]));
  }
  return { count, left: keys.length, worst };
}

const fall = (time) => 1.25 - 0.5 * 9.81 * time * time;
const seen = {};
for (const rate of [120, 240, 500, 1000]) {
  seen[rate] = await resampled(rate, fall);
  console.log(`free fall, ${rate} frames a second: ${seen[rate].left} of ${seen[rate].count} keys left, ` +
    `off by up to ${(1e3 * seen[rate].worst).toFixed(3)} mm`);
}
const tremor = await resampled(120, (_, i) => 4e-5 * Math.sin(i));
console.log(`tremor of 0.04 mm: ${tremor.left} of ${tremor.count} keys left`);
const asked = await resampled(1000, fall, { tolerance: 1e-9 });
console.log(`free fall, 1000 frames a second, tolerance 1e-9: ${asked.left} of ${asked.count} keys left`);
const same = seen[120].left === 61 && seen[1000].left < 50 && seen[1000].worst > 4e-4 && tremor.left === 2 &&
  asked.worst < 1e-6;
console.log(same ? 'as described' : 'not as described');
process.exit(same ? 0 : 1);
SCRIPT
node fall.mjs
