#!/bin/sh
# Every kind of wrong input ends with exit status 2 and one message that says
# what is wrong, where, and what to do; results of an earlier run stay as they
# are.
#   bad_input.sh CONTACT PARAMETERS MESHES
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
parameters=$2
meshes=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

good=$parameters/ssnp154_e.prm
failures=0

# expect TEXT ARGUMENT...: the message contains TEXT
launcher=
expect() {
  text=$1
  shift
  status=0
  $launcher "$contact" "$@" --quiet >out 2>err || status=$?
  if [ "$status" -ne 2 ]; then
    echo "FAILED: exit status $status instead of 2 for: $*"
  elif ! grep -qiF -- "$text" err; then
    echo "FAILED: no '$text' in the message for: $*"
    cat err
  elif ! grep -q '^where: ' err || ! grep -q '^remedy: ' err; then
    echo "FAILED: the message lacks place or remedy for: $*"
    cat err
  elif [ "$(grep -c '^error: ' err)" -ne 1 ]; then
    echo "FAILED: more than one message for: $*"
    cat err
  else
    echo "ok: $text"
    return 0
  fi
  failures=$((failures + 1))
}

# expect_entry TEXT ASSIGNMENT: one wrong entry in a good case
expect_entry() {
  expect "$1" "$good" --set "$2"
}

# Results of a good run, which no bad one may touch. It puts no directory of Open
# MPI's beside those of other runs, from under which they could remove it.
TMPDIR=/proc/none "$contact" "$good" --quiet >/dev/null
find output -type f -exec cksum {} + | sort >before

# A place close to a round slave, beside it on the third mesh
expect "beside it on a refined one" "$parameters/nested.prm" \
  --set "Output/Directory=beside" --set "Refinement/Levels=2" \
  --set "Mesh/Points=P in Cylinder: 5, 0.27" --set "Probes/Probes=p: pressure, P" \
  --set "Probes/References=" --set "Probes/Tolerances="

# Materials
body=Block
expect_entry "no yield stress" "Solids/Material=$body: elastic-plastic"
expect_entry "but not elastic-plastic" "Solids/Hardening modulus=$body: 1"
expect_entry "not allowed for Solids/Kinematics" "Solids/Kinematics=$body: medium"
expect_entry "but not in" "Solids/Kinematics=$body: small strain"
expect "is one of large displacement" "$good" \
  --set "Solids/Material=$body: neo-Hookean" --set "Solids/Kinematics=small strain"
expect "no thermal strain of the elastic-plastic" "$good" \
  --set "Solids/Material=$body: elastic-plastic" --set "Solids/Yield stress=$body: 1" \
  --set "Solids/Thermal strain=$body: 1e-3*t"
expect_entry "neo-Hookean, Mooney-Rivlin" "Solids/Material=$body: plastic"
expect "does not yield" "$good" --set "Solids/Material=$body: neo-Hookean" \
  --set "Solids/Yield stress=$body: 1"

# Entries
printf 'include %s\nsubsection Contact\n  set Slaev = a\nend\n' "$good" >a.prm
expect "did you mean 'Slave'" a.prm
printf 'include %s\nsubsection Contcat\n  set Slave = a\nend\n' "$good" >b.prm
expect "did you mean 'Contact'" b.prm
printf 'subsection Element\n set Degree = 1\n set Degree = 1\nend\n' >c.prm
expect "twice" c.prm
expect_entry "Young's modulus" "Solids/Young's modulus=Block: 0, Cylinder: 1"
expect_entry "Poisson's ratio" "Solids/Poisson's ratio=Block: .5, Cylinder: .3"
expect_entry "Friction coefficient" "Contact/Friction coefficient=-0.1"
expect_entry "Degree" "Element/Degree=3"
expect_entry "Increments" "Solution/Increments=0"
expect_entry "Centre node" "Element/Centre node=free"
expect_entry "such as 'N': they are in N per mm of thickness" \
  "Boundary conditions/Force y=Force: -100 N"
expect_entry "such as 'GPa': they are in MPa" \
  "Solids/Young's modulus=Block: 70 GPa, Cylinder: 210000"
expect_entry "such as 'MPa'" "Boundary conditions/Pressure=Top_B: 25 MPa"
expect_entry "write if(condition, a, b)" \
  "Boundary conditions/Histories=Force y: t<0.5?0:1"
expect_entry "'Cylindre': write the name of the mesh in both" \
  "Solids/Poisson's ratio=Block: 0.3, Cylindre: 0.3"
