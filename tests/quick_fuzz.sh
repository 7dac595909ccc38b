#!/bin/sh
# Some random scenes and damaged files, always the same: see tests/fuzz.
#   quick_fuzz.sh CONTACT PARAMETERS MESHES
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
exec "$(dirname -- "$0")/fuzz/fuzz.py" --quick --least 0.8 --output fuzz "$1"
