#!/usr/bin/env bash
# LAMMPS: two atoms whose bond breaks fly apart with more energy than there was.
#
# Expected: `fix bond/break` takes a bond away. What the bond had stored is lost, so the energy falls.
# Happens: with the usual special_bonds (bonded atoms feel no pair force) the pair force is there at once, at full
#   strength, where the bond was. Two atoms that stand within its reach get its energy for nothing, and no word is said.
# Versions: LAMMPS 29 Sep 2021 update 2 as packaged in Debian 12 (lammps 20220106.git7586adbb6a+ds1-2+b2).
# Matters: fragments of a lattice drive each other apart, and one break sets off the next. Let the reach of the pair
#   force end below the length at which bonds break; or use bond_style quartic, which tests each bond in each step.
set -euo pipefail

version='20220106.git7586adbb6a+ds1-2+b2'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Only what this machine lacks is downloaded; nothing is installed.
mkdir -p archives/partial unpacked && chmod -R 777 archives
apt-get install --quiet --yes --download-only --no-install-recommends --option Debug::NoLocking=1 \
  --option "Dir::Cache::archives=$folder/archives" "lammps=$version" >download.log 2>&1 ||
  { cat download.log; exit 2; }
for package in archives/*.deb; do [[ -f "$package" ]] && dpkg -x "$package" unpacked; done
export LD_LIBRARY_PATH="$(find "$folder/unpacked" -type d -path '*-linux-gnu*' | tr '\n' ':')${LD_LIBRARY_PATH:-}"
lmp="$folder/unpacked/usr/bin/lmp"
[[ -x "$lmp" ]] || lmp="$(command -v lmp)" || exit 2

cat >two.data <<'DATA'
two atoms

2 atoms
1 bonds
1 atom types
1 bond types

-10 10 xlo xhi
-10 10 ylo yhi
-10 10 zlo zhi

Masses

1 1

Atoms # bond

1 1 1 -0.55 0 0
2 1 1 0.55 0 0

Bonds

1 1 1 2
DATA
# The bond is 1 long at rest and breaks at 1.09; it is 1.1 long. The pair force reaches to 1.5.
cat >two.in <<'INPUT'
units lj
boundary f f f
atom_style bond
special_bonds lj/coul 0 1 1
read_data two.data extra/special/per/atom 8
pair_style soft 1.5
pair_coeff 1 1 100 1.5
bond_style harmonic
bond_coeff 1 50 1
comm_modify cutoff 4
timestep 0.0001
fix move all nve
fix break all bond/break 10 1 1.09
thermo 100
thermo_style custom step ke ebond epair etotal
thermo_modify norm no
run 5000
INPUT
OMP_NUM_THREADS=1 "$lmp" -in two.in -log none >out.txt 2>&1 || { tail -5 out.txt; exit 2; }
python3 - <<'SCRIPT'
import sys
rows = []
for line in open('out.txt'):
    words = line.split()
    if len(words) == 5 and words[0].isdigit():
        rows.append([float(word) for word in words])
print('step, moving, in the bond, in the pair force, in all:')
for row in rows[:2] + rows[-1:]:
    print('  ' + ', '.join(f'{number:g}' for number in row))
before, after = rows[0][4], rows[-1][4]
print(f'energy before the break {before:g}, after it {after:g}')
same = after > 10 * before > 0
print('as described' if same else 'not as described')
sys.exit(0 if same else 1)
SCRIPT
