#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/sanitize.sh [address] [threads]: builds with sanitizers and runs the tests (both without arguments).
#   address   addresses and undefined behaviour: all tests; leaks: the tests without the editor, whose OpenGL driver keeps
#             memory and is unloaded before the leaks are counted, so that nothing says it was the driver
#   threads   data races: the tests of core, and commands of goniotool with 1 to 64 threads (tests/attack). The tests of
#             goniotool start it by QProcess, whose vfork() this sanitizer does not support
# A finding fails its test, and its text stands in build/PRESET/sanitizer.log.*. Needs clang.
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
install_packages
command -v clang++ >/dev/null 2>&1 || fail "clang++ is missing: apt-get install clang"
cd "$root"

suppressions=$root/tests/sanitizers
editor="^(widgets|app/gonio)$"
display=(env LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1600x1000x24 -noreset")

# build PRESET: builds and removes the logs of the run before.
build() {
  configure "$1"
  cmake --build "build/$1" || fail "the build failed (see above)"
  rm -f "build/$1"/sanitizer.log.*
}

# test_with PRESET COMMAND...: COMMAND runs ctest.
test_with() {
  local preset=$1
  shift
  "$@" --test-dir "build/$preset" --output-on-failure --timeout 3000 -j 2 || failed="$failed $preset"
}
failed=
export QTEST_FUNCTION_TIMEOUT=3000000  # ms; five minutes without

[ $# -gt 0 ] || set -- address threads
for kind in "$@"; do
  case $kind in
    address)
      build asan
      options="detect_stack_use_after_return=1:log_path=$root/build/asan/sanitizer.log"
      export LSAN_OPTIONS="suppressions=$suppressions/leaks.txt:print_suppressions=0"
      export UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1:suppressions=$suppressions/undefined.txt"
      ASAN_OPTIONS="detect_leaks=1:$options" test_with asan ctest -LE "$editor"
      ASAN_OPTIONS="detect_leaks=0:$options" test_with asan "${display[@]}" ctest -L "$editor"
      ;;
    threads)
      export TSAN_OPTIONS="halt_on_error=1:suppressions=$suppressions/threads.txt:log_path=$root/build/tsan/sanitizer.log"
      build tsan
      test_with tsan ctest -LE '^app/goniotool$'
      tests/attack/attack.py build/tsan/app/goniotool/goniotool build/tsan/test-output/fuzz/seeds threads || failed="$failed tsan"
      ;;
    *) fail "unknown: $kind (address or threads)" ;;
  esac
done
[ -z "$failed" ] || fail "tests failed with sanitizers:$failed (see above and build/PRESET/sanitizer.log.*)"
