#!/usr/bin/env bash
# assimp takes an animation channel that points at a property for one that moves a node.
#
# Expected: a channel whose target has no node is left out by who does not know the extension that it needs
#   ("When undefined, the animated object MAY be defined by an extension", glTF 2.0, animation.channel.target.node).
# Happens: a channel of KHR_animation_pointer that switches the visibility of the second node comes out as keys of
#   position of the first one, made of what stands where the booleans are.
# Versions: assimp 5.2.5 as packaged in Debian 12 (assimp-utils 5.2.5~ds0-1+b1).
# Matters: what shows and hides things by KHR_node_visibility may move others in programs that read by assimp. Channels
#   of that kind in an animation of their own leave the rest alone. (VTK 9.1 of Debian 12, which f3d 1.3 reads by, leaves
#   out the whole animation that has such a channel, and is content with the others likewise.)
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
points = struct.pack('<9f', 0, 0, 0, 1, 0, 0, 0, 1, 0)
times = struct.pack('<2f', 0, 1)
flags = bytes([1, 0]) + bytes(62)  # two booleans; the rest is so long that who reads more reads nothing else
data = points + times + flags
json.dump({
    'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0, 1]}],
    'extensionsUsed': ['KHR_node_visibility', 'KHR_animation_pointer'],
    'nodes': [{'name': 'stands', 'mesh': 0},
              {'name': 'goes', 'mesh': 0, 'extensions': {'KHR_node_visibility': {'visible': True}}}],
    'meshes': [{'primitives': [{'attributes': {'POSITION': 0}}]}],
    'animations': [{
        'name': 'visibility',
        'samplers': [{'input': 1, 'output': 2, 'interpolation': 'STEP'}],
        'channels': [{'sampler': 0, 'target': {'path': 'pointer', 'extensions': {'KHR_animation_pointer': {
            'pointer': '/nodes/1/extensions/KHR_node_visibility/visible'}}}}]}],
    'accessors': [
        {'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 0]},
        {'bufferView': 1, 'componentType': 5126, 'count': 2, 'type': 'SCALAR', 'min': [0], 'max': [1]},
        {'bufferView': 2, 'componentType': 5121, 'count': 2, 'type': 'SCALAR'}],
    'bufferViews': [
        {'buffer': 0, 'byteOffset': 0, 'byteLength': 36},
        {'buffer': 0, 'byteOffset': 36, 'byteLength': 8},
        {'buffer': 0, 'byteOffset': 44, 'byteLength': 2}],
    'buffers': [{'byteLength': len(data),
                 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()}],
}, open('visibility.gltf', 'w'))
SCRIPT
assimp dump visibility.gltf visibility.assxml || exit 2
python3 - <<'SCRIPT'
import re, sys
text = open('visibility.assxml').read()
moved = re.findall(r'<NodeAnim node="([^"]*)">(.*?)</NodeAnim>', text, re.S)
keys = {name: len(re.findall(r'<PositionKey time', body)) for name, body in moved}
print('nodes that are moved, and their keys of position:', keys or 'none')
same = keys == {'stands': 2}
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
