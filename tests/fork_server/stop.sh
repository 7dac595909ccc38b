#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Stop the fork server of a socket, if there is one.
#
# Usage: stop.sh SOCKET
set -u
[ -f "$1.pid" ] && kill "$(cat "$1.pid")" 2>/dev/null
rm -f "$1" "$1.pid"
