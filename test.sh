#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. The last line is "N passed, N failed", the sum of all parts;
# the exit code is 1 if anything failed.
#
#   ./test.sh              all tests, the stored inputs of the fuzzers among them
#   ./test.sh --fuzz 60    then 60 seconds of new inputs for each fuzzer (clang)
set -u
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 1
. tools/packages.sh

fuzz_seconds=0
if [ "${1:-}" = --fuzz ] && [[ "${2:-}" =~ ^[0-9]+$ ]]; then
  fuzz_seconds=$2
elif [ $# -gt 0 ]; then
  echo "usage: ./test.sh [--fuzz SECONDS]" >&2
  exit 2
fi

export GTEST_BRIEF=1  # a test program of hundreds of tests says which one failed, and no more
jobs=$(nproc)
passed=0
failed=0
failures=()

say() { printf '\n==> %s [%d s]\n' "$1" "$SECONDS"; }

count() {  # count PASSED FAILED NAME
  passed=$((passed + $1))
  failed=$((failed + $2))
  [ "$2" -eq 0 ] || failures+=("$3")
}

# One step that either works or does not.
step() {  # step NAME COMMAND...
  local name=$1
  shift
  say "$name"
  if "$@"; then count 1 0 "$name"; else count 0 1 "$name"; return 1; fi
}

build() {  # build PRESET OPTIONS...
  local preset=$1
  shift
  cmake --preset "$preset" "$@" >"build/$preset.configure.log" 2>&1 || { cat "build/$preset.configure.log"; return 1; }
  cmake --build --preset "$preset" -j "$jobs"
}

# Browsers and the PLC they watch wait most of their time: a build beside them takes what they leave, and no more.
begin_build() {  # begin_build PRESET
  setsid nice -n 19 bash -c "$(declare -f build); jobs=$jobs; build $1" >"build/$1.build.log" 2>&1 &
  beside=$!
  trap 'kill -- "-$beside" 2>/dev/null; kill -CONT -- "-$beside" 2>/dev/null' EXIT
}

end_build() {  # end_build PRESET
  tail -n +1 --pid="$beside" -f "build/$1.build.log"
  wait "$beside"
}

# "98% tests passed, 1 tests failed out of 50" as "1 50".
failed_of() { sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$1" | tail -n 1; }

run_ctest() {  # run_ctest NAME PRESET JOBS
  say "$1"
  local log="build/$2.ctest.log" summary hasty again=0
  # No test may hang the run. The conformance programs run once, counted below.
  ctest --preset "$2" -E '^conformance$' --output-on-failure --timeout 600 -j "$3" 2>&1 | tee "$log"
  summary=$(failed_of "$log")
  if [ -z "$summary" ]; then count 0 1 "$1"; return 1; fi
  # A browser that shares two processors with compilers may be late for a key. Whether that was all is seen when it is
  # alone, once: the build beside it stands still. It is told all the same.
  hasty=$(sed -nE 's/^[[:space:]]+[0-9]+ - (browser_[a-z_]+) .*/\1/p' "$log" | paste -sd '|')
  if [ -n "$hasty" ]; then
    say "failed beside other work, once more alone: $hasty"
    kill -STOP -- "-$beside" 2>/dev/null
    ctest --preset "$2" -R "^($hasty)\$" --output-on-failure --timeout 600 2>&1 | tee "$log.again"
    kill -CONT -- "-$beside" 2>/dev/null
    again=$(failed_of "$log.again")
    again=${again:-1 1}  # nothing was said: none passed
    again=$((${again#* } - ${again% *}))
  fi
  set -- "$1" ${summary}
  count $(($3 - $2 + again)) $(($2 - again)) "$1"
}

# A program whose last line is "N passed, N failed".
counted() {  # counted NAME COMMAND...
  local name=$1 log="build/counted.log" summary code
  shift
  say "$name"
  "$@" | tee "$log"
  code=${PIPESTATUS[0]}
  summary=$(tail -n 1 "$log" | sed -nE 's/^([0-9]+) passed, ([0-9]+) failed$/\1 \2/p')
  if [ -z "$summary" ]; then count 0 1 "$name: no summary (exit code $code)"; return 1; fi
  set -- ${summary}
  count "$1" "$2" "$name"
  if [ "$code" -ne 0 ] && [ "$2" -eq 0 ]; then count 0 1 "$name: exit code $code"; fi
}

# New inputs, beginning with the stored ones.
fuzz() {
  local program name corpus
  need_packages $FUZZ_PACKAGES || { count 0 1 "fuzzers: packages"; return 1; }
  step "fuzzers: build" build fuzz || return 1
  for program in build/fuzz/fuzz/fuzz_*; do
    [ -f "$program" ] && [ -x "$program" ] || continue
    name=$(basename "$program")
    say "$name"
    corpus=$(mktemp -d)
    if "$program" -max_total_time="$fuzz_seconds" -timeout=10 -artifact_prefix=build/fuzz/ "$corpus" \
        "tests/corpus/${name#fuzz_}" >"build/fuzz/$name.log" 2>&1; then
      tail -n 1 "build/fuzz/$name.log"
      count 1 0 "$name"
    else
      tail -n 40 "build/fuzz/$name.log"
      count 0 1 "$name"
    fi
    rm -rf "$corpus"
  done
}

say "packages"
need_packages $BUILD_PACKAGES $CHECK_PACKAGES || { echo "0 passed, 1 failed"; exit 1; }
mkdir -p build

step "format" tools/format --check
# The tests of the modules run once, with sanitizers.
step "release build" build release -DMERKER_UNIT_TESTS=OFF
released=$?
begin_build debug
if [ "$released" -eq 0 ]; then
  # One test more than processors, here and below: most of these wait.
  run_ctest "release: architecture, documents, differential tests, command line, page and browser" release $((jobs + 1))
  counted "examples" build/release/merker test examples
  counted "conformance programs" python3 -B tests/conformance/run.py build/release/merker
fi
if step "debug build with sanitizers" end_build debug; then
  run_ctest "debug with sanitizers: unit tests, stored fuzzer inputs, command line" debug $((jobs + 1))
fi
[ "$fuzz_seconds" -eq 0 ] || fuzz

say "done"
[ ${#failures[@]} -eq 0 ] || printf 'failed: %s\n' "${failures[@]}"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
