#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/sanitize.sh [address] [threads]: builds with sanitizers and runs the tests (both without arguments).
#   address   addresses and undefined behaviour: all tests, those of the editor included
#   threads   data races: the tests of core and goniotool
# A finding fails its test, and its text stands in build/PRESET/sanitizer.log.*.
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
install_packages
cd "$root"

suppressions=$root/tests/sanitizers
display=(env LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1600x1000x24")

# test_with PRESET COMMAND...: COMMAND runs ctest; the logs of the preset's build folder are removed before.
test_with() {
  local preset=$1
  shift
  configure "$preset"
  cmake --build "build/$preset" || fail "the build failed (see above)"
  rm -f "build/$preset"/sanitizer.log.*
  "$@" --test-dir "build/$preset" --output-on-failure --timeout 3000 -j 2 ||
    fail "tests failed with sanitizers (see above and build/$preset/sanitizer.log.*)"
}

[ $# -gt 0 ] || set -- address threads
for kind in "$@"; do
  case $kind in
    address)
      export ASAN_OPTIONS="detect_leaks=1:detect_stack_use_after_return=1:log_path=$root/build/asan/sanitizer.log"
      export LSAN_OPTIONS="suppressions=$suppressions/leaks.txt:print_suppressions=0"
      export UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1"
      test_with asan "${display[@]}" ctest
      ;;
    threads)
      export TSAN_OPTIONS="halt_on_error=1:suppressions=$suppressions/threads.txt:log_path=$root/build/tsan/sanitizer.log"
      test_with tsan ctest
      ;;
    *) fail "unknown: $kind (address or threads)" ;;
  esac
done
