#!/usr/bin/env bash
# assimp switches a shape key on that is off in the FBX.
#
# Expected: `DeformPercent` of a channel says how far its shape is on. At 0 the mesh is as it was modelled; the weight
#   that a reader hands on is 0, at 40 it is 0.4.
# Happens: of a channel with one shape, which is what Blender and Maya write, assimp hands on a weight of 1
#   (`aiAnimMesh::mWeight`), whatever the file says.
# Versions: assimp 5.2.5 as packaged in Debian 12 (libassimp5 5.2.5~ds0-1+b1), asked by its Python binding.
# Matters: a cup with a key for a wider rim comes with the wider rim. Who takes assimp's weights has another body, with
#   another volume and mass, than was modelled.
set -euo pipefail

version='5.2.5~ds0-1+b1'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir packages && chmod 777 packages
(cd packages && apt-get download --quiet "python3-pyassimp=${version%+*}" "libassimp5=$version" libdraco7 libminizip1 \
  zlib1g >/dev/null 2>download.log) || { cat packages/download.log; exit 2; }
for package in packages/*.deb; do dpkg -x "$package" unpacked; done
for percent in 0 40; do
  python3 - "$percent" <<'SCRIPT'
import sys
open(f'key{sys.argv[1]}.fbx', 'w').write(f'''; FBX 7.4.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}}
GlobalSettings:  {{
	Version: 1000
	Properties70:  {{
		P: "UnitScaleFactor", "double", "Number", "",1
	}}
}}
Objects:  {{
	Geometry: 100, "Geometry::body", "Mesh" {{
		Vertices: *12 {{
			a: 0,0,0,1,0,0,0,1,0,0,0,1
		}}
		PolygonVertexIndex: *12 {{
			a: 0,2,-2,0,1,-4,0,3,-3,1,2,-4
		}}
		GeometryVersion: 124
	}}
	Geometry: 300, "Geometry::tall", "Shape" {{
		Version: 100
		Indexes: *1 {{
			a: 3
		}}
		Vertices: *3 {{
			a: 0,0,5
		}}
		Normals: *3 {{
			a: 0,0,0
		}}
	}}
	Model: 200, "Model::body", "Mesh" {{
		Version: 232
	}}
	Deformer: 301, "Deformer::keys", "BlendShape" {{
		Version: 100
	}}
	Deformer: 302, "SubDeformer::tall", "BlendShapeChannel" {{
		Version: 100
		DeformPercent: {sys.argv[1]}
		FullWeights: *1 {{
			a: 100
		}}
	}}
}}
Connections:  {{
	C: "OO",200,0
	C: "OO",100,200
	C: "OO",301,100
	C: "OO",302,301
	C: "OO",300,302
}}
''')
SCRIPT
done
libraries="$(echo "$folder"/unpacked/usr/lib/*-linux-gnu*)"
LD_LIBRARY_PATH="$libraries" PYTHONPATH="$folder/unpacked/usr/lib/python3/dist-packages" python3 - "$libraries" <<'SCRIPT'
import ctypes, glob, sys
from pyassimp import structs
library = ctypes.CDLL(glob.glob(sys.argv[1] + '/libassimp.so.5*')[0])
library.aiImportFile.restype = ctypes.POINTER(structs.Scene)
library.aiImportFile.argtypes = [ctypes.c_char_p, ctypes.c_uint]
same = True
for percent in (0, 40):
    scene = library.aiImportFile(f'key{percent}.fbx'.encode(), 0)
    if not scene:
        sys.exit(2)
    weight = scene.contents.mMeshes[0].contents.mAnimMeshes[0].contents.mWeight
    print(f'DeformPercent {percent}: weight {weight}')
    same = same and weight == 1.0
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