expect "no parameter file" "$scratch/missing.prm"
expect "option" "$good" --sett

# JSON
printf '{"include": "%s",\n"Contact": {"Slaev": "a"}}' "$good" >a.json
expect "a.json:2" a.json
expect "did you mean 'Slave'" a.json
printf '{"Element": {\n  "Degree": 1,\n}}' >b.json
expect "b.json:3:1" b.json
printf '{"Element": {"Degree": 1, "Degree": 1}}' >c.json
expect "twice" c.json
printf '{"include": "%s", "Element": {"Degree": [1]}}' "$good" >d.json
expect "an array where" d.json
printf '{"include": "%s", "Element": {"Degree": 3}}' "$good" >e.json
expect "any one of automatic, 1, 2" e.json
head -c 200000 /dev/zero | tr '\0' '[' >f.json
expect "inside each other" f.json

# A byte-order mark, as editors write it, is no part of a text.
printf '\357\273\277include marked_too.prm\n' >marked.prm
printf '\357\273\277subsection Element\n set Degree = 3\nend\n' >marked_too.prm
expect "marked_too.prm:2" marked.prm
printf '\357\273\277{"Element":\n {"Degree": 3}}' >marked.json
expect "marked.json:2" marked.json
{
  printf '\357\273\277'
  cat "$meshes/ssnp154.msh"
} >marked.msh
expect "Top_B" "$good" --set Mesh/File=marked.msh --set Contact/Slave=Botom_C

# Meshes
expect_entry "missing.msh" "Mesh/File=missing.msh"
head -c 5000 "$meshes/ssnp154.msh" >truncated.msh
expect_entry "truncated.msh" "Mesh/File=truncated.msh"
printf '$MeshFormat\n4.1 1 8\n' >binary.msh
expect_entry "binary" "Mesh/File=binary.msh"
printf '$MeshFormat\n3 0 8\n$EndMeshFormat\n' >version.msh
expect_entry "version" "Mesh/File=version.msh"
cat >tangled.msh <<'MSH'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "Block"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 1 1 0
$EndNodes
$Elements
1
1 3 2 1 1 1 2 3 4
$EndElements
MSH
expect_entry "element 1" "Mesh/File=tangled.msh"

# A cell or an edge twice in a group, a middle node that is not there
mesh_of() {
  cat <<MSH
\$MeshFormat
2.2 0 8
\$EndMeshFormat
\$PhysicalNames
2
1 1 "Ground"
2 2 "Block"
\$EndPhysicalNames
\$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 .5 0 0
6 1 .5 0
7 .5 1 0
8 0 .5 0
\$EndNodes
\$Elements
3
1 1 2 1 1 1 2
2 16 2 2 1 1 2 3 4 5 6 7 $1
$2
\$EndElements
MSH
}
mesh_of 8 "3 16 2 2 1 2 3 4 1 6 7 8 5" >cell_twice.msh
expect_entry "'Block' has the corners of element 2" "Mesh/File=cell_twice.msh"
mesh_of 8 "3 1 2 1 1 2 1" >edge_twice.msh
expect_entry "'Ground' has the corners of element 1" "Mesh/File=edge_twice.msh"
mesh_of 9 "3 15 2 0 1 1" >no_middle.msh
expect_entry "node 9 does not exist" "Mesh/File=no_middle.msh"

# Groups
expect_entry "Top_B" "Contact/Slave=Botom_C"
expect_entry "Encast" "Boundary conditions/Displacement y=Base: 0"
expect_entry "Cylinder" "Solids/Young's modulus=Block: 70000, Cylinder: 1, X: 1"
expect "with itself" "$good" --set "Contact/Master=Bottom_C" \
  --set "Contact/Discretization=Gauss"
expect_entry "Middle" "Probes/Probes=DY(B): displacement y, Middle; SIYY(B): stress yy, B"

# The place of the mesh
expect_entry "Mesh/Scale" "Mesh/Scale=0"
expect_entry "Mesh/Scale" "Mesh/Scale=1e200"
expect_entry "Mesh/Scale" "Mesh/Scale=1e-200"
expect_entry "Mesh/Refinements" "Mesh/Refinements=30"
expect_entry "above 0.01" "Solution/Newton tolerance=0.5"
expect_entry "above 0.1" "Solution/Geometry tolerance=1"
expect_entry "shift of the mesh" "Mesh/Shift=1"
expect_entry "move of 'Cylinder'" "Mesh/Move=Cylinder: 1"
expect_entry "no body 'Ball'" "Mesh/Move=Ball: 0, 1"
expect_entry "Contact/Augmentation parameter" "Contact/Augmentation parameter=0"

