#!/usr/bin/env bash
# assimp reads the integers of a quantized glTF as floats, and says nothing.
#
# Expected: a glTF that lists `KHR_mesh_quantization` in `extensionsRequired` has positions of 8 or 16 bits. A reader that
#   doesn't know the extension must refuse the file ("extensionsRequired ... a client must support to load"); one that
#   does reads the integers.
# Happens: `assimp export` reads the bytes of 16-bit positions as if they were floats, and ends with 0. A tetrahedron of
#   100 x 200 x 300 comes out with corners of the order of 1e-38.
# Versions: assimp 5.2.5 as packaged in Debian 12 (assimp-utils 5.2.5~ds0-1+b1).
# Matters: gltfpack, and with it many web shops and add-ons, quantizes by default. The mesh is there, has its triangles, and
#   is smaller than an atom; who goes on with it looks for the fault in the mesh.
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
places = [(0, 0, 0), (100, 0, 0), (0, 200, 0), (0, 0, 300)]
faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
data = b''.join(struct.pack('<3hxx', *place) for place in places) + b''.join(struct.pack('<3H', *face) for face in faces)
json.dump({
    'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
    'extensionsUsed': ['KHR_mesh_quantization'], 'extensionsRequired': ['KHR_mesh_quantization'],
    'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
    'accessors': [
        {'bufferView': 0, 'componentType': 5122, 'count': 4, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [100, 200, 300]},
        {'bufferView': 1, 'componentType': 5123, 'count': 12, 'type': 'SCALAR'}],
    'bufferViews': [
        {'buffer': 0, 'byteOffset': 0, 'byteLength': 32, 'byteStride': 8, 'target': 34962},
        {'buffer': 0, 'byteOffset': 32, 'byteLength': 24, 'target': 34963}],
    'buffers': [{'byteLength': len(data),
                 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()}],
}, open('quantized.gltf', 'w'))
SCRIPT
assimp export quantized.gltf quantized.obj || { echo 'refused: not as described'; exit 1; }
python3 - <<'SCRIPT'
import sys
lines = [line.split() for line in open('quantized.obj')]
places = [tuple(map(float, line[1:4])) for line in lines if line[:1] == ['v']]
size = [max(place[axis] for place in places) - min(place[axis] for place in places) for axis in range(3)]
print(f'size: {size}, where 100 x 200 x 300 is right')
same = max(size) < 1
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
