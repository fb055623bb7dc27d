#!/usr/bin/env bash
# meshio cannot read a binary PLY whose faces have a number beside their vertices.
#
# Expected: "element face" with "property list uchar uint vertex_indices" and "property uint part" is plain PLY; each face
#   is a list and then a number, and the numbers come as cell data.
# Happens: all lists are looked for first, one after the other, without the numbers between them, and then one number. It
#   ends in a TypeError, whose words say nothing of the file.
# Versions: meshio 5.0.0 as packaged in Debian 12 (python3-meshio 7.0.0-3), and NumPy 1.24.2.
# Matters: give such numbers to the vertices, of which meshio reads any, or write the PLY as text.
set -euo pipefail

version='7.0.0-3'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Only what this machine lacks is downloaded; nothing is installed.
mkdir -p archives/partial unpacked && chmod -R 777 archives
apt-get install --quiet --yes --download-only --no-install-recommends --option Debug::NoLocking=1 \
  --option "Dir::Cache::archives=$folder/archives" "python3-meshio=$version" >download.log 2>&1 ||
  { cat download.log; exit 2; }
for package in archives/*.deb; do [[ -f "$package" ]] && dpkg -x "$package" unpacked; done
export LD_LIBRARY_PATH="$(find "$folder/unpacked" -type d -path '*-linux-gnu*' | tr '\n' ':')${LD_LIBRARY_PATH:-}"
export PYTHONPATH="$folder/unpacked/usr/lib/python3/dist-packages"

/usr/bin/python3 -W ignore - <<'SCRIPT'
import struct, sys
try:
    import meshio
except ImportError as problem:
    print(problem)
    sys.exit(2)
places = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
faces = [(0, 1, 2), (1, 3, 2)]
head = ('ply\nformat binary_little_endian 1.0\nelement vertex 4\n'
        'property float x\nproperty float y\nproperty float z\n'
        'element face {}\nproperty list uchar uint vertex_indices\n{}end_header\n')
def write(name, count, numbered):
    with open(name, 'wb') as file:
        file.write(head.format(count, 'property uint part\n' if numbered else '').encode())
        file.write(b''.join(struct.pack('<3f', *place) for place in places))
        for number, face in enumerate(faces[:count]):
            file.write(struct.pack('<B3I', 3, *face))
            if numbered:
                file.write(struct.pack('<I', number))
def read(name):
    try:
        mesh = meshio.read(name)
        return [[int(i) for i in face] for block in mesh.cells for face in block.data]
    except Exception as problem:
        return f'{type(problem).__name__}: {problem}'
write('plain.ply', 2, False)
write('one.ply', 1, True)
write('two.ply', 2, True)
plain, one, two = read('plain.ply'), read('one.ply'), read('two.ply')
print('two faces:                  ', plain)
print('one face with a number:     ', one)
print('two faces with a number each:', two)
right = [list(face) for face in faces]
same = plain == right and one != right[:1] and two != right
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