# Choices that exclude each other with a linear system
gauss=$parameters/ssnp154_a.prm
friction=$parameters/ssnp154_g.prm
condensed=Solution/System=condensed
saddle="Solution/System=saddle point"
expect "has triangles" "$good" --set Refinement/Strategy=adaptive \
  --set Refinement/Levels=1
expect "multipliers of the discretization Gauss" "$gauss" \
  --set "Solution/Linear solver=AMG"
expect "multipliers of the discretization Gauss" "$gauss" --set "$condensed"
expect "Refinement/Levels" "$gauss" --set Refinement/Levels=1
expect "Nested iteration" "$good" --set Refinement/Levels=1 --set "$saddle"
expect "CHOLMOD cannot solve it" "$good" --set "$saddle" \
  --set "Solution/Linear solver=CHOLMOD"
expect "UMFPACK is for saddle point" "$good" --set "$condensed" \
  --set "Solution/Linear solver=UMFPACK"
expect "There is a master and an obstacle" "$good" \
  --set "Contact/Obstacle=half plane: 0, 0, 0, 1"
expect "is no obstacle with these numbers" "$good" --set Contact/Master= \
  --set "Contact/Obstacle=circle: 0, 0"
expect "A contact pair has no surfaces" "$good" --set "Contact second/Discretization=nodal"
expect "no pressure of contact at the point 'Force': it is on no slave" "$good" \
  --set "Probes/Probes=p: pressure, Force" --set Probes/References= \
  --set Probes/Tolerances=
expect "where:  Probes/Probes, 'p'" "$good" \
  --set "Probes/Probes=p: pressure, Force" --set Probes/References= \
  --set Probes/Tolerances=
expect "projections move" "$good" --set Contact/Discretization=mortar \
  --set "$condensed" --set Solution/Geometry=Newton
expect "projections move" "$good" --set "$condensed" \
  --set Solution/Geometry=Newton

# Loads, geometry and theories
expect_entry "is no formula in t" "Boundary conditions/Histories=Force y: 2*"
expect_entry "is not a number at t" "Boundary conditions/Histories=Force y: sqrt(-t)"
expect_entry "is infinite at t = 1" "Boundary conditions/Histories=Force y: 1/(t-1)"
expect_entry "is not a number at x,y" "Boundary conditions/Pressure=Top_B: sqrt(-1)"
expect_entry "t does not grow" "Boundary conditions/Histories=Force y: table(0 0, 0 1)"
expect_entry "'Force w' has no history" "Boundary conditions/Histories=Force w: t"
expect_entry "no direction z" "Boundary conditions/Histories=Force z: t"
expect_entry "no direction z" "Boundary conditions/Traction z=Cap: 1"
expect_entry "is no surface" "Mesh/Spheres=Cap: 0, 0, 0, 1"
expect_entry "is no formula in x,y" "Boundary conditions/Pressure=Top_B: z"
expect "no boundary" "$good" --set "Boundary conditions/Pressure=Nowhere: 1"
expect_entry "undeformed" "Solution/Geometry=undeformed"
expect_entry "not below 1" "Solution/Linear tolerance=1"
expect_entry "quantity and a point or two" \
  "Probes/Probes=DY(B): displacement y, B, C, B"

# Symmetry; the section of the good case lies on both sides of x = 0 once it is
# shifted
expect "negative one" "$good" --set Solids/Symmetry=axisymmetric \
  --set "Mesh/Shift=-1, 0"
expect_entry "is no formula in x,y" "Boundary conditions/Traction y=Top_B: z"
expect_entry "is no formula in x,y" "Boundary conditions/Body force x=Block: z"
expect "no area" "$parameters/verification/sphere_on_plane.prm" \
  --set "Boundary conditions/Resultant force y=Axis: -1"
expect "glued in nodes" "$parameters/ssnp154_a.prm" --set Contact/Tied=true
expect_entry "no body" "Boundary conditions/Body force y=Top_B: 1"

expect "two cases have the name" "$good" "$good"
expect "multipliers that no point" "$parameters/ssnp154_b.prm" \
  --set "Contact/Gauss points=2"


# Two laws on one line, or a tie and contact on one node
expect "same lines as slave and master: how" "$good" \
  --set "Contact second/Slave=Bottom_C" --set "Contact second/Master=Top_B" \
  --set "Boundary conditions/Tied y="
expect "same lines as slave and master, swapped" "$good" \
  --set "Contact second/Slave=Top_B" --set "Contact second/Master=Bottom_C" \
  --set "Boundary conditions/Tied y="
