#!/usr/bin/env bash
# Installs what is missing, builds Merker, and shows the sorting plant: its tests, what its inputs and outputs do over time
# when a small, a middle and a large box come along, and then the workbench with the plant in motion, until Ctrl-C.
#
#   ./run.sh                   all of it; options go to the workbench: ./run.sh --port 8090
#   ./run.sh --no-workbench    ends after the curves
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")"
. tools/packages.sh

need_packages $BUILD_PACKAGES
mkdir -p build
log=build/run.log

# How far the build is, as ninja counts it: on a terminal in one line.
progress() {
  tee "$log" | while IFS= read -r line; do
    case $line in
      \[*/*\]*) [ ! -t 1 ] || printf '\rbuilding: %s of %s ' "$(cut -d/ -f1 <<<"${line#[}")" "$(cut -d/ -f2 <<<"${line%%]*}")" ;;
    esac
  done
  [ ! -t 1 ] || printf '\n'
}

echo "building; the first time takes several minutes ($log)"
{ cmake --preset release && cmake --build --preset release --target merker -j "$(nproc)"; } 2>&1 | progress
[ "${PIPESTATUS[0]}" -eq 0 ] || { tail -n 40 "$log"; exit 1; }

merker=build/release/merker
plant=examples/sorting-plant
rows="E 0.0, E 0.1, E 0.2, A 1.0, A 1.1, A 1.2"

printf '\n== The sorting plant: all its scenarios, in virtual time\n\n'
result=0
"$merker" test "$plant" || result=$?

# The plant puts a box on its belt every ten seconds, one of each size. The run takes 32 s of virtual time.
"$merker" run "$plant" --for 32s \
  --trace build/plant.csv --watch "$rows" --print '"Plant data".Small, "Plant data".Middle, "Plant data".Large' \
  >build/plant.txt

printf '\n== Inputs and outputs over time, in seconds\n'
printf '   A light barrier is 0 while a box interrupts its beam; a slider is out while its output is 1.\n'
begin=2
for box in "A small box: slider small 3 s after it has left the barriers" \
  "A middle box: slider middle after 5 s" "A large box: slider large after 7 s"; do
  end=$((begin + 10))
  printf '\n-- %s\n\n' "$box"
  python3 -B tools/timeline build/plant.csv --rows "$rows" --names "$plant/sorting.sym" --step 200ms \
    --from $begin --to $end --changes
  begin=$end
done

printf '\n== Counted by the program\n\n'
cat build/plant.txt
[ "$result" -eq 0 ] && [ "${1:-}" != --no-workbench ] || exit "$result"

printf '\n== The workbench: open the address below, choose "Process"\n\n'
exec "$merker" run "$plant" "$@"
