#!/usr/bin/env bash
# VTK's importer of Wavefront OBJ does not read the line that names the materials.
#
# Expected: "mtllib paint.mtl" in scene.obj says where the materials are; a file of that name stands beside it.
# Happens: vtkOBJImporter, told the .obj alone, looks for "scene.obj.mtl" and nothing else. It draws in white and says that
#   the material is not in the MTL file, which it has not looked at.
# Versions: VTK 9.1.0 as packaged in Debian 12 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1).
# Matters: sequences that share one .mtl come without colours. Name the library as the file with ".mtl" added, and "mtllib"
#   too: then all readers find it. Or call SetFileNameMTL.
set -euo pipefail

version='9.1.0+really9.1.0+dfsg2-5+deb12u1'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Only what this machine lacks is downloaded; nothing is installed.
mkdir -p archives/partial unpacked && chmod -R 777 archives
apt-get install --quiet --yes --download-only --no-install-recommends --option Debug::NoLocking=1 \
  --option "Dir::Cache::archives=$folder/archives" "python3-vtk9=$version" >download.log 2>&1 ||
  { cat download.log; exit 2; }
for package in archives/*.deb; do [[ -f "$package" ]] && dpkg -x "$package" unpacked; done
export LD_LIBRARY_PATH="$(find "$folder/unpacked" -type d -path '*-linux-gnu*' | tr '\n' ':')${LD_LIBRARY_PATH:-}"
export PYTHONPATH="$folder/unpacked/usr/lib/python3/dist-packages"

printf 'newmtl red\nKa 0 0 0\nKd 1 0 0\nKs 0 0 0\nd 1\nillum 1\n' >paint.mtl
printf 'mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n' >scene.obj
cp scene.obj other.obj && cp paint.mtl other.obj.mtl
/usr/bin/python3 - 2>errors.txt <<'SCRIPT' || { cat errors.txt; exit 2; }
from vtkmodules.vtkIOImport import vtkOBJImporter
import vtkmodules.vtkRenderingOpenGL2
with open('colours.txt', 'w') as file:
    for name in ('scene.obj', 'other.obj'):
        importer = vtkOBJImporter()
        importer.SetFileName(name)
        importer.Update()
        actors = importer.GetRenderer().GetActors()
        actors.InitTraversal()
        colour = actors.GetNextActor().GetProperty().GetDiffuseColor()
        file.write(' '.join(f'{part:g}' for part in colour) + '\n')
SCRIPT
first="$(sed -n 1p colours.txt)" second="$(sed -n 2p colours.txt)"
echo "red of the library that is named in the file is drawn as: $first"
echo "red of a library that is called as the file is drawn as:  $second"
grep --only-matching "material 'red'.*" errors.txt | head -1 || true
if [[ "$first" != '1 0 0' && "$second" == '1 0 0' ]]; then echo 'as described'; else echo 'not as described'; exit 1; fi
