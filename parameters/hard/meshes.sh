#!/bin/sh
# The meshes of the hard cases: in 2-D from blocks.geo, pin.geo and
# pin_whole.geo, in 3-D from tests/hard/space_meshes.py.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu
cd "$(dirname -- "$0")"
make() {
  geometry=$1
  name=$2
  shift 2
  gmsh -2 -format msh41 -v 1 "$@" -o "$name.msh" "../../meshes/$geometry.geo"
}
make blocks blocks -setnumber left -10
make blocks triangles -setnumber left -10 -setnumber triangles 1
make blocks fine_slave -setnumber left -10 -setnumber nx 80 -setnumber mx 8 \
  -setnumber ny 2 -setnumber my 3
make blocks fine_master -setnumber left -10 -setnumber nx 4 -setnumber mx 160 \
  -setnumber ny 2 -setnumber my 2
make blocks one -setnumber left -10 -setnumber nx 1 -setnumber ny 1 \
  -setnumber mx 1 -setnumber my 1
make blocks slider -setnumber left -19 -setnumber width 8 -setnumber nx 4 \
  -setnumber height 4 -setnumber ny 2 -setnumber mx 10 -setnumber my 4
make pin pin
make pin pin_loose -setnumber play 0.01
make pin_play pin_whole
make pin_tight pin_whole -setnumber play 0.001
../../tests/hard/space_meshes.py .
