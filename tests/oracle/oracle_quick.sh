#!/bin/sh
# The oracle against closed forms and damaged results, then 40 of its scenes.
#   oracle_quick.sh CONTACT PARAMETERS MESHES
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
here=$(dirname -- "$0")
/usr/bin/python3 -c 'import numpy, scipy' 2>/dev/null || {
  echo "skipped: apt-get install python3-numpy python3-scipy"
  exit 0
}
"$here/test_fem.py"
exec "$here/oracle.py" --count 40 --seed 100 --variants 1 \
  --keep oracle "$1"
