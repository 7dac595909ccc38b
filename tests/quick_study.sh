#!/bin/sh
# The quick study of accuracy against cost: proves the orders of convergence of
# the mortar rule in displacement, energy and pressure on concentric cylinders,
# that sticking ends where two half planes end it, that the reference of SSNP154
# lies within the published limits, and that tables and pictures are made. Its
# own small parts first.
#   quick_study.sh CONTACT PARAMETERS MESHES CLOSED_FORM_ERRORS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

study=$(CDPATH='' cd -- "$(dirname -- "$0")/study" && pwd)
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE

python3 "$study/test_report.py"
"$study/study.py" --quick --output study --parameters "$2" --closed-forms "$4" "$1"
"$study/report.py" "$study/results" --check-readme "$study/../.."
for file in study.csv study.md ssnp154_dy_front.svg rings_orders.png; do
  [ -s "study/$file" ] || { echo "study/$file is missing or empty" >&2; exit 1; }
done
