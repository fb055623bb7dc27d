#!/usr/bin/env bash
# assimp's converter gives most facets of a plain tetrahedron normals that point into it.
#
# Expected: the mesh has no normals of its own, so a converter computes them, and an STL's "facet normal" is the
#   normal of that facet, out of the body by the order of its corners.
# Happens: corners that triangles share get the normal of one of these triangles, and the "facet normal" is the
#   mean of the three corners' normals. Of the four facets of a tetrahedron three state a normal that points
#   inwards, and the OBJ of the same mesh has two normals in all.
# Versions: assimp 5.2.5 as packaged in Debian 12 (assimp-utils 5.2.5~ds0-1+b1).
# Matters: viewers shade an STL by the normals it states, and some programs tell inside from outside by them. Go by
#   the order of corners, which is right, or write the normals into the glTF.
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
    'nodes': [{'mesh': 0}],
    'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
    'accessors': [
        {'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 1]},
        {'bufferView': 1, 'componentType': 5123, 'count': 12, 'type': 'SCALAR'}],
    'bufferViews': [
        {'buffer': 0, 'byteOffset': 0, 'byteLength': 48, 'target': 34962},
        {'buffer': 0, 'byteOffset': 48, 'byteLength': 24, 'target': 34963}],
    'buffers': [{'byteLength': len(data),
                 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()}],
}, open('plain.gltf', 'w'))
SCRIPT
assimp export plain.gltf plain.stl || exit 2
assimp export plain.gltf plain.obj || exit 2
python3 - <<'SCRIPT'
import re, sys
def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def dot(a, b):
    return sum(x * y for x, y in zip(a, b))
def less(a, b):
    return tuple(x - y for x, y in zip(a, b))
vector = r'(\S+) (\S+) (\S+)'
facet = f'facet normal {vector} outer loop vertex {vector} vertex {vector} vertex {vector}'
cosines = []
for numbers in re.findall(facet, re.sub(r'\s+', ' ', open('plain.stl').read())):
    normal, a, b, c = (tuple(map(float, numbers[i:i + 3])) for i in range(0, 12, 3))
    true = cross(less(b, a), less(c, a))
    cosines.append(dot(normal, true) / (dot(normal, normal) * dot(true, true)) ** 0.5)
print('cosine of stated and true normal of each facet:', ', '.join(f'{cosine:+.2f}' for cosine in cosines))
normals = sum(line.startswith('vn ') for line in open('plain.obj'))
print(f'normals in the OBJ: {normals}')
same = len(cosines) == 4 and sum(cosine < 0 for cosine in cosines) == 3 and normals == 2
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
