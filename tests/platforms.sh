#!/bin/sh
# The same digits with every deal.II that Debian has: in a chroot of each release,
# with nothing in it but what ./run installs, modelings A to G and, without
# --cases, the tests of the Release build; then a table of what was there, what
# passed, and how far the results are from those of the first release. --table:
# only the table, of what earlier calls left in DIRECTORY.
#   platforms.sh [--cases | --table] DIRECTORY [RELEASE...]
# RELEASE: bookworm, trixie and sid without. As root, with debootstrap and some
# 5 GB in DIRECTORY for each; where a chroot is there already, it is used again.
# The last commit is tested. Mirrors and proxies are those of this
# machine's apt; CMAKE_BUILD_PARALLEL_LEVEL limits the compilers at once. Exit
# status: 0 if all passes, with the same digits in the tables.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
reference=${REFERENCE_DIRECTORY:-$here/../shared/reference}
what=all
case "${1-}" in
  --cases | --table)
    what=${1#--}
    shift
    ;;
esac
if [ $# -eq 0 ]; then
  sed -n '2,/^# SPDX/{/SPDX/d;s/^# \{0,1\}//p;}' "$0"
  exit 2
fi
mkdir -p "$1"
directory=$(CDPATH='' cd -- "$1" && pwd)
shift
[ $# -gt 0 ] || set -- bookworm trixie sid

# mirror RELEASE: the first of the archives that apt has here with this release
mirror() {
  # shellcheck disable=SC2016
  for site in $(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' |
                sort -u); do
    if /usr/lib/apt/apt-helper download-file "$site/dists/$1/Release" \
         "$directory/$1.Release" >/dev/null 2>&1 &&
       grep -qx 'Label: Debian' "$directory/$1.Release"; then
      echo "$site"
      return
    fi
  done
  echo "no archive in the sources of apt has the release $1" >&2
  return 1
}

# new_chroot RELEASE: with apt set up as it is here. A mirror may be a copy that
# is no longer renewed, and then older than its own date allows; and dpkg need not
# bring each file to the disk before the next one.
new_chroot() {
  root=$directory/$1
  site=$(mirror "$1")
  proxy=$(apt-config dump Acquire::http::Proxy | cut -d '"' -f 2)
  http_proxy=${http_proxy:-$proxy} \
    debootstrap --variant=minbase --include=ca-certificates "$1" "$root.part" \
    "$site" >"$directory/$1.debootstrap.log"
  {
    apt-config dump | grep -E '^Acquire::(https?|Retries)' || true
    echo 'Acquire::Check-Valid-Until "false";'
    echo 'Acquire::Check-Date "false";'
  } >"$root.part/etc/apt/apt.conf.d/90platforms"
  echo force-unsafe-io >"$root.part/etc/dpkg/dpkg.cfg.d/platforms"
  mv "$root.part" "$root"
}

# inside RELEASE COMMAND: in its chroot; processes and mounts end with it.
inside() {
  jobs=${CMAKE_BUILD_PARALLEL_LEVEL-}
  # shellcheck disable=SC2016
  env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+"http_proxy=$http_proxy"} \
    ${https_proxy:+"https_proxy=$https_proxy"} \
    ${jobs:+"CMAKE_BUILD_PARALLEL_LEVEL=$jobs"} \
    unshare --mount --pid --fork --kill-child sh -c '
      mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" &&
      mount --rbind /sys "$0/sys" &&
      exec chroot "$0" sh -c "cd /root/contact && $1"' "$directory/$1" "$2"
}

# copy_sources RELEASE: the last commit, and the reference meshes where they are
copy_sources() {
  root=$directory/$1/root
  rm -rf "$root/contact" "$root/shared"
  mkdir -p "$root/contact" "$root/shared"
  git -C "$here" archive HEAD | tar -x -C "$root/contact"
  if [ -d "$reference" ]; then
    cp -r "$reference" "$root/shared/reference"
  fi
}

# on RELEASE: its results into DIRECTORY/RELEASE.*
on() {
  [ -d "$directory/$1" ] || new_chroot "$1"
  copy_sources "$1"
  rm -rf "$directory/$1".cases* "$directory/$1".tests*
  status=0
  inside "$1" ./run >"$directory/$1.cases.log" 2>&1 || status=$?
  echo "$status" >"$directory/$1.cases.status"
  cp -r "$directory/$1/root/contact/output" "$directory/$1.cases"
  # shellcheck disable=SC2016
  inside "$1" 'dpkg-query -W -f "\${source:Upstream-Version} " libdeal.ii-dev \
    libtrilinos-ml-dev; g++ -dumpfullversion' >"$directory/$1.cases.versions"
  [ "$what" = all ] || return 0
  status=0
  inside "$1" './run test release' >"$directory/$1.tests.log" 2>&1 || status=$?
  echo "$status" >"$directory/$1.tests.status"
}

if [ "$what" != table ]; then
  for release in "$@"; do
    echo "$release ..." >&2
    on "$release"
  done
fi

exec python3 - "$directory" "$@" <<'PYTHON'
import glob, json, pathlib, re, sys
directory, releases = pathlib.Path(sys.argv[1]), sys.argv[2:]

def text(release, kind):
    file = directory / f"{release}.{kind}"
    return file.read_text().strip() if file.exists() else ""

def table(release):
    """Case, probe and computed value as ./run prints them."""
    return [line.split("|")[:4] for line in
            text(release, "cases.log").splitlines()
            if re.match(r"ssnp154_\w +\|", line)]

def numbers(release):
    """Name -> all digits, of probes, contact and works."""
    found = {}
    for name in sorted(glob.glob(f"{directory}/{release}.cases/*/summary.json")):
        summary = json.load(open(name))
        values = {p["name"]: p["value"] for p in summary["probes"]}
        values |= summary["contact"] | summary["increments"][-1]["works"]
        found |= {(pathlib.Path(name).parent.name, key): value
                  for key, value in values.items()}
    return found

def tests(release):
    """Passed of all, and what did not."""
    log = text(release, "tests.log")
    counted = re.search(r"(\d+) tests failed out of (\d+)", log)
    if not counted:
        return "ended with " + text(release, "tests.status") if log else "not run"
    failed = re.findall(r"^\s*\d+ - (\S+) \(", log, re.M)
    n, all_of_them = map(int, counted.groups())
    return f"{all_of_them - n} of {all_of_them}" + "".join(
        f", not {name}" for name in failed)

first, reference = table(releases[0]), numbers(releases[0])
good = len(first) == 14
print("| release | deal.II | Trilinos | g++ | values | same digits as "
      f"{releases[0]} | largest relative difference | tests |")
print("|---|---|---|---|---|---|---|---|")
for release in releases:
    rows, values = table(release), numbers(release)
    same = sum(a == b for a, b in zip(rows, first))
    worst = max((abs(values.get(key, 1e300) - value) / max(abs(value), 1e-3)
                 for key, value in reference.items()), default=1e300)
    good &= (same == len(rows) == len(first) and text(release, "cases.status")
             == "0" and text(release, "tests.status") in ("", "0"))
    versions = (text(release, "cases.versions").split() + ["?"] * 3)[:3]
    print(f"| {release} | " + " | ".join(versions) +
          f" | {len(rows)} | {same} | {worst:.1e} | {tests(release)} |")
sys.exit(not good)
PYTHON
