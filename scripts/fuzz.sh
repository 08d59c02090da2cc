#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/fuzz.sh [RUNS] [READER ...]: feeds the readers with RUNS damaged files each (default 10,000,000) by libFuzzer, with
# the address and undefined-behaviour sanitizers. Without readers: all. What is found stands in build/fuzz/findings.
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
command -v clang++ >/dev/null 2>&1 || fail "clang++ is missing: apt-get install clang"
cd "$root"

runs=${1:-10000000}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- $(sed -n 's/^ *foreach(reader \(.*\))$/\1/p' tests/fuzz/CMakeLists.txt)
configure fuzz
cmake --build build/fuzz --target fuzz_tests "${@/%/_fuzzer}" || fail "the build failed (see above)"
# The test writes the seeds: small valid files of every format.
build/fuzz/tests/fuzz/fuzz_tests reader_mutation >build/fuzz/seeds.log || fail "the seeds could not be written (see build/fuzz/seeds.log)"
mkdir -p build/fuzz/findings
# Else undefined behaviour is only reported, and the program goes on.
export UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1:suppressions=$root/tests/sanitizers/undefined.txt"
# Short stacks of allocations and a small quarantine of freed memory: faster.
export ASAN_OPTIONS="malloc_context_size=2:quarantine_size_mb=16"
for reader; do
  corpus=build/fuzz/corpus/$reader
  mkdir -p "$corpus"
  # The entropic schedule counts the features of all inputs, a third of the time for readers as fast as these.
  "build/fuzz/tests/fuzz/${reader}_fuzzer" -runs="$runs" -entropic=0 -max_len=4096 -rss_limit_mb=4096 -timeout=20 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="build/fuzz/findings/$reader-" "$corpus" build/fuzz/test-output/fuzz/seeds >"build/fuzz/$reader.log" 2>&1 ||
    fail "a finding in the reader $reader: see build/fuzz/$reader.log and build/fuzz/findings"
  printf '%s: %s without a finding\n' "$reader" "$(sed -n 's/.*number_of_executed_units: *//p' "build/fuzz/$reader.log") files"
done
