#!/usr/bin/env bash
# Installs what is missing, builds Merker, and shows the sorting plant: its tests, and what its inputs and outputs do over
# time when a small, a middle and a large box come along.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")"
. tools/packages.sh

need_packages $BUILD_PACKAGES
mkdir -p build
log=build/run.log
echo "building (a minute or two the first time; $log) ..."
{ cmake --preset release && cmake --build --preset release --target merker -j "$(nproc)"; } >"$log" 2>&1 ||
  { tail -n 40 "$log"; exit 1; }

merker=build/release/merker
[ -x "$merker" ] || merker=build/release/apps/merker/merker
plant=examples/sorting-plant
rows="E 0.0, E 0.1, E 0.2, A 1.0, A 1.1, A 1.2"

printf '\n== The sorting plant: all scenarios, in virtual time\n\n'
"$merker" test "$plant"

for size in small middle large; do
  printf '\n== A %s box: a light barrier is 0 while its beam is interrupted, a slider is out while its output is 1\n\n' "$size"
  "$merker" test "$plant" --filter "a $size box is pushed out" --trace "build/$size.csv" --watch "$rows" >/dev/null
  python3 tools/timeline "build/$size.csv" --rows "$rows" --names "$plant/sorting.sym" --step 200ms --to 11 --changes
done
