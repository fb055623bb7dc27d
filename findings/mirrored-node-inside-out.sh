#!/usr/bin/env bash
# assimp's converter turns what a glTF node mirrors inside out.
#
# Expected: a node of negative scale mirrors its mesh. glTF 2.0 says that the winding of its triangles is then
#   reversed, so that the outside stays outside. Who writes the mesh out with its transform applied has to reverse
#   the triangles.
# Happens: `assimp export` applies the transform and keeps the order of corners. A tetrahedron of volume +1/6 comes
#   out with -1/6: inside out, to everything that goes by winding.
# Versions: assimp 5.2.5 as packaged in Debian 12 (assimp-utils 5.2.5~ds0-1+b1).
# Matters: handles and spouts are often modelled once and mirrored. A body that is inside out has no inside, so
#   programs that fill it, measure it or collide with it refuse it or do the opposite.
set -euo pipefail

version='5.2.5~ds0-1+b1'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir packages && chmod 777 packages
(cd packages && apt-get download --quiet "assimp-utils=$version" "libassimp5=$version" libdraco7 libminizip1 \
  zlib1g >/dev/null 2>download.log) || { cat packages/download.log; exit 2; }
for package in packages/*.deb; do dpkg -x "$package" unpacked; done
assimp() {
  LD_LIBRARY_PATH="$(echo "$folder"/unpacked/usr/lib/*-linux-gnu*)" "$folder/unpacked/usr/bin/assimp" "$@" >/dev/null
}
python3 - <<'SCRIPT'
import base64, json, struct
places = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]  # counter-clockwise seen from outside
data = b''.join(struct.pack('<3f', *place) for place in places) + b''.join(struct.pack('<3H', *face) for face in faces)
json.dump({
    'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
    'nodes': [{'mesh': 0, 'scale': [-1, 1, 1]}],
    'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
    'accessors': [
        {'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 1]},
        {'bufferView': 1, 'componentType': 5123, 'count': 12, 'type': 'SCALAR'}],
    'bufferViews': [
        {'buffer': 0, 'byteOffset': 0, 'byteLength': 48, 'target': 34962},
        {'buffer': 0, 'byteOffset': 48, 'byteLength': 24, 'target': 34963}],
    'buffers': [{'byteLength': len(data),
                 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()}],
}, open('mirrored.gltf', 'w'))
SCRIPT
assimp export mirrored.gltf mirrored.obj || exit 2
python3 - <<'SCRIPT'
import sys
def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def dot(a, b):
    return sum(x * y for x, y in zip(a, b))
lines = [line.split() for line in open('mirrored.obj')]
places = [tuple(map(float, line[1:4])) for line in lines if line[:1] == ['v']]
faces = [[int(word.split('/')[0]) - 1 for word in line[1:]] for line in lines if line[:1] == ['f']]
volume = sum(dot(places[a], cross(places[b], places[c])) for a, b, c in faces) / 6
print(f'volume of the mirrored tetrahedron: {volume:+.4f} (positive where the outside is outside)')
same = abs(volume + 1 / 6) < 1e-6
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