expect "same surfaces as slave and master: how" "$parameters/nested_space.prm" \
  --set "Contact second/Slave=Bottom" --set "Contact second/Master=Top"
expect "is tied to the master" "$good" --set "Contact/Excluded points="

# A group of an outer line and of one between two cells
cat >inner.msh <<END
\$MeshFormat
2.2 0 8
\$EndMeshFormat
\$PhysicalNames
2
1 1 "Ground"
2 2 "Block"
\$EndPhysicalNames
\$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
\$EndNodes
\$Elements
4
1 3 2 2 1 1 2 5 4
2 3 2 2 1 2 3 6 5
3 1 2 1 2 1 2
4 1 2 1 3 2 5
\$EndElements
END
cat >inner.prm <<END
subsection Mesh
  set File = inner.msh
end
subsection Solids
  set Young's modulus = Block: 1
  set Poisson's ratio = Block: 0.3
end
subsection Boundary conditions
  set Displacement x = Ground: 0
  set Displacement y = Ground: 0
end
END
expect "'Ground' has also lines inside bodies" inner.prm

# Entries without effect are noted where the file itself sets them.
cat >idle.prm <<END
include $good
subsection Contact
  set Gauss points = 4
end
subsection Refinement
  set Fraction = 0.3
end
subsection Boundary conditions
  set Histories = Traction x: 2*t
end
END
"$contact" idle.prm --quiet --set Output/Directory=idle >/dev/null 2>idle.err ||
  echo "status $?"
if [ "$(grep -c "idle.prm.* has no effect" idle.err)" -eq 3 ]; then
  echo "ok: entries without effect"
else
  echo "FAILED: entries without effect"
  cat idle.err
  failures=$((failures + 1))
fi

# Several processes, one message
launcher="mpirun -np 2"
expect "discretization Gauss" "$gauss"
expect "by one process" "$good" --set "$saddle"
expect "CHOLMOD" "$good" --set "$condensed" \
  --set "Solution/Linear solver=CHOLMOD"
expect "has triangles" "$good" --set Refinement/Strategy=adaptive \
  --set Refinement/Levels=1
expect_entry "Degree" "Element/Degree=3"
expect_entry "Top_B" "Contact/Slave=Botom_C"
expect "body 'Cylinder' against: displacement in y" "$good" \
  --set "Contact/Slave=" --set "Contact/Master=" \
  --set "Contact/Excluded points=" --set "Boundary conditions/Tied y="
expect "moved differently" "$parameters/verification/stack.prm" \
  --set "Boundary conditions/Displacement x=Axis: 0, Top_3: 1"
launcher=

# Bodies that nothing holds
expect "body 'Cylinder' against: displacement in y" "$good" \
  --set "Contact/Slave=" --set "Contact/Master=" \
  --set "Contact/Excluded points=" --set "Boundary conditions/Tied y="
expect "body 'Block' against: displacement in y" "$good" \
  --set "Boundary conditions/Displacement y=Force: -1" \
  --set "Boundary conditions/Force y=" \
  --set "Contact/Slave=" --set "Contact/Master=" \
  --set "Contact/Excluded points=" --set "Boundary conditions/Tied y="

# Output: a directory below a file cannot be made, not even by root.
touch file
expect_entry "file" "Output/Directory=file/below"

# A former name of an entry or of a value goes on working, with a note, and so
# does a file with an entry that is no longer read.
cat >old.prm <<END
include $good
subsection Contact
  set Rule = nodal
end
subsection Probes
  set Hertz = 50, 35000
end
END
sed 's/Rule/Discretization/; /Hertz/d' old.prm >new.prm
for name in old new; do
  "$contact" $name.prm --quiet --set "Output/Directory=former" \
    --set "Output/VTU=false" --set "Output/Profile=false" >$name.table 2>$name.err ||
    echo "status $?"
  sed -i "s/^$name//" $name.table
done
if grep -q "Contact/Rule is now called 'Discretization'" old.err &&
  grep -q "Probes/Hertz is no longer read" old.err &&
  ! grep -qE "now called|longer" new.err && cmp old.table new.table; then
  echo "ok: a former name"
else
  echo "FAILED: a former name"
  cat old.err old.table new.table
  failures=$((failures + 1))
fi

find output -type f -exec cksum {} + | sort >after
cmp before after || {
  echo "FAILED: results of an earlier run were touched"
  failures=$((failures + 1))
}
[ "$failures" -eq 0 ]
