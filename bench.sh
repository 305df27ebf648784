#!/usr/bin/env bash
# Builds the benchmarks and prints each figure beside the value that is required. Exit code 1 if one is missed.
# Arguments go to Google Benchmark: ./bench.sh --benchmark_filter=Instructions
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")"
. tools/packages.sh

need_packages $BUILD_PACKAGES libbenchmark-dev
mkdir -p build
log=build/bench.log
echo "building ($log) ..." >&2
{ cmake --preset bench -DMERKER_TESTS=OFF && cmake --build --preset bench --target merker_bench -j "$(nproc)"; } >"$log" 2>&1 ||
  { tail -n 40 "$log"; exit 1; }
exec build/bench/bench/merker_bench "$@"
