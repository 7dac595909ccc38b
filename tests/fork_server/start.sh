#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Start the fork server, see request.h, and wait until it listens. It ends with
# stop.sh, or by itself after a quarter of an hour without a request.
#
# Usage: start.sh PROGRAM LIBRARY SOCKET
set -u
"$(dirname -- "$0")/stop.sh" "$3"
# What starts it is no server.
setsid env CONTACT_FORK_SERVER="$3" LD_PRELOAD="$2" "$1" </dev/null >"$3.log" 2>&1 &
echo $! >"$3.pid"
tries=0
until [ -S "$3" ]; do
  tries=$((tries + 1))
  [ "$tries" -lt 600 ] || { cat "$3.log"; exit 1; }
  sleep 0.1
done
